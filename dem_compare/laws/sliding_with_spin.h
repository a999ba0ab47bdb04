// What sliding and torsion take from each other while a Hertzian contact slips everywhere, with the velocity
// v across and the spin omega about the normal, eps = v/(omega a) (Contensou 1963; Farkas et al. 2003 for
// uniform pressure):
//   F/(mu P) = int p (eps - r sin t)/D dA,   T/(mu P a) = int p r (r - eps sin t)/D dA,   D^2 = eps^2 - 2 eps
//   r sin t + r^2.
// eps >> 1: F = mu P, T = 0; eps << 1: F = 0, T = (3 pi/16) mu P a. Independent limits for each mode
// (contact_model.h) leave this out: the error is in F, up to all of it. Full slip only; before, the stick
// zones interact as well. SI units.
#pragma once

#include "dem_compare/laws/law_registry.h"

namespace asperity {

struct SlidingWithSpin {
  double coefficient = 0;  ///< mu [-]

  static constexpr const char* ratio = "v/omega [m]";

  /// `velocity_over_spin`: eps a = v/omega [m], >= 0; infinite for pure sliding.
  SlipResistance resistance(double normal_force, double contact_radius, double velocity_over_spin) const;
};

inline const LawEntry<SlidingWithSpin, SteadySlipMode> sliding_with_spin_entry{
    {"sliding_with_spin",
     "F = mu int p (eps - r sin t)/D dA, T = mu a int p r (r - eps sin t)/D dA, eps = v/(omega a)",
     "Contensou 1963; Farkas, Bartels, Unger & Wolf 2003", "full slip of a Hertzian contact"},
    {{{"sliding_coefficient", "", "mu of sliding"}, &SlidingWithSpin::coefficient}}};

}  // namespace asperity
