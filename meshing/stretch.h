// A one-dimensional grading (stretching function): uniform node spacing near the origin that widens smoothly
// up to a given length.
#pragma once

#include <algorithm>
#include <cmath>

namespace asperity::meshing {

/// Maps a logical coordinate s in [-1, 1] (or [0, 1]) to x in [-length, length], odd and twice continuously
/// differentiable: x = slope s for |s| <= uniform_part, plus a cubic beyond it that reaches x(1) = length.
/// slope <= length keeps it monotone.
class Stretch {
 public:
  /// Of the logical coordinate; the rest is left to widen in.
  static constexpr double largest_uniform_part = 0.7;

  Stretch() = default;
  /// slope: dx/ds of the uniform part [m]; uniform_half_width: |x| up to which the spacing stays uniform [m].
  Stretch(double length, double slope, double uniform_half_width)
      : length_(length),
        slope_(std::min(slope, length)),
        uniform_part_(std::min(largest_uniform_part, uniform_half_width / slope_)) {
    cubic_ = (length_ - slope_) / std::pow(1.0 - uniform_part_, 3);
  }

  double operator()(double s) const {
    const double beyond = std::max(0.0, std::abs(s) - uniform_part_);
    const double x = slope_ * std::abs(s) + cubic_ * beyond * beyond * beyond;
    return s < 0 ? -x : x;
  }

  /// Of the graded line [m].
  double length() const { return length_; }
  /// Spacing at the end over that of the uniform part.
  double widening() const { return 1 + 3 * cubic_ / slope_ * (1 - uniform_part_) * (1 - uniform_part_); }

 private:
  double length_ = 1, slope_ = 1, uniform_part_ = 0, cubic_ = 0;
};

}  // namespace asperity::meshing
