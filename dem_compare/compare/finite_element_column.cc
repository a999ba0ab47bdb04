#include "dem_compare/compare/finite_element_column.h"

#include <algorithm>
#include <functional>

#include "dem_compare/derive/parameter_sets.h"
#include "dem_compare/derive/rolling_stiffness.h"
#include "dem_compare/derive/steady_motion.h"
#include "dem_compare/resistance/moving_case.h"

namespace asperity {
namespace {

/// Steady lateral force or moment over its divisor, both ways: there and back the slopes of asperities push in opposite
/// directions. Where the history has no steady stretch, what the solver says.
ComparedValue steady(const SolvedCase& solved, std::vector<double> ContactHistory::*position,
                     std::vector<double> ContactHistory::*resistance, double divisor, const ComparedValue& otherwise) {
  if (solved.history.size() == 0 || !otherwise.known()) return otherwise;
  const SteadyResistance found =
      steady_resistance(solved.history.*position, solved.history.*resistance, solved.history.normal_force);
  if (!found.reached) return otherwise;
  return {found.mean / divisor, found.standard_error / divisor};
}

/// An entry of "effective" in result.json; absent where the case has none.
ComparedValue effective(const SolvedCase& solved, const char* name) {
  if (!solved.finished() || !solved.result.contains("effective") || !solved.result["effective"].contains(name)) return {};
  const auto& entry = solved.result["effective"][name];
  const auto number = [&](const char* key) {
    return entry.contains(key) && entry[key].is_number() ? entry[key].get<double>() : NAN;
  };
  return {number("value"), number("sd")};
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
  result.source = scatter.count > 1 ? "mean of " + std::to_string(scatter.count) + " realisations" : "one case";
  return result;
}

FiniteElementValue value_of(const Estimate& estimate, double own_sd) {
  FiniteElementValue value;
  value.value = estimate.mean;
  value.sd = estimate.count > 1 ? estimate.sd : own_sd;
  value.realisations = estimate.count;
  if (estimate.mesh) value.mesh_error = estimate.mesh->relative_error;
  value.source = estimate.count > 1 ? "mean of " + std::to_string(estimate.count) + " realisations" : "one case";
  return value;
}

void add_normal(std::vector<FiniteElementPoint>& points, std::size_t g, const CaseGroup& group,
                const GroupComparison& compared) {
  if (compared.loads.empty()) return;
  const bool is_normal = experiment_of(group.first()) == "normal";
  for (std::size_t i = is_normal ? 0 : compared.loads.size() - 1; i < compared.loads.size(); ++i) {
    const LoadComparison& load = compared.loads[i];
    const bool is_largest = i + 1 == compared.loads.size();
    const double sd = is_largest ? effective(group.first(), "normal_stiffness").sd : NAN;
    for (const auto& [quantity, value] : {std::pair{Quantity::approach, value_of(load.approach, NAN)},
                                          std::pair{Quantity::normal_stiffness, value_of(load.stiffness, sd)}})
      if (value.known()) points.push_back({g, quantity, load.force, value});
  }
}

/// Of each case of a group.
void add(std::vector<FiniteElementPoint>& points, std::size_t g, const CaseGroup& group, Quantity quantity, double load,
         const std::function<ComparedValue(const SolvedCase&)>& number) {
  std::vector<ComparedValue> cases;
  for (const auto& solved : group.cases) cases.push_back(number(solved));
  const FiniteElementValue value = value_of(cases);
  if (value.known()) points.push_back({g, quantity, load, value});
}

ComparedValue scaled(ComparedValue value, double factor) {
  value.value *= factor;
  value.sd *= std::abs(factor);
  return value;
}

}  // namespace

double stiffness_to_sliding(const ContactHistory& history, double sliding_force) {
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
    const double way = std::abs(history.lateral_displacement[i + 1] - history.lateral_displacement[i]);
    const double from = power(i), to = power(i + 1);
    const double mean =
        std::abs(from - to) < 1e-9 * from ? std::pow(from, 1.5) : 0.4 * (std::pow(from, 2.5) - std::pow(to, 2.5)) / (from - to);
    deficit_work += mean * way;
    if (std::abs(history.lateral_force[i + 1]) >= sliding * sliding_force)
      return sliding_force * sliding_force / (2 * deficit_work);
  }
  return NAN;
}

std::vector<FiniteElementPoint> finite_element_points(const CaseCollection& collection, const Comparison& comparison) {
  std::vector<FiniteElementPoint> points;
  for (std::size_t g = 0; g < collection.groups.size(); ++g) {
    const CaseGroup& group = collection.groups[g];
    const GroupComparison& compared = comparison.groups[g];
    if (!compared.is_finest) continue;
    add_normal(points, g, group, compared);
    const double load = compared.numbers.force, radius = compared.numbers.hertz.radius;
    const auto plain = [](const char* name) { return [name](const SolvedCase& solved) { return effective(solved, name); }; };
    add(points, g, group, Quantity::lateral_stiffness, load, plain("lateral_stiffness"));
    add(points, g, group, Quantity::lateral_stiffness_to_sliding, load, [&](const SolvedCase& solved) -> ComparedValue {
      const ComparedValue friction = effective(solved, "sliding_friction"), tangent = effective(solved, "lateral_stiffness");
      if (!friction.known()) return {};
      const double k = stiffness_to_sliding(solved.history, friction.value * load);
      // The doubt about the contact's radius is the tangent's too.
      return {k, k * tangent.sd / tangent.value};
    });
    add(points, g, group, Quantity::sliding_friction, load, [&](const SolvedCase& solved) {
      return steady(solved, &ContactHistory::lateral_displacement, &ContactHistory::lateral_force, load,
                    effective(solved, "sliding_friction"));
    });
    add(points, g, group, Quantity::rolling_stiffness, load, [](const SolvedCase& solved) -> ComparedValue {
      const auto rolled = rolled_with_energies(solved);
      if (!rolled || !rolled->first.reached()) return effective(solved, "rolling_stiffness");
      const ReversalStiffness back =
          rolling_stiffness(solved.history.rolling_angle, solved.history.rolling_moment, rolled->first.resistance().value);
      return {back.value, back.error};
    });
    add(points, g, group, Quantity::rolling_friction, load, [&](const SolvedCase& solved) -> ComparedValue {
      if (const auto rolled = rolled_with_energies(solved)) {
        if (!rolled->first.reached()) return {};
        const Uncertain moment = rolled->first.resistance();
        return {moment.value / (load * radius), moment.sd / (load * radius)};
      }
      return steady(solved, &ContactHistory::rolling_angle, &ContactHistory::rolling_moment, load * radius,
                    scaled(effective(solved, "rolling_moment"), 1 / (load * radius)));
    });
    add(points, g, group, Quantity::torsion_stiffness, load, plain("torsion_stiffness"));
    add(points, g, group, Quantity::torsion_friction, load, [&](const SolvedCase& solved) {
      return steady(solved, &ContactHistory::torsion_angle, &ContactHistory::torsion_moment, load * radius,
                    scaled(effective(solved, "torsion_moment"), 1 / (load * radius)));
    });
  }
  return points;
}

}  // namespace asperity
