// Hertz' contact with a constant attraction (the simple law of Fuchs, Weinhart et al. 2014, eq. normal):
//   f_n = (4/3) E* R^(1/2) delta^(3/2) - h,   a = (R delta)^(1/2),   f_n = 0 for delta <= 0.
// Not valid where the attraction changes the contact radius by itself (JKR's range, Tabor parameter above 1),
// nor out of contact: the attraction has no reach. h = 0 is Hertz. SI units.
#pragma once

#include "core/hertz.h"
#include "dem_compare/laws/law_registry.h"
#include "dem_compare/laws/normal_state.h"

namespace asperity {

struct HertzOffset {
  double reduced_modulus = 0;  ///< E* [Pa]
  double radius = 0;           ///< R [m]
  double adhesion_force = 0;   ///< h [N]

  NormalState advance(const NormalState&, double approach) const {
    if (approach <= 0) return {approach, 0, 0, 0, false};
    const double a = std::sqrt(radius * approach);
    return {approach, hertz().force(approach) - adhesion_force, a, 2 * reduced_modulus * a, true};
  }
  /// Approach at which the force is reached; needs force >= -adhesion_force.
  double approach(double force) const { return hertz().approach(force + adhesion_force); }
  Hertz hertz() const { return {reduced_modulus, radius}; }
};

inline const LawEntry<HertzOffset, NormalMode> hertz_offset_entry{
    {"hertz", "f_n = 4/3 E* R^(1/2) delta^(3/2) - h, a = (R delta)^(1/2)",
     "Hertz 1882; Johnson 1985, ch. 4; constant attraction h: Fuchs, Weinhart et al. 2014",
     "a << R, elastic, smooth; h changes no contact radius and has no reach out of contact"},
    {{{"reduced_modulus", "Pa", "E*"}, &HertzOffset::reduced_modulus},
     {{"radius", "m", "R"}, &HertzOffset::radius},
     {zero_otherwise({"adhesion_force", "N", "constant attraction h"}), &HertzOffset::adhesion_force}}};

}  // namespace asperity
