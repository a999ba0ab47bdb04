#include "fem/output/steady_motion.h"

#include <cmath>

namespace asperity::fem {
namespace {

/// Nodes that have just closed, or lie at the axis of a spin, may stick while the contact slips as a whole.
constexpr double few = 0.02;

template <typename Way, typename Resistance>
std::optional<SteadyResistance> steady(const std::vector<StepRecord>& records, double largest_sticking, const Way& way, const Resistance& resistance) {
  double length = 0, sum = 0, squares = 0;
  for (std::size_t k = 1; k < records.size(); ++k) {
    const double step = way(records[k]) - way(records[k - 1]);
    if (step <= 0 || records[k].sticking_share > largest_sticking || records[k - 1].sticking_share > largest_sticking) continue;
    const double value = resistance(records[k]);
    length += step, sum += step * value, squares += step * value * value;
  }
  if (length == 0) return std::nullopt;
  const double mean = sum / length;
  return SteadyResistance{mean, std::sqrt(std::max(0.0, squares / length - mean * mean)), length};
}

}  // namespace

std::optional<SteadyResistance> steady_sliding(const std::vector<StepRecord>& records) {
  return steady(records, few, [](const StepRecord& r) { return r.shift; }, [](const StepRecord& r) { return r.lateral_force / r.normal_force; });
}

std::optional<SteadyResistance> steady_torsion(const std::vector<StepRecord>& records) {
  return steady(records, few, [](const StepRecord& r) { return r.torsion_angle; }, [](const StepRecord& r) { return r.torsion_moment; });
}

}  // namespace asperity::fem
