// Intervals of admissible numbers.
#pragma once

#include <limits>

namespace asperity {

/// In SI units.
struct Range {
  double low, high;
  bool low_open = false, high_open = false;
  /// Whether x lies within, ends that are open left out.
  bool holds(double x) const { return (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high); }
};
inline constexpr Range positive{0, std::numeric_limits<double>::infinity(), true, true};
inline constexpr Range positive_or_infinite{0, std::numeric_limits<double>::infinity(), true, false};
inline constexpr Range below_one{0, 1, false, true};
inline constexpr Range not_negative{0, std::numeric_limits<double>::infinity(), false, true};

}  // namespace asperity
