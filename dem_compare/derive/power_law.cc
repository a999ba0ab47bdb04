#include "dem_compare/derive/power_law.h"

#include <algorithm>
#include <cmath>

#include "dem_compare/numbers/statistics.h"

namespace asperity {

PowerLaw fit_power(const std::vector<CaseNumber>& numbers,
                   const std::function<double(double)>& contact_radius, double exponent) {
  const auto n = static_cast<double>(numbers.size());
  PowerLaw law;
  law.loads = {numbers.front().load, numbers.front().load};
  double log_load = 0, own = 0;
  for (const auto& number : numbers) {
    law.loads.low = std::min(law.loads.low, number.load);
    law.loads.high = std::max(law.loads.high, number.load);
    log_load += std::log(number.load) / n;
    own += number.sd / number.value / n;
  }
  law.at_load = same_load(law.loads.low, law.loads.high) ? law.loads.high : std::exp(log_load);
  std::vector<double> prefactors;
  double mean_a = 0;
  for (const auto& number : numbers) {
    prefactors.push_back(std::log(number.value) - exponent * std::log(contact_radius(number.load)));
    mean_a += std::log(contact_radius(number.load)) / n;
  }
  const Scatter prefactor = scatter_of(prefactors);
  law.value = std::exp(prefactor.mean + exponent * std::log(contact_radius(law.at_load)));
  law.sd = law.value * (std::isnan(own)                        ? prefactor.standard_error
                        : std::isnan(prefactor.standard_error) ? own
                                                               : std::max(own, prefactor.standard_error));
  law.exponent = law.exponent_sd = unknown;
  if (same_load(law.loads.low, law.loads.high)) return law;
  double xx = 0, xy = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double x = std::log(contact_radius(numbers[i].load)) - mean_a;
    xx += x * x, xy += x * (prefactors[i] - prefactor.mean);
  }
  law.exponent = exponent + xy / xx;
  double residual = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    residual += std::pow(
        prefactors[i] - prefactor.mean - xy / xx * (std::log(contact_radius(numbers[i].load)) - mean_a), 2);
  if (numbers.size() > 2) law.exponent_sd = std::sqrt(residual / (n - 2) / xx);
  return law;
}

}  // namespace asperity
