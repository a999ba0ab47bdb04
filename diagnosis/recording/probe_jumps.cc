#include "diagnosis/recording/probe_jumps.h"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

/// Speed that a twentieth of a run's samples stays above [m/s].
double driven_speed(const Samples& samples, const SampleRun& run) {
  constexpr double part = 0.95;
  std::vector<double> speeds;
  for (std::size_t i = run.begin; i < run.end; ++i) speeds.push_back(std::abs(samples.list[i].approach));
  const auto at =
      speeds.begin() + static_cast<long>(std::floor(part * static_cast<double>(speeds.size() - 1)));
  std::nth_element(speeds.begin(), at, speeds.end());
  return *at;
}

}  // namespace

std::size_t mark_probe_jumps(Samples& samples) {
  constexpr double times_faster = 2;
  constexpr std::size_t run_over_longest = 50;
  std::size_t marked = 0;
  for (const SampleRun& run : samples.runs) {
    if (run.independent_rows || run.response_is_displacement || run.end == run.begin) continue;
    const double fastest = times_faster * driven_speed(samples, run);
    std::vector<std::size_t> jumping;
    for (std::size_t i = run.begin; i < run.end; ++i)
      if (fastest > 0 && std::abs(samples.list[i].approach) > fastest) jumping.push_back(i);
    if (jumping.size() * run_over_longest > run.end - run.begin) continue;
    for (const std::size_t i : jumping) {
      marked += samples.list[i].counts;
      samples.list[i].counts = false;
    }
  }
  return marked;
}

}  // namespace asperity
