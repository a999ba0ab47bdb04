// Resistance to rolling as a spring with a slider (Luding 2008; Fuchs, Weinhart et al. 2014, eqs. yield):
//   d M = K d phi,   |M| <= mu lambda (f_n + h),   lambda = r or a,   phi: relative rotation about axes in
//   the contact plane.
// The coefficient stands for adhesion hysteresis, plasticity of asperities and humidity together; a smooth
// elastic contact has none up to micro-slip. K is an assumption: before the limit is reached, rolling of real
// contacts has been measured softer and load-dependent. No rate effect (see viscous.h). SI units.
#pragma once

#include "dem_compare/laws/rotation_fields.h"

namespace asperity {

using RollingResistance = RotationResistance;

inline const LawEntry<RollingResistance, RollingMode> rolling_resistance_entry{
    {"rolling_resistance", "d M = K d phi, |M| <= mu lambda (f_n + h), lambda = r or a",
     "Luding 2008; Fuchs, Weinhart et al. 2014",
     "an empirical law: mu, h and K are fitted, over the loads they were fitted at"},
    resistance_fields<RollingResistance>()};

}  // namespace asperity
