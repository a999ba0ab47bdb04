// Rolling resistance from the energy that a deforming solid does not give back (Tabor 1955; Johnson 1985,
// sec. 9.2):
//   M = (3/16) alpha P a,   alpha: loss over the elastic energy that the front half of the contact puts in.
// A source of the rolling coefficient with lambda = a: mu = 3 alpha/16. Hertzian contact; alpha is measured,
// not derived, and is near zero for glass and silicon below yield. SI units.
#pragma once

#include <algorithm>

#include "dem_compare/laws/rotation_fields.h"

namespace asperity {

struct HysteresisRolling {
  double loss_factor = 0;  ///< alpha [-]
  RotationalStiffness stiffness{};
  static constexpr LengthScale length = LengthScale::particle_radius;

  /// Moment [N m] at a force [N] and a contact radius [m].
  double moment(double normal_force, double contact_radius) const {
    return 3.0 / 16 * loss_factor * normal_force * contact_radius;
  }
  double limit(const NormalState& normal, double) const {
    return std::max(0.0, moment(normal.force, normal.contact_radius));
  }
};

inline const LawEntry<HysteresisRolling, RollingMode> hysteresis_rolling_entry{
    {"hysteresis_rolling", "M = 3/16 alpha P a", "Tabor 1955; Johnson 1985, sec. 9.2",
     "Hertzian contact; alpha is measured at the rate of rolling"},
    {{{"loss_factor", "", "alpha, part of the energy lost", 0, 1}, &HysteresisRolling::loss_factor}},
    spring_fields<HysteresisRolling>()};

}  // namespace asperity
