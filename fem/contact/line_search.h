// Line search of the contact solver's Newton iteration along a direction of descent of its convex energy.
#pragma once

#include <algorithm>
#include <cmath>

namespace asperity::fem {

class LineSearch {
 public:
  /// error: unbalanced force [N] from which the next steps are to make progress; patience: steps without
  /// progress after which the minimum of the energy is located accurately.
  LineSearch(double error, int patience) : patience_(patience) { restart(error); }
  /// Begins anew from an unbalanced force [N].
  void restart(double error) { least_ = error, barren_ = 0; }
  /// To be called with the unbalanced force [N] that each step reached.
  void reached(double error) {
    barren_ = error < progress * least_ ? 0 : barren_ + 1;
    least_ = std::min(least_, error);
  }

  /// slope: of the energy along the direction at its start, positive for descent; slope_at(step) moves there
  /// and returns the slope, negative beyond the lowest energy. Returns the step that it moved to last.
  /// slope in [J], steps are fractions of the direction [-].
  template <typename SlopeAt>
  double step(double slope, const SlopeAt& slope_at) const {
    const double whole = slope_at(1.0);
    if (whole > far_from_lowest * slope) return lengthened(slope, slope_at);
    return barren_ < patience_ ? with_few_cuts(slope, whole, slope_at) : to_lowest(slope, whole, slope_at);
  }

 private:
  /// Directions without the softening of attraction, or with the secant stiffness of slip, may be far too
  /// short.
  template <typename SlopeAt>
  static double lengthened(double slope, const SlopeAt& slope_at) {
    double step = 1, here = slope;
    for (int k = 0; k < most_doublings && here > far_from_lowest * slope; ++k) here = slope_at(step *= 2);
    if (here < -slope_left * slope) slope_at(step *= 0.75);
    return step;
  }

  /// Steps that overshoot are cut. Far too long ones are cut only in part: with more active nodes than in
  /// equilibrium the iteration recovers in few full steps, with fewer it converges slowly. `here`: the slope
  /// after a whole step.
  template <typename SlopeAt>
  static double with_few_cuts(double slope, double here, const SlopeAt& slope_at) {
    double step = 1;
    for (int cut = 0; cut < most_cuts && here <= -overshoot_allowed * slope; ++cut) {
      step *= std::max(shortest_cut, slope / (slope - here));
      here = slope_at(step);
    }
    return step;
  }

  /// Where the iteration cycles (reversed yielding without hardening), the minimum of the energy is located
  /// more accurately.
  template <typename SlopeAt>
  static double to_lowest(double slope, double slope_high, const SlopeAt& slope_at) {
    double low = 0, high = 1, slope_low = slope, step = 1;
    for (int k = 0; k < most_closing_steps && (step < 1 || slope_high < -slope_left * slope); ++k) {
      step = low + (high - low) * std::clamp(slope_low / (slope_low - slope_high), 0.1, 0.9);
      const double here = slope_at(step);
      if (std::abs(here) <= slope_left * slope) break;
      (here > 0 ? low : high) = step;
      (here > 0 ? slope_low : slope_high) = here;
    }
    return step;
  }

  static constexpr int most_cuts = 2, most_closing_steps = 10, most_doublings = 5;
  static constexpr double overshoot_allowed = 5.0, shortest_cut = 0.35, progress = 0.7, slope_left = 0.3,
                          far_from_lowest = 0.5;
  int patience_;
  double least_ = 0;
  int barren_ = 0;
};

}  // namespace asperity::fem
