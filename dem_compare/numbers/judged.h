// Whether a number departs from a reference by less than a tolerance: told by its interval, not by the number
// alone.
#pragma once

#include <cmath>

namespace asperity {

enum class Judged { within, outside, not_known };

/// `half_width` of the interval about the departure that holds the truth 19 times in 20: two standard
/// deviations and, added to them, bounds that are no scatter (mesh, steps). One that is not known (NaN)
/// counts as none: say so beside the verdict.
/// All three relative, or in one unit.
inline Judged judged(double departure, double half_width, double tolerance) {
  const double size = std::abs(departure), width = std::isfinite(half_width) ? half_width : 0;
  if (!std::isfinite(size)) return Judged::not_known;
  return size + width <= tolerance  ? Judged::within
         : size - width > tolerance ? Judged::outside
                                    : Judged::not_known;
}

}  // namespace asperity
