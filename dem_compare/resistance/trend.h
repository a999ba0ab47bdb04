// The slope of a few numbers with standard deviations, and whether it has a sign.
#pragma once

#include <vector>

#include "dem_compare/numbers/uncertain.h"

namespace asperity {

struct Trend {
  /// Least squares with equal weights: how much y changes over the range of x, whether or not on a straight
  /// line. A number that is known exactly, as that nothing yields, does not outweigh the others. Its sd is
  /// that of the points, or from their misfit if larger.
  Uncertain slope{std::nan(""), std::nan("")};
  Uncertain mean{std::nan(""), std::nan("")};  ///< of y, at the mean of x
  int points = 0;

  enum class Sign { unknown, none, rises, falls };
  Sign sign() const;  ///< of the slope
  /// Slope over the mean.
  Uncertain relative() const;
};

/// At two standard deviations; unknown where there is no sd.
Trend::Sign sign_of(const Uncertain& number);

/// Points that are not numbers are left out; fewer than two different x give an unknown slope.
Trend fit_trend(const std::vector<double>& x, const std::vector<Uncertain>& y);

/// Exponent n of y ~ x^n, fitted to the logarithms; values that are not positive by two standard deviations
/// make it unknown.
Trend fit_exponent_of(const std::vector<double>& x, const std::vector<Uncertain>& y);

/// Weighted mean of numbers of which it is not known how their errors are related: its sd assumes that they
/// err together.
Uncertain cautious_mean(const std::vector<Uncertain>& values);

}  // namespace asperity
