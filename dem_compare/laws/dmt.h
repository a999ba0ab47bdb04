// Adhesive contact with attraction outside the contact area only (Derjaguin, Muller & Toporov 1975; Maugis
// 1992):
//   f_n = (4/3) E* a^3/R - 2 pi w R,   delta = a^2/R,   pull-off 2 pi w R at a = 0.
// Valid for stiff, small spheres and long-range attraction: Tabor's mu = (R w^2/(E*^2 z0^3))^(1/3) < 0.1. SI
// units.
#pragma once

#include <cmath>

#include "core/hertz.h"
#include "dem_compare/laws/law_registry.h"
#include "dem_compare/laws/normal_state.h"

namespace asperity {

/// Tabor's parameter for an equilibrium distance z0 of the surfaces [m] (Tabor 1977).
inline double tabor_parameter(double reduced_modulus, double radius, double work_of_adhesion,
                              double distance) {
  return std::cbrt(radius * work_of_adhesion * work_of_adhesion /
                   (reduced_modulus * reduced_modulus * distance * distance * distance));
}

struct Dmt {
  double reduced_modulus = 0;   ///< E* [Pa]
  double radius = 0;            ///< R [m]
  double work_of_adhesion = 0;  ///< w [J/m^2], both surfaces together

  /// Largest tension [N].
  double pull_off_force() const { return 2 * M_PI * work_of_adhesion * radius; }
  NormalState advance(const NormalState&, double approach) const {
    if (approach < 0) return {approach, 0, 0, 0, false};
    const double a = std::sqrt(radius * approach);
    return {approach, hertz().force(approach) - pull_off_force(), a, 2 * reduced_modulus * a, true};
  }
  double approach(double force) const { return hertz().approach(force + pull_off_force()); }
  Hertz hertz() const { return {reduced_modulus, radius}; }
};

inline const LawEntry<Dmt, NormalMode> dmt_entry{
    {"dmt", "f_n = 4/3 E* a^3/R - 2 pi w R, delta = a^2/R", "Derjaguin, Muller & Toporov 1975; Maugis 1992",
     "Tabor parameter below 0.1; smooth, elastic, a << R"},
    {{{"reduced_modulus", "Pa", "E*"}, &Dmt::reduced_modulus},
     {{"radius", "m", "R"}, &Dmt::radius},
     {{"work_of_adhesion", "J/m^2", "w of both surfaces together"}, &Dmt::work_of_adhesion}}};

}  // namespace asperity
