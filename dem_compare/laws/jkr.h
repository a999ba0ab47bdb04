// Adhesive contact with attraction inside the contact area only (Johnson, Kendall & Roberts 1971; Johnson
// 1985, sec. 5.5; Maugis 1992):  f_n = (4/3) E* a^3/R - (8 pi w E* a^3)^(1/2),   delta = a^2/R - (2 pi w
// a/E*)^(1/2). Pull-off: (3/2) pi w R under a dead load, (5/6) pi w R under fixed grips. The contact forms at
// delta = 0 on closing and breaks at the fixed-grips limit on opening: the law has history, and a cycle
// dissipates. Valid for soft, large spheres and short-range attraction: Tabor's mu > 5. SI units.
#pragma once

#include <algorithm>
#include <cmath>

#include "dem_compare/laws/law_registry.h"
#include "dem_compare/laws/normal_state.h"

namespace asperity {

struct Jkr {
  double reduced_modulus = 0;   ///< E* [Pa]
  double radius = 0;            ///< R [m]
  double work_of_adhesion = 0;  ///< w [J/m^2], both surfaces together

  /// Largest tension [N].
  double pull_off_force() const { return 1.5 * pi_w() * radius; }
  /// Force [N] and approach [m] at a contact radius a [m].
  double force_at_radius(double a) const {
    return 4.0 / 3.0 * reduced_modulus * a * a * a / radius -
           std::sqrt(8 * pi_w() * reduced_modulus * a * a * a);
  }
  /// Approach [m] at a contact radius a [m].
  double approach_at_radius(double a) const {
    return a * a / radius - std::sqrt(2 * pi_w() * a / reduced_modulus);
  }
  /// Smallest radius that is stable under fixed grips, where d(delta)/da = 0.
  double smallest_radius() const { return std::cbrt(pi_w() * radius * radius / (8 * reduced_modulus)); }
  double smallest_approach() const { return approach_at_radius(smallest_radius()); }
  /// Stable branch under a dead load; force >= -pull_off_force().
  double radius_at_force(double force) const {
    const double c = 3 * pi_w() * radius;
    const double effective = force + c + std::sqrt(std::max(0.0, 2 * c * force + c * c));
    return std::cbrt(0.75 * radius * effective / reduced_modulus);
  }
  double approach(double force) const { return approach_at_radius(radius_at_force(force)); }

  /// Stable branch under fixed grips; approach >= smallest_approach(): with x = a^(1/2) the largest root of
  ///   x^4 = q x + r,  q = R (2 pi w/E*)^(1/2),  r = R delta,
  /// by Ferrari, x = [s + (2 q/s - s^2)^(1/2)]/2,  y = s^2 the root of y^3 + 4 r y = q^2, which hyperbolic
  /// functions give without cancellation.
  double radius_at_approach(double approach) const {
    const double q = radius * std::sqrt(2 * pi_w() / reduced_modulus), r = radius * approach;
    if (q == 0) return std::sqrt(std::max(0.0, r));
    const double third = std::sqrt(4.0 / 3 * std::abs(r)), ratio = 0.5 * q * q / (third * third * third);
    constexpr double large = 1e12;  // r is nothing beside q
    const double y = ratio > large ? std::cbrt(q * q)
                     : r > 0       ? 2 * third * std::sinh(std::asinh(ratio) / 3)
                                   : 2 * third * std::cosh(std::acosh(std::max(1.0, ratio)) / 3);
    const double s = std::sqrt(y), x = 0.5 * (s + std::sqrt(std::max(0.0, 2 * q / s - y)));
    return r > 0 ? x * x : std::max(smallest_radius(), x * x);
  }

  NormalState advance(const NormalState& before, double approach) const {
    const bool touching = before.touching ? approach >= smallest_approach() : approach >= 0;
    if (!touching) return {approach, 0, 0, 0, false};
    const double a = radius_at_approach(approach);
    if (a == 0) return {approach, 0, 0, 0, true};  // w = 0, at first touch
    const double slope_of_approach = 2 * a / radius - 0.5 * std::sqrt(2 * pi_w() / (reduced_modulus * a));
    const double slope_of_force =
        4 * reduced_modulus * a * a / radius - 1.5 * std::sqrt(8 * pi_w() * reduced_modulus * a);
    return {approach, force_at_radius(a), a, slope_of_force / slope_of_approach, true};
  }

 private:
  double pi_w() const { return M_PI * work_of_adhesion; }
};

inline const LawEntry<Jkr, NormalMode> jkr_entry{
    {"jkr", "f_n = 4/3 E* a^3/R - (8 pi w E* a^3)^(1/2), delta = a^2/R - (2 pi w a/E*)^(1/2)",
     "Johnson, Kendall & Roberts 1971; Johnson 1985, sec. 5.5; Maugis 1992",
     "Tabor parameter above 5; smooth, elastic, a << R"},
    {{{"reduced_modulus", "Pa", "E*"}, &Jkr::reduced_modulus},
     {{"radius", "m", "R"}, &Jkr::radius},
     {{"work_of_adhesion", "J/m^2", "w of both surfaces together"}, &Jkr::work_of_adhesion}}};

}  // namespace asperity
