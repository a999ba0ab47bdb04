#include "dem_compare/laws/rail_balance.h"

#include <cmath>

namespace asperity {

double rail_friction(double angle, const RailFriction& friction) {
  const double c = std::cos(angle), s = std::sin(angle);
  return (2 * c * friction.rolling + s * friction.torsion) / (1 + c);
}

double rail_offset(double angle, const RailFriction& friction) {
  const double c = std::cos(angle), s = std::sin(angle);
  return ((0.5 + c) * friction.rolling * friction.rolling_offset +
          s * friction.torsion * friction.torsion_offset) /
         (rail_friction(angle, friction) * (1 + c));
}

double torsion_from_rail(double angle, double rail_friction, double rolling) {
  const double c = std::cos(angle);
  return (rail_friction * (1 + c) - 2 * c * rolling) / std::sin(angle);
}

double torsion_offset_from_rail(double angle, double rail_friction, double rail_offset,
                                const RailFriction& friction) {
  const double c = std::cos(angle);
  return (rail_offset * rail_friction * (1 + c) - (0.5 + c) * friction.rolling * friction.rolling_offset) /
         (std::sin(angle) * friction.torsion);
}

double torsion_force(double angle, double lateral_force, double normal_force, double rolling,
                     double rolling_offset) {
  const double c = std::cos(angle);
  return (2 * (1 + c) * lateral_force - 4 * c * rolling * normal_force -
          (1 + 2 * c) * rolling * rolling_offset) /
         (2 * std::sin(angle));
}

}  // namespace asperity
