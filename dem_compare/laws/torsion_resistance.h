// Resistance to torsion as a spring with a slider (Luding 2008; Fuchs, Weinhart et al. 2014, eqs. yield):
//   d M = K d theta,   |M| <= mu lambda (f_n + h),   lambda = r or a,   theta: relative rotation about the
//   contact's normal.
// With lambda = a and mu = (3 pi/16) mu_l this is the exact limit of a Hertzian contact (hertzian_torsion.h),
// with K = (16/3) Gt a^3 its exact initial stiffness. The slip between (lubkin_torsion.h) and what torsion
// takes from the lateral friction (Farkas et al. 2003) are left out. SI units.
#pragma once

#include "dem_compare/laws/rotation_fields.h"

namespace asperity {

using TorsionResistance = RotationResistance;

inline const LawEntry<TorsionResistance, TorsionMode> torsion_resistance_entry{
    {"torsion_resistance", "d M = K d theta, |M| <= mu lambda (f_n + h), lambda = r or a",
     "Luding 2008; Fuchs, Weinhart et al. 2014", "without partial slip and without interplay with sliding"},
    resistance_fields<TorsionResistance>()};

}  // namespace asperity
