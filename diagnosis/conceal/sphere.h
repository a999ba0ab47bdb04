// Elastic contact of a true sphere, not a parabola, with a plane (Sneddon 1965, Int. J. Eng. Sci. 3:47):
//   delta = (a/2) ln((R + a)/(R - a)),   F = E* [ (a^2 + R^2)/2 ln((R + a)/(R - a)) - a R ].
// Agrees with Hertz to order (a/R)^2. Small strain, a < R. SI units.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/root.h"

namespace asperity::hidden {

inline constexpr double pi = M_PI;

struct Sphere {
  double reduced_modulus = 0;  ///< E* [Pa]
  double radius = 0;           ///< R [m]

  /// Approach [m] and force [N] at a contact radius a [m].
  double approach_of(double a) const { return 0.5 * a * std::log((radius + a) / (radius - a)); }
  /// Force [N] at a contact radius a [m].
  double force_of(double a) const {
    return reduced_modulus *
           (0.5 * (a * a + radius * radius) * std::log((radius + a) / (radius - a)) - a * radius);
  }
  /// a at an approach, by Newton's method from Hertz' a = (R delta)^(1/2), which is above.
  double contact_radius(double approach) const {
    if (approach <= 0) return 0;
    double a = std::min(std::sqrt(radius * approach), 0.9 * radius);
    constexpr int iterations = 30;
    for (int i = 0; i < iterations; ++i) {
      const double slope =
          0.5 * std::log((radius + a) / (radius - a)) + a * radius / (radius * radius - a * a);
      const double step = (approach_of(a) - approach) / slope;
      a -= step;
      if (std::abs(step) < 1e-15 * radius) break;
    }
    return a;
  }
  double force(double approach) const { return approach <= 0 ? 0 : force_of(contact_radius(approach)); }
  double contact_radius_at_force(double force) const {
    return root_between([&](double a) { return force_of(a) - force; }, 0, 0.9 * radius);
  }
};

}  // namespace asperity::hidden
