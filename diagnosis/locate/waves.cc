#include "diagnosis/locate/waves.h"

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <complex>

#include "diagnosis/recording/median.h"

namespace asperity {
namespace {

constexpr std::size_t block = 128;  // samples of a periodogram

/// Power at 0 to `block`/2 cycles in a block, outliers cut and tapered by Hann's window.
void add_periodogram(const double* values, std::vector<double>& power) {
  constexpr double far = 4;
  std::vector<double> tapered(block);
  double mean = 0;
  for (std::size_t i = 0; i < block; ++i) {
    tapered[i] = std::clamp(values[i], -far, far);
    mean += tapered[i] / block;
  }
  for (std::size_t i = 0; i < block; ++i)
    tapered[i] = (tapered[i] - mean) * (1 - std::cos(2 * M_PI * (static_cast<double>(i) + 0.5) / block));
  for (std::size_t k = 0; k < power.size(); ++k) {
    std::complex<double> sum = 0;
    for (std::size_t i = 0; i < block; ++i)
      sum += tapered[i] * std::polar(1.0, -2 * M_PI * static_cast<double>(i * k % block) / block);
    power[k] += std::norm(sum);
  }
}

/// Median of the power about a frequency, without what a line there leaks into.
double power_about(const std::vector<double>& power, std::size_t at) {
  constexpr std::size_t leaks = 2, reach = 10;
  std::vector<double> near;
  for (std::size_t k = std::max<std::size_t>(1, at > reach ? at - reach : 1);
       k < std::min(power.size(), at + reach + 1); ++k)
    if (k + leaks < at || k > at + leaks) near.push_back(power[k]);
  return median(near);
}

}  // namespace

double wave_left(const Samples& samples, const std::vector<double>& residual, const Noise& noise) {
  constexpr double longest = 40, shortest = 3, plain = 3, chance = 1e-6;
  const NoiseFilter filter(samples, noise.sd, noise.shared);
  const std::vector<double> white = filter.whitened(residual);
  std::vector<double> power(block / 2 + 1, 0.0);
  int blocks = 0;
  for (const auto& run : samples.runs) {
    if (run.independent_rows) continue;
    std::vector<double> counted;
    for (std::size_t i = run.begin; i < run.end; ++i)
      if (samples.list[i].counts) counted.push_back(white[static_cast<std::size_t>(filter.place(i))]);
    for (std::size_t from = 0; from + block <= counted.size(); from += block, ++blocks)
      add_periodogram(counted.data() + from, power);
  }
  if (blocks == 0) return 0;
  const auto lowest = static_cast<std::size_t>(std::ceil(block / longest)),
             highest = static_cast<std::size_t>(block / shortest);
  double stands_out = 0;
  std::size_t line = 0;
  for (std::size_t k = lowest; k <= highest; ++k) {
    const double about = power_about(power, k);
    if (about > 0 && power[k] / about > stands_out) stands_out = power[k] / about, line = k;
  }
  // Means of `blocks` exponential variables over their median, which is (Wilson & Hilferty) less than their
  // mean.
  const double of_mean = stands_out * std::pow(1 - 1.0 / (9 * blocks), 3);
  const double lines = static_cast<double>(highest - lowest + 1);
  const bool is_seldom = lines * boost::math::gamma_q(static_cast<double>(blocks), blocks * of_mean) < chance;
  return is_seldom && stands_out > plain ? static_cast<double>(block) / static_cast<double>(line) : 0;
}

}  // namespace asperity
