#include "dem_compare/experiments/friction_loop.h"

#include <cmath>
#include <functional>
#include <limits>

#include "core/csv.h"
#include "core/error.h"

namespace asperity {
namespace {

/// First row of each leg; a leg starts from the row before.
std::vector<std::size_t> leg_starts(const FrictionLoop& loop) {
  std::vector<std::size_t> starts;
  for (std::size_t i = 1; i < loop.rows.size(); ++i)
    if (i == 1 || loop.rows[i].leg != loop.rows[i - 1].leg) starts.push_back(i);
  return starts;
}

double slope_at(const FrictionLoop& loop, std::size_t row) {
  const LoopRow &from = loop.rows[row - 1], &to = loop.rows[row];
  return (to.lateral_force - from.lateral_force) / (to.indenter_displacement - from.indenter_displacement);
}

double work(const FrictionLoop& loop, std::size_t from, std::size_t to) {
  double sum = 0;
  for (std::size_t i = from; i < to; ++i)
    sum += (loop.rows[i].lateral_force + loop.rows[i + 1].lateral_force) / 2 *
           (loop.rows[i + 1].indenter_displacement - loop.rows[i].indenter_displacement);
  return sum;
}

}  // namespace

LoopNumbers measure(const FrictionLoop& loop) {
  const std::vector<std::size_t> starts = leg_starts(loop);
  if (starts.size() < 2)
    throw InputError("a friction loop without a reversal has no plateau to measure; give one cycle or more");
  const std::size_t reversal = starts.back(), end = loop.rows.size() - 1;
  const LoopRow &left = loop.rows[reversal - 1], &right = loop.rows[end];
  LoopNumbers numbers;
  numbers.initial_slope = slope_at(loop, 1);
  numbers.reversal_slope = slope_at(loop, reversal);
  numbers.plateau = std::abs(right.lateral_force - left.lateral_force) / 2;
  numbers.offset = (right.lateral_force + left.lateral_force) / 2;
  numbers.reversal_travel = 2 * numbers.plateau / numbers.reversal_slope;
  constexpr double nearly_all = 0.999;
  const double target = left.lateral_force + nearly_all * (right.lateral_force - left.lateral_force);
  for (std::size_t i = reversal; i <= end; ++i) {
    const LoopRow &from = loop.rows[i - 1], &to = loop.rows[i];
    if ((to.lateral_force - target) * (right.lateral_force - left.lateral_force) < 0) continue;
    const double part = (target - from.lateral_force) / (to.lateral_force - from.lateral_force);
    numbers.plateau_travel = std::abs(from.indenter_displacement - left.indenter_displacement +
                                      part * (to.indenter_displacement - from.indenter_displacement));
    break;
  }
  numbers.dissipation = starts.size() >= 3 ? work(loop, starts[starts.size() - 2] - 1, end)
                                           : std::numeric_limits<double>::quiet_NaN();
  return numbers;
}

std::string to_csv(const FrictionLoop& loop) {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;
  const auto add = [&](const std::string& name, const std::function<double(const LoopRow&)>& value) {
    names.push_back(name);
    columns.emplace_back();
    for (const LoopRow& row : loop.rows) columns.back().push_back(value(row));
  };
  add("leg", [](const LoopRow& row) { return row.leg; });
  add("indenter_displacement [m]", [](const LoopRow& row) { return row.indenter_displacement; });
  add("lateral_force [N]", [](const LoopRow& row) { return row.lateral_force; });
  add("normal_force [N]", [](const LoopRow& row) { return row.normal_force; });
  const char* axes[] = {"x", "y", "z"};
  for (int k = 0; k < 3; ++k)
    add(std::string("particle_displacement_") + axes[k] + " [m]",
        [k](const LoopRow& row) { return row.displacement[k]; });
  for (int k = 0; k < 3; ++k)
    add(std::string("particle_rotation_") + axes[k] + " [rad]",
        [k](const LoopRow& row) { return row.rotation[k]; });
  for (std::size_t c = 0; c < loop.contact_names.size(); ++c) {
    const std::string& name = loop.contact_names[c];
    add(name + "_approach [m]", [c](const LoopRow& row) { return row.contacts[c].approach; });
    add(name + "_normal_force [N]", [c](const LoopRow& row) { return row.contacts[c].normal_force; });
    for (int k = 0; k < 3; ++k)
      add(name + "_lateral_force_" + axes[k] + " [N]",
          [c, k](const LoopRow& row) { return row.contacts[c].lateral[k]; });
    for (int k = 0; k < 3; ++k)
      add(name + "_rolling_moment_" + axes[k] + " [N m]",
          [c, k](const LoopRow& row) { return row.contacts[c].rolling_moment[k]; });
    add(name + "_torsion_moment [N m]", [c](const LoopRow& row) { return row.contacts[c].torsion_moment; });
    add(name + "_slides", [c](const LoopRow& row) { return row.contacts[c].slides; });
    add(name + "_rolls", [c](const LoopRow& row) { return row.contacts[c].rolls; });
    add(name + "_twists", [c](const LoopRow& row) { return row.contacts[c].twists; });
  }
  return format_csv(names, columns);
}

ContactRecord record_of(const ContactModelState& state) {
  return {state.normal.approach,     state.normal.force,        state.lateral,
          -state.rolling.resistance, -state.torsion.resistance, state.sliding.spring.yields,
          state.rolling.yields,      state.torsion.yields};
}

}  // namespace asperity
