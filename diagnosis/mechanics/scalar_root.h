// Root of a function that grows with its argument.
#pragma once

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

namespace asperity {

/// Between a place where the function is below 0 and one above it where it is not: algorithm 748 (Alefeld,
/// Potra & Shi 1995). In the unit of the argument.
template <class Function>
double root_between(const Function& f, double low, double high, double f_low, double f_high,
                    double tolerance) {
  std::uintmax_t iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      f, low, high, f_low, f_high, [tolerance](double from, double to) { return to - from <= tolerance; },
      iterations);
  return 0.5 * (bracket.first + bracket.second);
}

/// Brackets by growing steps from `guess`. Where the function has more than one root, the bracket is sought
/// from above: the stable branch of an adhesive contact lies there.
/// In the unit of the argument.
template <class Function>
double increasing_root(const Function& f, double guess, double step, double tolerance) {
  constexpr int most_expansions = 80;
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
  if (!std::isfinite(f_low) || !std::isfinite(f_high)) return guess;  // so far out there is no function
  if (f_low > 0) return low;                                          // nothing holds it: free
  if (f_high < 0) return high;
  if (!(low < high)) return high;  // so far out that a step is lost in rounding: the function has no root
  return root_between(f, low, high, f_low, f_high, tolerance);
}

}  // namespace asperity
