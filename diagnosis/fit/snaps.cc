#include "diagnosis/fit/snaps.h"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

/// A step of the simulated response that is a snap: a part of the whole range, and so many times the steps
/// beside it.
constexpr double part_of_range = 0.02, times_neighbours = 5;

class Run {
 public:
  Run(const SampleRun& run, const std::vector<double>& simulated) : run_(run), simulated_(simulated) {
    const auto [least, most] = std::minmax_element(simulated.begin() + static_cast<std::ptrdiff_t>(run.begin),
                                                   simulated.begin() + static_cast<std::ptrdiff_t>(run.end));
    range_ = *most - *least;
  }
  /// Whether the response snaps between sample i and the next.
  bool snaps_after(std::size_t i) const {
    const double here = step(i);
    if (!(here > part_of_range * range_)) return false;
    const double before = i > run_.begin ? step(i - 1) : 0, after = i + 2 < run_.end ? step(i + 1) : 0;
    return here > times_neighbours * std::max(before, after);
  }

 private:
  double step(std::size_t i) const { return std::abs(simulated_[i + 1] - simulated_[i]); }

  const SampleRun& run_;
  const std::vector<double>& simulated_;
  double range_;
};

}  // namespace

namespace {

/// On the other side of a snap, after which the simulated response is `other_side` more, and between.
void forgive_between(const Sample& sample, double other_side, double& residual) {
  if (!sample.counts || residual * other_side <= 0) return;
  residual = other_side > 0 ? std::max(0.0, residual - other_side) : std::min(0.0, residual - other_side);
}

/// Samples whose displacement is nearer to the snap after sample i than a load step tells.
void forgive_within_a_load_step(const Samples& samples, const SampleRun& run, std::size_t i, double snap,
                                std::vector<double>& residual) {
  if (run.response_is_displacement || !(samples.snap_width > 0)) return;
  const auto place = [&](std::size_t at) { return samples.list[at].normal_displacement; };
  const double here = 0.5 * (place(i) + place(i + 1));
  const auto is_near = [&](std::size_t at) { return std::abs(place(at) - here) <= samples.snap_width; };
  for (std::size_t at = i + 1; at-- > run.begin && is_near(at);)
    forgive_between(samples.list[at], snap, residual[at]);
  for (std::size_t at = i + 1; at < run.end && is_near(at); ++at)
    forgive_between(samples.list[at], -snap, residual[at]);
}

}  // namespace

void forgive_a_sample_at_snaps(const Samples& samples, const std::vector<double>& simulated,
                               std::vector<double>& residual) {
  for (const SampleRun& run : samples.runs) {
    const bool is_normal = run.table < samples.response_channels.size() &&
                           samples.response_channels[run.table].rfind("normal_", 0) == 0;
    if (!is_normal || run.independent_rows || run.end < run.begin + 2) continue;
    const Run response(run, simulated);
    for (std::size_t i = run.begin; i + 1 < run.end; ++i) {
      if (!response.snaps_after(i)) continue;
      const double snap = simulated[i + 1] - simulated[i];
      const auto take_nearer = [&](std::size_t at, double to_other_side) {
        if (samples.list[at].counts && std::abs(residual[at] + to_other_side) < std::abs(residual[at]))
          residual[at] += to_other_side;
      };
      forgive_within_a_load_step(samples, run, i, snap, residual);
      take_nearer(i, -snap);
      take_nearer(i + 1, snap);
    }
  }
}

}  // namespace asperity
