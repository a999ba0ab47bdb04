// Constant shear strength of a junction: |t| <= tau wherever the surfaces touch. Bowden & Tabor (1950). tau
// [Pa].
#pragma once

#include "fem/interface/friction_law.h"

namespace asperity::fem {

class ShearStrength : public FrictionLaw {
 public:
  /// strength tau [Pa].
  explicit ShearStrength(double strength) : strength_(strength) {}
  ShearLimit limit(const InterfacePoint& point, const double*) const override {
    return {point.pressure > 0 ? strength_ : 0.0, 0};
  }

  static ParameterEntry parameter() {
    return {"Shear strength",
            {"tau"},
            Dimension::pressure,
            "Largest local shear traction; 0: no such limit.",
            "0 Pa"};
  }

 private:
  double strength_;
};

inline const Registered<FrictionLawDeclaration> shear_strength_law{
    {{"Shear strength",
      "|t| <= tau where p > 0",
      "Bowden & Tabor (1950)",
      "where the mesh resolves the junctions, down to their intimate contact",
      {ShearStrength::parameter()}},
     [](const LawValues& values) -> std::unique_ptr<FrictionLaw> {
       return std::make_unique<ShearStrength>(values.at("Shear strength"));
     }}};

}  // namespace asperity::fem
