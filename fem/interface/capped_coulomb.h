// Coulomb friction up to a shear strength: |t| <= min(mu p, tau). Orowan (1943). mu [-], p and tau [Pa].
#pragma once

#include <algorithm>

#include "fem/interface/friction_law.h"

namespace asperity::fem {

class CappedCoulomb : public FrictionLaw {
 public:
  CappedCoulomb(double coefficient, double strength) : coefficient_(coefficient), strength_(strength) {}
  double limit(double pressure) const override { return std::min(coefficient_ * pressure, strength_); }

  static FrictionLawEntry entry() {
    return {"Capped Coulomb", "|t| <= min(mu p, tau)", "Orowan (1943)", "Friction coefficient mu [-], Shear strength tau [Pa]",
            "pressures up to the hardness, where friction can no longer grow with the pressure",
            [](const InterfaceInput& i) { return i.friction_coefficient > 0 && i.shear_strength > 0; },
            [](const InterfaceInput& i) -> std::unique_ptr<FrictionLaw> {
              return std::make_unique<CappedCoulomb>(i.friction_coefficient, i.shear_strength);
            }};
  }

 private:
  double coefficient_, strength_;
};

}  // namespace asperity::fem
