// Partial slip of a Hertzian contact on strips x_k of its width: u_k <- u_k + d xi, cut to |u_k| <= kappa
// (delta - s_k),
//   s_k = x_k^2/R,  kappa = 3 limit R/(16 G* a^3),  f_l = 8 G* sum u_k dx   (Jaeger 1993; Ciavarella 1998;
//   the states of
// dem_compare/laws/mindlin_deresiewicz.h on a fixed set of strips: within 0.2 % of it, and many times
// faster). Elastically similar bodies; shear along one line. SI units.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity {

class StripContact {
 public:
  /// Force at a shift that follows the accepted state by `increment`; `stiffness` = 8 G* a, `limit` = mu f_n
  /// [N]. `now` receives the state.
  double advance(double stiffness, double limit, double contact_radius, double increment,
                 StripContact& now) const {
    now.radius_ = contact_radius;
    if (contact_radius <= 0 || limit <= 0) {
      now.shift_.fill(0);
      return 0;
    }
    // Strips are parts of the present radius: where the contact grows, they come from further inside, and new
    // ones are at rest.
    const double scale = radius_ > 0 ? contact_radius / radius_ : 1;
    const double largest = 1.5 * limit / stiffness;  // kappa delta: of the middle strip at gross slip
    double sum = 0;
    for (int k = 0; k < strips; ++k) {
      const double x = (k + 0.5) / strips;
      const double bound = largest * (1 - x * x);
      const double before = scale == 1 ? shift_[static_cast<std::size_t>(k)] : at(x * scale);
      const double moved = std::clamp(before + increment, -bound, bound);
      now.shift_[static_cast<std::size_t>(k)] = moved;
      sum += moved;
    }
    return std::clamp(stiffness * sum / strips * correction(), -limit, limit);
  }

 private:
  static constexpr int strips = 48;
  /// Sum of 1 - x^2 by the midpoints against 2/3, so that gross slip is exact.
  static double correction() { return 1 / (1 + 1.0 / (8.0 * strips * strips)); }
  double at(double x) const {
    const double place = x * strips - 0.5;
    if (place <= 0) return shift_[0];
    if (x >= 1) return 0;
    const int k = static_cast<int>(place);
    const double next = k + 1 < strips ? shift_[static_cast<std::size_t>(k) + 1] : 0;
    return shift_[static_cast<std::size_t>(k)] + (next - shift_[static_cast<std::size_t>(k)]) * (place - k);
  }

  std::array<double, strips> shift_{};
  double radius_ = 0;
};

}  // namespace asperity
