// Elastic, perfectly plastic sphere with adhesion (Thornton & Ning 1998; without adhesion Thornton 1997): JKR
// until the pressure in the middle of the contact, 2 E* a/(pi R) - (2 w E*/(pi a))^(1/2), reaches p_y; then
// the pressure stays there,
//   f_n = F_y + pi p_y (a^2 - a_y^2),   delta = delta_y + (a^2 - a_y^2)/R.
// Unloading and reloading up to the largest approach: JKR of the flattened surface, whose radius R_p fits f_n
// and a there,
//   R_p = 4/3 E* a*^3/[F* + (8 pi w E* a*^3)^(1/2)],   delta = delta_p + a^2/R_p - (2 pi w a/E*)^(1/2):
// an imprint delta_p stays, and the pull-off force (3/2) pi w R_p has grown. SI units.
#pragma once

#include <algorithm>
#include <cmath>

#include "dem_compare/laws/jkr.h"
#include "dem_compare/laws/law_registry.h"
#include "dem_compare/laws/normal_state.h"

namespace asperity {

struct ThorntonNing {
  double reduced_modulus = 0;   ///< E* [Pa]
  double radius = 0;            ///< R [m]
  double yield_pressure = 0;    ///< p_y [Pa]
  double work_of_adhesion = 0;  ///< w [J/m^2], both surfaces together

  /// Contact after it has yielded up to an approach [m].
  struct Flattened {
    Jkr law;             ///< of the radius R_p
    double imprint = 0;  ///< delta_p [m]
  };

  /// a_y [m], where p(0) = p_y: without adhesion pi p_y R/(2 E*). Newton's method from above, where the
  /// pressure is concave and increasing.
  double yield_radius() const {
    const double linear = 2 * reduced_modulus / (M_PI * radius),
                 root = std::sqrt(2 * work_of_adhesion * reduced_modulus / M_PI);
    double a = yield_pressure / linear + std::cbrt(root / linear * (root / linear));
    constexpr int most_iterations = 60;
    for (int i = 0; i < most_iterations; ++i) {
      const double excess = linear * a - root / std::sqrt(a) - yield_pressure;
      const double next = a - excess / (linear + 0.5 * root / (a * std::sqrt(a)));
      if (std::abs(next - a) <= 4e-16 * a) break;
      a = next;
    }
    return a;
  }
  /// Force [N] and approach [m] at first yield.
  double yield_force() const { return elastic().force_at_radius(yield_radius()); }
  double yield_approach() const { return elastic().approach_at_radius(yield_radius()); }

  /// Yielded up to `largest_approach` [m], beyond that of first yield.
  Flattened flattened(double largest_approach) const {
    const double a_y = yield_radius(), F_y = elastic().force_at_radius(a_y);
    const double grown = radius * (largest_approach - elastic().approach_at_radius(a_y));
    const double a = std::sqrt(a_y * a_y + grown), F = F_y + M_PI * yield_pressure * grown;
    const double cube = reduced_modulus * a * a * a;
    const double R_p = 4.0 / 3 * cube / (F + std::sqrt(8 * M_PI * work_of_adhesion * cube));
    const Jkr law{reduced_modulus, R_p, work_of_adhesion};
    return {law, largest_approach - law.approach_at_radius(a)};
  }

  NormalState advance(const NormalState& before, double approach) const {
    const double first_yield = yield_approach();
    const double largest = std::max(before.largest_approach, first_yield);
    if (approach >= largest) {
      const double a_y = yield_radius(), grown = radius * (approach - first_yield);
      return {approach,
              yield_force() + M_PI * yield_pressure * grown,
              std::sqrt(a_y * a_y + grown),
              M_PI * yield_pressure * radius,
              true,
              approach};
    }
    const Flattened now =
        before.largest_approach > first_yield ? flattened(largest) : Flattened{elastic(), 0};
    NormalState state = now.law.advance(before, approach - now.imprint);
    state.approach = approach;
    state.largest_approach = before.largest_approach;
    return state;
  }
  /// On first loading; needs force >= -1.5 pi w R.
  double approach(double force) const {
    if (force <= yield_force()) return elastic().approach(force);
    return yield_approach() + (force - yield_force()) / (M_PI * yield_pressure * radius);
  }

 private:
  Jkr elastic() const { return {reduced_modulus, radius, work_of_adhesion}; }
};

inline const LawEntry<ThorntonNing, NormalMode> thornton_ning_entry{
    {"thornton_ning",
     "JKR to p(0) = p_y, f_n = F_y + pi p_y R (delta - delta_y); unloading: JKR with R_p = 4/3 E* a*^3/[F* + "
     "(8 pi w E* a*^3)^(1/2)]",
     "Thornton 1997, J. Appl. Mech. 64, 383; Thornton & Ning 1998, Powder Technol. 99, 154",
     "yielding up to an approach of some 20 delta_y (beyond, p_y grows towards the hardness); smooth, a << "
     "R"},
    {{{"reduced_modulus", "Pa", "E*"}, &ThorntonNing::reduced_modulus},
     {{"radius", "m", "R"}, &ThorntonNing::radius},
     {{"yield_pressure", "Pa", "p_y, 1.6 to 3 times the yield stress", 1}, &ThorntonNing::yield_pressure},
     {zero_otherwise({"work_of_adhesion", "J/m^2", "w of both surfaces together"}),
      &ThorntonNing::work_of_adhesion}}};

}  // namespace asperity
