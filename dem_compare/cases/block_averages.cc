#include "dem_compare/cases/block_averages.h"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>

#include "dem_compare/cases/steady_motion.h"

namespace asperity {

double student_factor(double degrees_of_freedom) {
  constexpr double two_sigma = 0.97724987;  // of one side
  return boost::math::quantile(boost::math::students_t(std::max(1.0, degrees_of_freedom)), two_sigma) / 2;
}

Uncertain mean_of_blocks(const std::vector<double>& values) {
  if (values.empty()) return {std::numeric_limits<double>::quiet_NaN()};
  if (values.size() < 2) return {values.front()};
  const CorrelatedMean mean = correlated_mean(values);
  return {mean.mean, mean.standard_error * student_factor(mean.independent - 1)};
}

Uncertain mean_of_realisations(const std::vector<Uncertain>& values) {
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

Uncertain operator+(const Uncertain& a, const Uncertain& b) {
  return {a.value + b.value, std::hypot(a.sd, b.sd)};
}
Uncertain operator-(const Uncertain& a, const Uncertain& b) {
  return {a.value - b.value, std::hypot(a.sd, b.sd)};
}
Uncertain operator*(const Uncertain& a, double factor) { return {a.value * factor, a.sd * std::abs(factor)}; }

Uncertain ratio(const Uncertain& a, const Uncertain& b) {
  const double value = a.value / b.value;
  return {value, std::hypot(a.sd / b.value, value * b.sd / b.value)};
}

}  // namespace asperity
