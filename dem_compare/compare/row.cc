#include "dem_compare/compare/row.h"

namespace asperity {

const char* mode_name(Mode mode) {
  switch (mode) {
    case Mode::normal:
      return "normal";
    case Mode::sliding:
      return "sliding";
    case Mode::rolling:
      return "rolling";
    case Mode::torsion:
      return "torsion";
    case Mode::rail:
      return "rail";
  }
  return "";
}

const QuantityDisplay& display_of(Quantity quantity) {
  static const std::vector<QuantityDisplay> displays{
      {Quantity::approach, Mode::normal, "approach", "approach", "m", "nm", 1e-9},
      {Quantity::normal_stiffness, Mode::normal, "normal_stiffness", "normal stiffness", "N/m", "kN/m", 1e3},
      {Quantity::lateral_stiffness, Mode::sliding, "lateral_stiffness", "lateral stiffness from rest", "N/m", "kN/m", 1e3},
      {Quantity::lateral_stiffness_to_sliding, Mode::sliding, "lateral_stiffness_to_sliding", "lateral stiffness up to sliding",
       "N/m", "kN/m", 1e3},
      {Quantity::sliding_friction, Mode::sliding, "sliding_friction", "sliding force over load", "", "", 1},
      {Quantity::rolling_stiffness, Mode::rolling, "rolling_stiffness", "rolling stiffness", "N m/rad", "nN m/rad", 1e-9},
      {Quantity::rolling_friction, Mode::rolling, "rolling_friction", "rolling moment over load and radius", "", "×10⁻³", 1e-3},
      {Quantity::torsion_stiffness, Mode::torsion, "torsion_stiffness", "torsion stiffness", "N m/rad", "nN m/rad", 1e-9},
      {Quantity::torsion_friction, Mode::torsion, "torsion_friction", "torsion moment over load and radius", "", "×10⁻³", 1e-3},
      {Quantity::rail_friction, Mode::rail, "rail_friction", "rail coefficient", "", "×10⁻³", 1e-3},
  };
  return displays[static_cast<std::size_t>(quantity)];
}

Uncertain ratio(const ComparedValue& value, const ComparedValue& over) {
  if (!value.known() || !over.known() || over.value == 0) return {NAN, NAN};
  return propagate([](const std::vector<double>& x) { return x[0] / x[1]; }, {{value.value, value.sd}, {over.value, over.sd}});
}

}  // namespace asperity
