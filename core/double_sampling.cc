#include "core/double_sampling.h"

#include <cmath>

#include "core/error.h"

namespace asperity {
namespace {

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// Of the mean: sample variance over the number of samples.
double variance_of_mean(const std::vector<double>& values) {
  const double mean = mean_of(values);
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return sum / static_cast<double>((values.size() - 1) * values.size());
}

}  // namespace

MethodRatio method_ratio(const std::vector<double>& cheap, const std::vector<double>& dear) {
  if (dear.size() < 2 || cheap.size() != dear.size() || mean_of(cheap) == 0)
    throw InputError(
        "a ratio of two methods needs two samples or more that both have, and a mean that is not 0");
  MethodRatio found{mean_of(dear) / mean_of(cheap), 0};
  std::vector<double> left(dear.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = dear[i] - found.ratio * cheap[i];
  found.sd = std::sqrt(variance_of_mean(left));
  return found;
}

SampledMean mean_by_double_sampling(const std::vector<double>& all, const std::vector<double>& cheap,
                                    const std::vector<double>& dear) {
  const MethodRatio both = method_ratio(cheap, dear);
  return {both.ratio * mean_of(all), std::hypot(both.sd, both.ratio * std::sqrt(variance_of_mean(all)))};
}

}  // namespace asperity
