#include "diagnosis/fit/shared_noise.h"

#include <algorithm>
#include <cmath>

namespace asperity {

NoiseFilter::NoiseFilter(const Samples& samples, const std::vector<double>& sd,
                         const std::vector<SharedNoise>& shared)
    : place_(samples.list.size()),
      sd_(samples.list.size()),
      decay_(samples.list.size()),
      gain_(samples.list.size()),
      deviation_(samples.list.size()) {
  for (std::size_t r = 0; r < samples.runs.size(); ++r) {
    const SampleRun& run = samples.runs[r];
    const SharedNoise noise = run.independent_rows ? SharedNoise{} : shared[r];
    double variance = noise.share;  // of x as it is known before the sample
    std::size_t last = run.end;
    for (std::size_t i = run.begin; i < run.end; ++i) {
      const Sample& s = samples.list[i];
      if (!s.counts) continue;
      sd_[i] = sd[s.index];
      if (last < i && noise.share > 0) {
        decay_[i] = std::pow(noise.memory, static_cast<double>(s.index - samples.list[last].index));
        variance = decay_[i] * decay_[i] * variance + noise.share * (1 - decay_[i] * decay_[i]);
      }
      const double innovation = variance + 1 - noise.share;
      gain_[i] = variance / innovation;
      deviation_[i] = std::sqrt(innovation);
      variance *= 1 - gain_[i];
      log_determinant_ += std::log(innovation);
      last = i;
      place_[i] = static_cast<Eigen::Index>(counted_.size());
      counted_.push_back(i);
    }
  }
}

std::vector<double> NoiseFilter::whitened(const std::vector<double>& residual) const {
  std::vector<double> white;
  white.reserve(counted_.size());
  double known = 0;  // x
  for (const std::size_t i : counted_) {
    known *= decay_[i];
    const double innovation = residual[i] / sd_[i] - known;
    known += gain_[i] * innovation;
    white.push_back(innovation / deviation_[i]);
  }
  return white;
}

void NoiseFilter::whiten(const std::vector<std::size_t>& samples, Eigen::MatrixXd& columns) const {
  Eigen::RowVectorXd known = Eigen::RowVectorXd::Zero(columns.cols()), innovation;
  for (Eigen::Index row = 0; row < columns.rows(); ++row) {
    const std::size_t i = samples[static_cast<std::size_t>(row)];
    known *= decay_[i];
    innovation = columns.row(row) / sd_[i] - known;
    known += gain_[i] * innovation;
    columns.row(row) = innovation / deviation_[i];
  }
}

MeasuredNoise measured_noise(const Samples& samples, const std::vector<double>& residual,
                             const std::vector<double>& sd, std::size_t table) {
  constexpr double far = 4;      // single large ones say nothing of what neighbours share
  constexpr double clearly = 3;  // log likelihood by which noise must be other than white
  constexpr double step = 0.1;
  Samples own = samples;
  own.runs.clear();
  for (const auto& run : samples.runs)
    if (run.table == table) own.runs.push_back(run);
  // Without outliers, and with the scale on which they are some.
  std::vector<double> sizes, kept = residual;
  for (const auto& run : own.runs)
    for (std::size_t i = run.begin; i < run.end; ++i)
      if (own.list[i].counts) sizes.push_back(std::abs(residual[i] / sd[own.list[i].index]));
  if (sizes.empty()) return {};
  std::nth_element(sizes.begin(), sizes.begin() + static_cast<long>(sizes.size() / 2), sizes.end());
  const double scale = 1.4826 * sizes[sizes.size() / 2];
  for (const auto& run : own.runs)
    for (std::size_t i = run.begin; i < run.end; ++i) {
      const double most = far * scale * sd[own.list[i].index];
      kept[i] = std::clamp(kept[i], -most, most);
    }
  const auto likelihood = [&](const SharedNoise& shared, double& variance) {
    const NoiseFilter filter(own, sd, std::vector<SharedNoise>(own.runs.size(), shared));
    const auto white = filter.whitened(kept);
    double sum = 0;
    for (const double value : white) sum += value * value;
    const auto count = static_cast<double>(white.size());
    variance = sum / count;
    return -0.5 * count * std::log(std::max(variance, 1e-300)) - 0.5 * filter.log_determinant();
  };
  MeasuredNoise best;
  double variance = 1;
  const double white = likelihood({}, variance);
  best.sd = std::sqrt(variance);
  double most = white + clearly;
  for (double share = step; share < 1 + 0.5 * step; share += step)
    for (double memory = step; memory < largest_memory + 0.5 * step; memory += step) {
      const double now = likelihood({std::min(1.0, share), memory}, variance);
      if (now <= most) continue;
      most = now;
      best = {std::sqrt(variance), {std::min(1.0, share), memory}};
    }
  return best;
}

}  // namespace asperity
