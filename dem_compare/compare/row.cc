#include "dem_compare/compare/row.h"

namespace asperity {

const QuantityDisplay& display_of(Quantity quantity) {
  static const std::vector<QuantityDisplay> displays{
      {Quantity::approach, Motion::normal, "approach", "approach", "m", "nm", 1e-9},
      {Quantity::normal_stiffness, Motion::normal, "normal_stiffness", "normal stiffness", "N/m", "kN/m",
       1e3},
      {Quantity::lateral_stiffness, Motion::sliding, "lateral_stiffness", "lateral stiffness from rest",
       "N/m", "kN/m", 1e3},
      {Quantity::lateral_stiffness_to_sliding, Motion::sliding, "lateral_stiffness_to_sliding",
       "lateral stiffness up to sliding", "N/m", "kN/m", 1e3},
      {Quantity::sliding_friction, Motion::sliding, "sliding_friction", "sliding force over load", "", "", 1},
      {Quantity::rolling_stiffness, Motion::rolling, "rolling_stiffness", "rolling stiffness", "N m/rad",
       "nN m/rad", 1e-9},
      {Quantity::rolling_friction, Motion::rolling, "rolling_friction", "rolling moment over load and radius",
       "", "×10⁻³", 1e-3},
      {Quantity::torsion_stiffness, Motion::torsion, "torsion_stiffness", "torsion stiffness", "N m/rad",
       "nN m/rad", 1e-9},
      {Quantity::torsion_friction, Motion::torsion, "torsion_friction", "torsion moment over load and radius",
       "", "×10⁻³", 1e-3},
      {Quantity::rail_friction, Motion::rail, "rail_friction", "rail coefficient", "", "×10⁻³", 1e-3},
      {Quantity::rail_force, Motion::rail, "rail_force", "rail force over load", "", "×10⁻³", 1e-3},
  };
  return displays[static_cast<std::size_t>(quantity)];
}

Uncertain ratio(const ComparedValue& value, const ComparedValue& over) {
  if (!value.known() || !over.known() || over.value == 0) return {NAN, NAN};
  return propagate([](const std::vector<double>& x) { return x[0] / x[1]; },
                   {{value.value, value.sd}, {over.value, over.sd}});
}

}  // namespace asperity
