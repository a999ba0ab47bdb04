// Constant shear strength of a junction: |t| <= tau wherever the surfaces touch. Bowden & Tabor (1950). tau
// [Pa].
// At its edge, where the pressure vanishes, it is |t| <= m p with m = 2: shear of bodies with different
// moduli changes the pressure by beta t (beta: Dundurs' constant, up to 0.5), so that with a jump an edge
// node that shears may open and one that does not may close, and no equilibrium exists.
#pragma once

#include <algorithm>

#include "fem/interface/friction_law.h"

namespace asperity::fem {

class ShearStrength : public FrictionLaw {
 public:
  /// strength tau [Pa].
  explicit ShearStrength(double strength) : strength_(strength) {}
  ShearLimit limit(const InterfacePoint& point, const double*) const override {
    return at_edge(point.pressure, {strength_, 0});
  }

  /// The limit of an intimate contact [Pa], at most growing with the pressure as it can at an edge.
  static ShearLimit at_edge(double pressure, const ShearLimit& inside) {
    constexpr double steepest_growth = 2;
    const double most = steepest_growth * std::max(0.0, pressure);
    return most < inside.stress ? ShearLimit{most, steepest_growth} : inside;
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
      "|t| <= min(tau, 2 p)",
      "Bowden & Tabor (1950)",
      "where the mesh resolves the junctions, down to their intimate contact, whose pressure is well above "
      "tau/2",
      {ShearStrength::parameter()}},
     [](const LawValues& values) -> std::unique_ptr<FrictionLaw> {
       return std::make_unique<ShearStrength>(values.at("Shear strength"));
     }}};

}  // namespace asperity::fem
