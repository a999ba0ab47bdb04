// Coulomb friction: |t| <= mu p. Amontons (1699), Coulomb (1785). p: contact pressure [Pa], mu: coefficient [-].
// Taken at the scale of one node: asperities finer than the mesh are inside mu.
#pragma once

#include "fem/interface/friction_law.h"

namespace asperity::fem {

class Coulomb : public FrictionLaw {
 public:
  explicit Coulomb(double coefficient) : coefficient_(coefficient) {}
  double limit(double pressure) const override { return coefficient_ * pressure; }

  static FrictionLawEntry entry() {
    return {"Coulomb", "|t| <= mu p", "Coulomb (1785)", "Friction coefficient mu [-]",
            "where real contact grows in proportion to the load at scales below the mesh",
            [](const InterfaceInput& i) { return i.friction_coefficient > 0 && i.shear_strength == 0; },
            [](const InterfaceInput& i) -> std::unique_ptr<FrictionLaw> { return std::make_unique<Coulomb>(i.friction_coefficient); }};
  }

 private:
  double coefficient_;
};

}  // namespace asperity::fem
