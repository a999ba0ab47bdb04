#include "diagnosis/recording/smoothed_control.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

struct Smoothed {
  double value, gain;  ///< of the channel, and of its noise [-]
};

/// The parabola through `values` from first to end, at `at`.
Smoothed by_parabola(const std::vector<double>& values, std::size_t first, std::size_t end, std::size_t at) {
  const double scale = static_cast<double>(end - first);
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t k = first; k < end; ++k) {
    const double x = (static_cast<double>(k) - static_cast<double>(at)) / scale;
    const Eigen::Vector3d terms(1, x, x * x);
    normal += terms * terms.transpose();
    right += terms * (values[k] - values[at]);
  }
  const Eigen::Vector3d weights = normal.ldlt().solve(Eigen::Vector3d::UnitX());
  return {values[at] + weights.dot(right), std::sqrt(weights(0))};
}

}  // namespace

std::vector<double> smooth_control(Samples& samples, const SampleRun& run, double Sample::*channel,
                                   double wanted) {
  constexpr std::size_t most = 50, fewest = 12, least = 2;  // three samples at an end make a parabola
  constexpr double of_parabola = 9.0 / 4;                   // variance of its middle, over that of a mean
  const auto asked = static_cast<std::size_t>(std::ceil(of_parabola / std::max(1e-6, wanted * wanted) / 2));
  std::vector<double> left(run.end - run.begin, 1.0);
  if (wanted >= 1) return left;
  for (std::size_t from = run.begin, to = from; from < run.end; from = to) {
    std::vector<double> values;
    for (; to < run.end && samples.list[to].part == samples.list[from].part; ++to)
      values.push_back(samples.list[to].*channel);
    if (values.size() < fewest) continue;
    const std::size_t n = values.size(), reach = std::min({std::max(least, asked), most, n / 8 + 1});
    for (std::size_t i = 0; i < n; ++i) {
      const Smoothed s = by_parabola(values, i < reach ? 0 : i - reach, std::min(n, i + reach + 1), i);
      samples.list[from + i].*channel = s.value;
      left[from + i - run.begin] = s.gain;
    }
  }
  return left;
}

}  // namespace asperity
