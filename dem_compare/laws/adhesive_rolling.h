// Rolling resistance of a JKR contact whose edge does not follow at once (Dominik & Tielens 1995):
//   M = 4 F_c (a/a0)^(3/2) xi   at the shift xi of the contact at which the edge gives way; a0: radius at
//   zero load,
// and from the work of adhesion that opening takes over what closing gave (Kendall 1975; Johnson 1985):
//   F = 2 a dw.
// Sources of the rolling adhesion h: neither vanishes with the load. xi is of atomic size (0.2 to 1 nm) and
// not known better; for the paper's sphere both give some nN, less than a hundredth of the rolling forces it
// measured. SI units.
#pragma once

#include "dem_compare/laws/jkr.h"
#include "dem_compare/laws/rotation_fields.h"

namespace asperity {

struct AdhesiveRolling {
  Jkr contact;
  double critical_shift = 0;       ///< xi [m]
  double adhesion_hysteresis = 0;  ///< dw = w_opening - w_closing [J/m^2]
  RotationalStiffness stiffness{};
  static constexpr LengthScale length = LengthScale::particle_radius;

  /// Limit of the rolling moment from the pinned edge [N m].
  double pinning_moment(double normal_force) const {
    if (contact.pull_off_force() == 0) return 0;
    const double ratio = contact.radius_at_force(normal_force) / contact.radius_at_force(0);
    return 4 * contact.pull_off_force() * std::pow(ratio, 1.5) * critical_shift;
  }
  /// Force at the sphere's centre from adhesion hysteresis [N].
  double hysteresis_force(double normal_force) const {
    return 2 * contact.radius_at_force(normal_force) * adhesion_hysteresis;
  }
  /// Of both about the contact, at loads that the contact can carry [N m].
  double limit(const NormalState& normal, double lever) const {
    const double force = std::max(normal.force, -contact.pull_off_force());
    return pinning_moment(force) + hysteresis_force(force) * lever;
  }
};

inline const LawEntry<AdhesiveRolling, RollingMode> adhesive_rolling_entry{
    {"adhesive_rolling", "M = 4 F_c (a/a0)^(3/2) xi + 2 a dw r", "Dominik & Tielens 1995; Kendall 1975",
     "JKR's range; smooth surfaces"},
    {{{"reduced_modulus", "Pa", "E*"}, &AdhesiveRolling::contact, &Jkr::reduced_modulus},
     {{"radius", "m", "R"}, &AdhesiveRolling::contact, &Jkr::radius},
     {{"work_of_adhesion", "J/m^2", "w of both surfaces together"},
      &AdhesiveRolling::contact,
      &Jkr::work_of_adhesion},
     {zero_otherwise({"critical_shift", "m", "xi at which the contact's edge gives way"}),
      &AdhesiveRolling::critical_shift},
     {zero_otherwise({"adhesion_hysteresis", "J/m^2", "dw, opening minus closing"}),
      &AdhesiveRolling::adhesion_hysteresis}},
    spring_fields<AdhesiveRolling>()};

}  // namespace asperity
