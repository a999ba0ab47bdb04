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
    if (step == 0 || records[k].sticking_share > largest_sticking || records[k - 1].sticking_share > largest_sticking) continue;
    const double value = std::copysign(1.0, step) * resistance(records[k]), weight = std::abs(step);
    length += weight, sum += weight * value, squares += weight * value * value;
  }
  if (length == 0) return std::nullopt;
  const double mean = sum / length;
  return SteadyResistance{mean, std::sqrt(std::max(0.0, squares / length - mean * mean)), length};
}

}  // namespace

std::optional<SteadyResistance> steady_sliding(const std::vector<StepRecord>& records) {
  return steady(records, few, [](const StepRecord& r) { return r.shift; }, [](const StepRecord& r) { return r.lateral_force / r.normal_force; });
}

namespace {

/// Calls `visit(k, step, is_steady)` for each row that has rolled by `step` since the one before, steady where the contact has rolled by
/// more than its radius since it began or turned.
template <typename Visit>
void for_rolled_rows(const std::vector<StepRecord>& records, double radius, const Visit& visit) {
  double since_reversal = 0, direction = 0;
  for (std::size_t k = 1; k < records.size(); ++k) {
    const double step = records[k].rolling_angle - records[k - 1].rolling_angle;
    if (step == 0) continue;
    if (step * direction <= 0) since_reversal = 0;
    direction = step;
    since_reversal += std::abs(step);
    visit(k, step, since_reversal * radius >= records[k].pressure_radius);
  }
}

}  // namespace

std::optional<double> rolling_dissipation(const std::vector<StepRecord>& records, double radius) {
  double angle = 0, energy = 0, steady_angle = 0, steady_energy = 0;
  for_rolled_rows(records, radius, [&](std::size_t k, double step, bool is_steady) {
    const double lost = records[k].dissipated_energy - records[k - 1].dissipated_energy;
    angle += std::abs(step), energy += lost;
    if (is_steady) steady_angle += std::abs(step), steady_energy += lost;
  });
  if (angle == 0) return std::nullopt;
  return steady_angle > 0 ? steady_energy / steady_angle : energy / angle;
}

std::optional<SteadyResistance> steady_rolling(const std::vector<StepRecord>& records, double radius) {
  double length = 0, sum = 0, squares = 0;
  for_rolled_rows(records, radius, [&](std::size_t k, double step, bool is_steady) {
    if (!is_steady) return;
    const double value = std::copysign(1.0, step) * records[k].rolling_moment;
    length += std::abs(step), sum += std::abs(step) * value, squares += std::abs(step) * value * value;
  });
  if (length == 0) return std::nullopt;
  const double mean = sum / length;
  return SteadyResistance{mean, std::sqrt(std::max(0.0, squares / length - mean * mean)), length};
}

std::optional<SteadyResistance> steady_torsion(const std::vector<StepRecord>& records) {
  return steady(records, few, [](const StepRecord& r) { return r.torsion_angle; }, [](const StepRecord& r) { return r.torsion_moment; });
}

}  // namespace asperity::fem
