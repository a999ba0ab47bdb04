// Length scale and stiffness that rolling and torsion resistance can have (Fuchs, Weinhart et al. 2014,
// sec. 3.2). SI units.
#pragma once

#include <algorithm>

#include "core/length_scale.h"
#include "dem_compare/laws/normal_state.h"
#include "dem_compare/laws/spring_slider.h"

namespace asperity {

/// lambda [m]; 1 [-] without one. lever [m].
inline double length_of(LengthScale scale, const NormalState& normal, double lever) {
  return scale == LengthScale::none              ? 1
         : scale == LengthScale::particle_radius ? lever
                                                 : normal.contact_radius;
}

/// Moment per angle [N m/rad] before the slider moves.
struct RotationalStiffness {
  enum class Kind {
    constant,     ///< value = K [N m/rad]
    with_radius,  ///< value = K/a [N/rad]: K grows with the contact radius, from a load where it is known
    tangential_spring,  ///< value = G* [Pa]: K = 8 G* a lambda r, the paper's assumption k_ro = k_to = k_l
    no_slip_torsion,    ///< value = Gt [Pa]: K = (16/3) Gt a^3, exact for torsion (Reissner & Sagoci 1944)
  };
  Kind kind = Kind::constant;
  double value = 0;

  /// K at a length scale and a lever arm [m].
  double at(const NormalState& normal, double length, double lever) const {
    const double a = normal.contact_radius;
    switch (kind) {
      case Kind::tangential_spring:
        return 8 * value * a * length * lever;
      case Kind::no_slip_torsion:
        return 16.0 / 3.0 * value * a * a * a;
      case Kind::with_radius:
        return value * a;
      case Kind::constant:
        break;
    }
    return value;
  }
};

/// A spring with a slider (Luding 2008; Fuchs, Weinhart et al. 2014, eqs. yield):
///   d M = K d phi,   |M| <= mu lambda (f_n + h),   lambda = r or a.
struct RotationResistance {
  double coefficient = 0;     ///< mu [-]
  double adhesion_force = 0;  ///< h [N]
  LengthScale length = LengthScale::particle_radius;
  RotationalStiffness stiffness{};

  /// Largest moment [N m]; lever [m].
  double limit(const NormalState& normal, double lever) const {
    return std::max(0.0, coefficient * length_of(length, normal, lever) * (normal.force + adhesion_force));
  }
};

/// The moment of a law's spring after a relative rotation [rad], cut to its limit.
template <class Law, class Value>
SpringSlider<Value> advance_spring(const Law& law, const SpringSlider<Value>& before,
                                   const NormalState& normal, double lever, const Value& increment) {
  if (!normal.touching) return {};
  return SpringSlider<Value>::advance(
      before, law.stiffness.at(normal, length_of(law.length, normal, lever), lever), increment,
      law.limit(normal, lever), ChangingLoad::rescale_on_unloading);
}

}  // namespace asperity
