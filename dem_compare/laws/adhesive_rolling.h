// Rolling resistance of a JKR contact whose edge does not follow at once (Dominik & Tielens 1995):
//   M = 4 F_c (a/a0)^(3/2) xi   at the shift xi of the contact at which the edge gives way; a0: radius at zero load,
// and from the work of adhesion that opening takes over what closing gave (Kendall 1975; Johnson 1985):
//   F = 2 a dw.
// Sources of the rolling adhesion h: neither vanishes with the load. xi is of atomic size (0.2 to 1 nm) and not known better;
// for the paper's sphere both give some nN, less than a hundredth of the rolling forces it measured. SI units.
#pragma once

#include "dem_compare/laws/jkr.h"

namespace asperity {

struct AdhesiveRolling {
  Jkr contact;
  double critical_shift = 0;       ///< xi [m]
  double adhesion_hysteresis = 0;  ///< dw = w_opening - w_closing [J/m^2]

  /// Limit of the rolling moment from the pinned edge [N m].
  double pinning_moment(double normal_force) const {
    const double ratio = contact.radius_at_force(normal_force) / contact.radius_at_force(0);
    return 4 * contact.pull_off_force() * std::pow(ratio, 1.5) * critical_shift;
  }
  /// Force at the sphere's centre from adhesion hysteresis [N].
  double hysteresis_force(double normal_force) const {
    return 2 * contact.radius_at_force(normal_force) * adhesion_hysteresis;
  }
};

inline const LawEntry<AdhesiveRolling> adhesive_rolling_entry{
    {"adhesive_rolling", "rolling", "M = 4 F_c (a/a0)^(3/2) xi; F = 2 a dw", "Dominik & Tielens 1995; Kendall 1975",
     "JKR's range; smooth surfaces", {}},
    {{{"critical_shift", "m", "xi at which the contact's edge gives way"}, &AdhesiveRolling::critical_shift},
     {{"adhesion_hysteresis", "J/m^2", "dw, opening minus closing"}, &AdhesiveRolling::adhesion_hysteresis}}};

}  // namespace asperity
