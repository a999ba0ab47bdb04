// How far noise alone moves a driven signal: what turns by less has not turned.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "diagnosis/recording/median.h"

namespace asperity {

/// Standard deviation of a signal's noise, in its unit: that of fourth differences, which a steady or
/// smoothly turning motion leaves out, over 1, 2 or 4 samples, where it is largest: noise that a filter has
/// smoothed shows over some samples only. 0 for fewer than 40 samples.
inline double control_noise(const std::vector<double>& signal) {
  constexpr std::size_t fewest = 40;
  constexpr double median_of_absolute = 0.67449;
  const double gain = std::sqrt(1.0 + 16 + 36 + 16 + 1);  // of white noise by the coefficients below
  if (signal.size() < fewest) return 0;
  double sd = 0;
  for (const std::size_t k : {1, 2, 4}) {
    std::vector<double> sizes;
    for (std::size_t i = 2 * k; i + 2 * k < signal.size(); ++i)
      sizes.push_back(std::abs(signal[i - 2 * k] - 4 * signal[i - k] + 6 * signal[i] - 4 * signal[i + k] +
                               signal[i + 2 * k]));
    sd = std::max(sd, median(sizes) / (median_of_absolute * gain));
  }
  return sd;
}

/// A driven signal averaged over as many neighbours as bring its noise, extreme to extreme, well below
/// `asked`; at most over a fiftieth of the samples.
struct QuietSignal {
  std::vector<double> values;
  double spread = 0;  ///< of the noise that is left, extreme to extreme; at most a tenth of the range, in
                      ///< the unit of the signal
};

/// That of a signal; `asked` in its unit, 0: without averaging.
inline QuietSignal quiet(const std::vector<double>& signal, double asked) {
  constexpr double extremes = 10;  // standard deviations, more than white noise reaches in 1e5 samples
  constexpr double most_of_range = 0.1;
  if (signal.empty()) return {};
  const double spread = extremes * control_noise(signal);
  const auto n = static_cast<long>(signal.size());
  constexpr double well_below = 3;  // neighbours may share noise, which averages leave
  const double wanted = asked > 0 ? std::pow(well_below * spread / asked, 2) : 1;
  const long reach = static_cast<long>(std::min(wanted, static_cast<double>(n) / 50)) / 2;
  QuietSignal found{signal, spread / std::sqrt(2.0 * static_cast<double>(reach) + 1)};
  const auto [low, high] = std::minmax_element(signal.begin(), signal.end());
  found.spread = std::min(found.spread, most_of_range * (*high - *low));
  if (reach == 0) return found;
  // Lines through the neighbours within reach: their mean inside, and no step at the ends.
  std::vector<double> sum{0}, moment{0};  // of the samples before, and of these times their index
  for (long k = 0; k < n; ++k) {
    const double value = signal[static_cast<std::size_t>(k)];
    sum.push_back(sum.back() + value);
    moment.push_back(moment.back() + static_cast<double>(k) * value);
  }
  for (long i = 0; i < n; ++i) {
    const auto first = static_cast<std::size_t>(std::max(0L, i - reach));
    const auto end = static_cast<std::size_t>(std::min(n, i + reach + 1));
    const double count = static_cast<double>(end - first);
    const double centre = 0.5 * static_cast<double>(first + end - 1), mean = (sum[end] - sum[first]) / count;
    const double slope =
        (moment[end] - moment[first] - centre * mean * count) * 12 / (count * (count * count - 1));
    found.values[static_cast<std::size_t>(i)] = mean + slope * (static_cast<double>(i) - centre);
  }
  return found;
}

}  // namespace asperity
