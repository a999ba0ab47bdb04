// Resistance to rolling as a spring with a slider (Luding 2008; Fuchs, Weinhart et al. 2014, eqs. yield):
//   d M = K d phi,   |M| <= mu lambda (f_n + h),   lambda = r or a,   phi: relative rotation about axes in
//   the contact plane.
// The coefficient stands for adhesion hysteresis, plasticity of asperities and humidity together; a smooth
// elastic contact has none up to micro-slip. K is an assumption: before the limit is reached, rolling of real
// contacts has been measured softer and load-dependent. No rate effect (see viscous.h). SI units.
#pragma once

#include <algorithm>

#include "dem_compare/laws/rotation_fields.h"

namespace asperity {

struct RollingResistance {
  double coefficient = 0;     ///< mu [-]
  double adhesion_force = 0;  ///< h [N]
  LengthScale length = LengthScale::particle_radius;
  RotationalStiffness stiffness{};

  double limit(const NormalState& normal, double lever) const {
    return std::max(0.0, coefficient * length_of(length, normal, lever) * (normal.force + adhesion_force));
  }
};

inline const LawEntry<RollingResistance, RollingMode> rolling_resistance_entry{
    {"rolling_resistance", "d M = K d phi, |M| <= mu lambda (f_n + h), lambda = r or a",
     "Luding 2008; Fuchs, Weinhart et al. 2014",
     "an empirical law: mu, h and K are fitted, over the loads they were fitted at"},
    resistance_fields<RollingResistance>()};

}  // namespace asperity
