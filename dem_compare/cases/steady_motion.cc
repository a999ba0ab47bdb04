#include "dem_compare/cases/steady_motion.h"

#include <algorithm>
#include <cmath>

#include "dem_compare/laws/lubkin_torsion.h"

namespace asperity {
namespace {

using Values = std::vector<double>;

double interpolated(const Values& x, const Values& y, std::size_t first, std::size_t last, double at) {
  std::size_t i = first;
  const bool rising = x[last] > x[first];
  while (i + 1 < last && (rising ? x[i + 1] < at : x[i + 1] > at)) ++i;
  return x[i + 1] == x[i] ? y[i] : y[i] + (at - x[i]) / (x[i + 1] - x[i]) * (y[i + 1] - y[i]);
}

}  // namespace

CorrelatedMean correlated_mean(const Values& values) {
  const auto n = static_cast<double>(values.size());
  CorrelatedMean result;
  for (const double v : values) result.mean += v / n;
  double variance = 0;
  for (const double v : values) variance += (v - result.mean) * (v - result.mean) / n;
  result.sd = std::sqrt(variance);
  result.independent = n;
  if (variance == 0) return result;
  double sum = 1;
  for (std::size_t k = 1; k < values.size() / 2; ++k) {
    double covariance = 0;
    for (std::size_t i = 0; i + k < values.size(); ++i)
      covariance += (values[i] - result.mean) * (values[i + k] - result.mean) / n;
    if (covariance <= 0) break;
    sum += 2 * covariance / variance;
  }
  // Fewer than two independent blocks cannot tell how far the mean is off: then as far as the values
  // scatter.
  result.independent = n / sum;  // above 1: there are fewer than n / 2 lags, none above the variance
  result.standard_error = result.sd / std::sqrt(std::max(n / sum - 1, 1.0));
  return result;
}

Values resampled_along(const Values& position, const Values& values, std::size_t first, std::size_t last) {
  // Rows at rest have no step.
  Values steps, result;
  for (std::size_t i = first + 1; i <= last; ++i)
    if (position[i] != position[i - 1]) steps.push_back(std::abs(position[i] - position[i - 1]));
  if (steps.empty()) return {values[first]};
  const auto middle = steps.begin() + static_cast<long>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  const double path = position[last] - position[first];
  const long intervals = std::max(1L, std::lround(std::abs(path) / *middle));
  for (long k = 0; k <= intervals; ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(intervals);
    result.push_back(interpolated(position, values, first, last, position[first] + path * part));
  }
  return result;
}

double sliding_partial_slip(double share) {
  if (share < std::sqrt(std::numeric_limits<double>::epsilon())) return 1;
  return 1.5 / share * (1 - std::pow(1 - share, 2.0 / 3.0));
}

double torsion_partial_slip(double share) {
  // Of a contact with K = (16/3) Gt a^3 = 1.
  const LubkinTorsion unit{3.0 / 16.0, 1, 1, 1};
  const double moment = share * unit.full_slip_moment();
  return moment > 0 ? unit.angle(moment) / moment : 1;
}

ReversalStiffness reversal_stiffness(const Values& x, const Values& y, double full_slip,
                                     const PartialSlip& partial_slip) {
  constexpr double most_of_full_slip = 0.95;
  double sum = 0, error = 0;
  int count = 0;
  const auto legs = motion_legs(x);
  for (std::size_t l = 1; l < legs.size(); ++l) {
    const std::size_t turn = legs[l].first;
    if (steady_onset({x, y, {}, {}, 0}, legs[l - 1]) > legs[l - 1].last || legs[l].last < turn + 2) continue;
    double change[2], stiffness[2];
    for (std::size_t i = 0; i < 2; ++i) {
      change[i] = std::abs(y[turn + 1 + i] - y[turn]);
      const double share = change[i] / (2 * full_slip);
      stiffness[i] = share < most_of_full_slip
                         ? change[i] / std::abs(x[turn + 1 + i] - x[turn]) * partial_slip(share)
                         : std::numeric_limits<double>::quiet_NaN();
    }
    const double at_turn = stiffness[0] + (stiffness[0] - stiffness[1]) * change[0] / (change[1] - change[0]);
    if (!std::isfinite(at_turn)) continue;
    sum += at_turn;
    error = std::max(error, std::abs(at_turn - stiffness[0]));
    ++count;
  }
  if (count == 0) return {};
  return {sum / count, error};
}

}  // namespace asperity
