// Root of a function that grows with its argument.
#pragma once

#include <cmath>

namespace asperity {

/// Brackets by growing steps from `guess`, then regula falsi in the Illinois form (Dowell & Jarratt 1971).
/// Where the function has more than one root, the bracket is sought from above: the stable branch of an
/// adhesive contact lies there.
template <class Function>
double increasing_root(const Function& f, double guess, double step, double tolerance) {
  constexpr int most_expansions = 80, most_iterations = 100;
  double high = guess, f_high = f(high);
  double width = step;
  for (int i = 0; i < most_expansions && f_high < 0; ++i, width *= 2) {
    high += width;
    f_high = f(high);
  }
  double low = high - step, f_low = f(low);
  width = step;
  for (int i = 0; i < most_expansions && f_low > 0; ++i, width *= 2) {
    high = low;
    f_high = f_low;
    low -= width;
    f_low = f(low);
  }
  if (f_low > 0) return low;  // nothing holds it: free
  if (f_high < 0) return high;
  int side = 0;
  for (int i = 0; i < most_iterations && high - low > tolerance; ++i) {
    const double span = f_high - f_low;
    double middle = span > 0 ? (low * f_high - high * f_low) / span : 0.5 * (low + high);
    if (!(middle > low && middle < high)) middle = 0.5 * (low + high);
    const double value = f(middle);
    if (value == 0) return middle;
    if (value > 0) {
      // the last change was of this side too: halve the weight of the other, else it would stay for ever
      if (side == 1) f_low *= 0.5;
      high = middle, f_high = value, side = 1;
    } else {
      if (side == -1) f_high *= 0.5;
      low = middle, f_low = value, side = -1;
    }
  }
  return 0.5 * (low + high);
}

}  // namespace asperity
