// Constant shear strength of a junction: |t| <= tau wherever the surfaces touch. Bowden & Tabor (1950). tau [Pa].
#pragma once

#include "fem/interface/friction_law.h"

namespace asperity::fem {

class ShearStrength : public FrictionLaw {
 public:
  explicit ShearStrength(double strength) : strength_(strength) {}
  double limit(double pressure) const override { return pressure > 0 ? strength_ : 0.0; }

  static FrictionLawEntry entry() {
    return {"Shear strength", "|t| <= tau where p > 0", "Bowden & Tabor (1950)", "Shear strength tau [Pa]",
            "where the mesh resolves the junctions, down to their intimate contact",
            [](const InterfaceInput& i) { return i.friction_coefficient == 0 && i.shear_strength > 0; },
            [](const InterfaceInput& i) -> std::unique_ptr<FrictionLaw> { return std::make_unique<ShearStrength>(i.shear_strength); }};
  }

 private:
  double strength_;
};

}  // namespace asperity::fem
