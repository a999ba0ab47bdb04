// Resistance to torsion as a spring with a slider (Luding 2008; Fuchs, Weinhart et al. 2014, eqs. yield):
//   d M = K d theta,   |M| <= mu lambda (f_n + h),   lambda = r or a,   theta: relative rotation about the contact's normal.
// With lambda = a and mu = (3 pi/16) mu_l this is the exact limit of a Hertzian contact (hertzian_torsion.h), with
// K = (16/3) Gt a^3 its exact initial stiffness. The slip between (lubkin_torsion.h) and what torsion takes from the lateral
// friction (Farkas et al. 2003) are left out. SI units.
#pragma once

#include <algorithm>

#include "dem_compare/laws/law_registry.h"
#include "dem_compare/laws/rotation_scales.h"
#include "dem_compare/laws/spring_slider.h"

namespace asperity {

struct TorsionResistance {
  double coefficient = 0;     ///< mu [-]
  double adhesion_force = 0;  ///< h [N]
  LengthScale length = LengthScale::particle_radius;
  RotationalStiffness stiffness;

  using History = SpringSlider<double>;  ///< resistance: moment about the normal [N m]

  double limit(const NormalState& normal, double lever) const {
    return std::max(0.0, coefficient * length_of(length, normal, lever) * (normal.force + adhesion_force));
  }
  /// After a relative rotation [rad] about the normal; `lever` [m]: from the particle's centre to the contact.
  History advance(const History& before, const NormalState& normal, double lever, double increment) const {
    if (!normal.touching) return {};
    return History::advance(before, stiffness.at(normal, length_of(length, normal, lever), lever), increment,
                            limit(normal, lever), ChangingLoad::rescale_on_unloading);
  }
};

inline const LawEntry<TorsionResistance> torsion_resistance_entry{
    {"torsion_resistance", "torsion", "d M = K d theta, |M| <= mu lambda (f_n + h), lambda = r or a",
     "Luding 2008; Fuchs, Weinhart et al. 2014", "without partial slip and without interplay with sliding", {}},
    {{{"coefficient", "", "mu"}, &TorsionResistance::coefficient},
     {{"adhesion_force", "N", "offset h"}, &TorsionResistance::adhesion_force}}};

}  // namespace asperity
