#include "dem_compare/cases/path_averages.h"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>

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

double student_factor(double degrees_of_freedom) {
  constexpr double two_sigma = 0.97724987;  // of one side
  return boost::math::quantile(boost::math::students_t(std::max(1.0, degrees_of_freedom)), two_sigma) / 2;
}

Uncertain mean_of_blocks(const std::vector<double>& values) {
  if (values.empty()) return {std::numeric_limits<double>::quiet_NaN()};
  if (values.size() < 2) return {values.front()};
  const CorrelatedMean mean = correlated_mean(values);
  const double degrees = std::max(1.0, mean.independent - 1);
  return {mean.mean, mean.standard_error * student_factor(degrees), degrees};
}

Uncertain with_stated_error(const Uncertain& mean, double error) {
  if (!std::isfinite(mean.degrees_of_freedom)) return {mean.value, std::hypot(mean.sd, error)};
  const double scatter = mean.sd / student_factor(mean.degrees_of_freedom), both = std::hypot(scatter, error);
  if (!(scatter > 0)) return {mean.value, both};
  const double degrees = mean.degrees_of_freedom * std::pow(both / scatter, 4);
  return {mean.value, both * student_factor(degrees), degrees};
}

std::vector<Uncertain> with_shared_degrees_of_freedom(std::vector<Uncertain> means) {
  double variances = 0, per_degree = 0;
  for (auto& mean : means) {
    if (!std::isfinite(mean.degrees_of_freedom) || !mean.has_sd()) continue;
    mean.sd /= student_factor(mean.degrees_of_freedom);
    const double variance = mean.sd * mean.sd;
    variances += variance;
    per_degree += variance * variance / mean.degrees_of_freedom;
  }
  if (per_degree == 0) return means;
  const double shared = variances * variances / per_degree, factor = student_factor(shared);
  for (auto& mean : means)
    if (std::isfinite(mean.degrees_of_freedom)) mean.sd *= factor, mean.degrees_of_freedom = shared;
  return means;
}

Uncertain mean_of_realisations(const std::vector<Uncertain>& realisations) {
  const std::vector<Uncertain> values = with_shared_degrees_of_freedom(realisations);
  double count = 0, sum = 0, own = 0;
  for (const auto& value : values)
    if (std::isfinite(value.value)) ++count, sum += value.value, own += value.sd * value.sd;
  if (count == 0) return {std::numeric_limits<double>::quiet_NaN()};
  double squares = 0;
  for (const auto& value : values)
    if (std::isfinite(value.value)) squares += std::pow(value.value - sum / count, 2);
  const double of_scatter = count > 1 ? std::sqrt(squares / (count - 1) / count) : 0;
  const double of_each = std::sqrt(own) / count;
  return {sum / count, std::isfinite(of_each) ? std::max(of_each, of_scatter)
                       : count > 2            ? of_scatter * student_factor(count - 1)
                                              : std::numeric_limits<double>::quiet_NaN()};
}

std::vector<double> block_rates(const std::vector<double>& x, const std::vector<double>& sum,
                                std::size_t first, std::size_t last, std::size_t count) {
  const double length = (x[last] - x[first]) / static_cast<double>(count);
  std::vector<double> rates;
  std::size_t i = first;
  double before = sum[first];
  for (std::size_t k = 1; k <= count; ++k) {
    const double end = k == count ? x[last] : x[first] + length * static_cast<double>(k);
    while (i + 1 < last && (length > 0 ? x[i + 1] < end : x[i + 1] > end)) ++i;
    const double here = sum[i] + (end - x[i]) / (x[i + 1] - x[i]) * (sum[i + 1] - sum[i]);
    rates.push_back((here - before) / std::abs(length));
    before = here;
  }
  return rates;
}

}  // namespace asperity
