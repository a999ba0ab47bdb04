#include "dem_compare/compare/finite_element_column.h"

#include <algorithm>
#include <functional>

#include "dem_compare/cases/moving_case.h"
#include "dem_compare/cases/parameter_sets.h"

namespace asperity {
namespace {

/// Absent where the case has none.
ComparedValue effective(const SolvedCase& solved, const char* name) {
  const EffectiveNumber number = solved.effective(name);
  return {number.value, number.sd};
}

ComparedValue scaled(ComparedValue value, double factor) {
  value.value *= factor;
  value.sd *= std::abs(factor);
  return value;
}

/// Steady resistance over load and `length`; where the history has no steady path, what the solver says.
ComparedValue steady_over_load(const SolvedCase& solved, const MotionMode& mode, double length,
                               const ComparedValue& otherwise) {
  if (solved.motion() != mode.motion || solved.history.size() == 0) return otherwise;
  const MovingCase moving = moving_case(solved, mode);
  if (!moving.reached()) return moving.has_energies() ? ComparedValue{} : otherwise;
  const Uncertain resistance = moving.resistance();
  return scaled({resistance.value, resistance.sd}, 1 / (moving.load * length));
}

FiniteElementValue value_of(const std::vector<ComparedValue>& cases) {
  std::vector<double> values, own;
  FiniteElementValue result;
  for (const auto& one : cases) {
    if (!one.known()) continue;
    values.push_back(one.value);
    own.push_back(one.sd);
    result.sd = one.sd;
  }
  const Scatter scatter = scatter_of(values);
  result.realisations = scatter.count;
  if (scatter.count == 0) return result;
  result.value = scatter.mean;
  // Few realisations may agree by chance: not better than each is known by itself.
  if (scatter.count > 1) result.sd = std::fmax(scatter.sd, scatter_of(own).mean);
  result.source =
      scatter.count > 1 ? "mean of " + std::to_string(scatter.count) + " realisations" : "one case";
  return result;
}

FiniteElementValue value_of(const Estimate& estimate, double own_sd) {
  FiniteElementValue value;
  value.value = estimate.mean;
  value.sd = estimate.count > 1 ? estimate.sd : own_sd;
  value.realisations = estimate.count;
  if (estimate.mesh) value.mesh_error = estimate.mesh->relative_error;
  value.source =
      estimate.count > 1 ? "mean of " + std::to_string(estimate.count) + " realisations" : "one case";
  return value;
}

void add_normal(std::vector<FiniteElementPoint>& points, std::size_t g, const CaseGroup& group,
                const GroupComparison& compared) {
  if (compared.loads.empty()) return;
  const bool is_normal = group.first().motion() == Motion::normal;
  for (std::size_t i = is_normal ? 0 : compared.loads.size() - 1; i < compared.loads.size(); ++i) {
    const LoadComparison& load = compared.loads[i];
    const bool is_largest = i + 1 == compared.loads.size();
    const double sd = is_largest ? effective(group.first(), "normal_stiffness").sd : NAN;
    for (const auto& [quantity, value] :
         {std::pair{Quantity::approach, value_of(load.approach, NAN)},
          std::pair{Quantity::normal_stiffness, value_of(load.stiffness, sd)}})
      if (value.known()) points.push_back({g, quantity, load.force, value});
  }
}

/// Of each case of a group.
void add(std::vector<FiniteElementPoint>& points, std::size_t g, const CaseGroup& group, Quantity quantity,
         double load, const std::function<ComparedValue(const SolvedCase&)>& number) {
  std::vector<ComparedValue> cases;
  for (const auto& solved : group.cases) cases.push_back(number(solved));
  const FiniteElementValue value = value_of(cases);
  if (value.known()) points.push_back({g, quantity, load, value});
}

}  // namespace

double stiffness_to_sliding(const History& history, double sliding_force) {
  // From the last step at rest to the first one that slides.
  const std::size_t size = history.lateral_force.size();
  constexpr double rest = 1e-2, sliding = 0.98;
  std::size_t first = 0;
  while (first + 1 < size && std::abs(history.lateral_force[first + 1]) < rest * sliding_force) ++first;
  double deficit_work = 0;
  const auto power = [&](std::size_t i) {
    return std::pow(std::max(0.0, sliding_force - std::abs(history.lateral_force[i])), 2.0 / 3.0);
  };
  for (std::size_t i = first; i + 1 < size; ++i) {
    const double path = std::abs(history.lateral_displacement[i + 1] - history.lateral_displacement[i]);
    const double from = power(i), to = power(i + 1);
    const double mean = std::abs(from - to) < 1e-9 * from
                            ? std::pow(from, 1.5)
                            : 0.4 * (std::pow(from, 2.5) - std::pow(to, 2.5)) / (from - to);
    deficit_work += mean * path;
    if (std::abs(history.lateral_force[i + 1]) >= sliding * sliding_force)
      return sliding_force * sliding_force / (2 * deficit_work);
  }
  return NAN;
}

std::vector<FiniteElementPoint> finite_element_points(const CaseCollection& collection,
                                                      const Comparison& comparison) {
  std::vector<FiniteElementPoint> points;
  for (std::size_t g = 0; g < collection.groups.size(); ++g) {
    const CaseGroup& group = collection.groups[g];
    const GroupComparison& compared = comparison.groups[g];
    if (!compared.is_finest) continue;
    add_normal(points, g, group, compared);
    const double load = compared.numbers.force, radius = compared.numbers.hertz.radius;
    const auto plain = [](const char* name) {
      return [name](const SolvedCase& solved) { return effective(solved, name); };
    };
    add(points, g, group, Quantity::lateral_stiffness, load, plain("lateral_stiffness"));
    add(points, g, group, Quantity::lateral_stiffness_to_sliding, load,
        [&](const SolvedCase& solved) -> ComparedValue {
          const ComparedValue friction = effective(solved, "sliding_friction"),
                              tangent = effective(solved, "lateral_stiffness");
          if (!friction.known()) return {};
          const double k = stiffness_to_sliding(solved.history, friction.value * load);
          // The doubt about the contact's radius is the tangent's too.
          return {k, k * tangent.sd / tangent.value};
        });
    add(points, g, group, Quantity::sliding_friction, load, [&](const SolvedCase& solved) {
      return steady_over_load(solved, sliding_mode(), 1, effective(solved, "sliding_friction"));
    });
    add(points, g, group, Quantity::rolling_stiffness, load, [](const SolvedCase& solved) -> ComparedValue {
      const auto moving =
          solved.motion() == Motion::rolling ? moving_case(solved, rolling_mode()) : MovingCase{};
      if (!moving.reached() || !moving.has_energies()) return effective(solved, "rolling_stiffness");
      return {moving.reversal.value, moving.reversal.error};
    });
    add(points, g, group, Quantity::rolling_friction, load, [&](const SolvedCase& solved) {
      return steady_over_load(solved, rolling_mode(), radius,
                              scaled(effective(solved, "rolling_dissipation"), 1 / (load * radius)));
    });
    add(points, g, group, Quantity::torsion_stiffness, load, plain("torsion_stiffness"));
    add(points, g, group, Quantity::torsion_friction, load, [&](const SolvedCase& solved) {
      return steady_over_load(solved, torsion_mode(), radius,
                              scaled(effective(solved, "torsion_moment"), 1 / (load * radius)));
    });
  }
  return points;
}

}  // namespace asperity
