#include "dem_compare/cases/moving_case.h"

#include <algorithm>
#include <cmath>

#include "core/steady_motion.h"
#include "dem_compare/cases/parameter_sets.h"
#include "dem_compare/cases/path_averages.h"
#include "dem_compare/numbers/statistics.h"

namespace asperity {
namespace {

using Values = std::vector<double>;

constexpr std::size_t fewest_blocks = 4;

double mean_of(const Values& values, std::size_t first, std::size_t last) {
  double sum = 0;
  for (std::size_t i = first; i <= last; ++i) sum += values[i];
  return sum / static_cast<double>(last - first + 1);
}

MotionRows rows_of(const EnergyHistory& history, const PathOfMotion& motion) {
  return {history.position,
          history.resistance,
          history.contact_radius,
          history.sticking,
          motion.rolls() ? motion.arm : 0,
          motion.kind == Motion::torsion};
}

Values sum_of(const Values& a, const Values& b, const Values& c) {
  Values sum(a);
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += b[i] + c[i];
  return sum;
}

void add_drift(const Values& rates, SteadyPath& steady) {
  const auto half = static_cast<long>(rates.size() / 2);
  const Uncertain change = mean_of_blocks({rates.end() - half, rates.end()}) -
                           mean_of_blocks({rates.begin(), rates.begin() + half});
  const double mean = mean_of_blocks(rates).value;
  steady.drift = change.value / mean;
  steady.drift_error = change.sd / std::abs(mean);
}

/// Without energies, from the force at equal distances: a path has many of them, and few blocks.
void add_drift_of_force(const Values& forces, double direction, SteadyPath& steady) {
  const auto half = static_cast<long>(forces.size() / 2);
  const CorrelatedMean first = correlated_mean({forces.begin(), forces.begin() + half}),
                       second = correlated_mean({forces.begin() + half, forces.end()});
  steady.drift = direction * (second.mean - first.mean) / steady.force.value;
  steady.drift_error = std::hypot(first.standard_error, second.standard_error) / std::abs(steady.force.value);
}

ReversalStiffness reversal_of(const EnergyHistory& history, const PathOfMotion& motion,
                              const MovingCase& moving) {
  if (!moving.reached()) return {};
  const double steady = moving.resistance().value;
  if (!motion.rolls() || !moving.has_energies())
    return reversal_stiffness(history.position, history.resistance, steady, partial_slip_of(motion.kind));
  ReversalStiffness reversal = rolling_stiffness(history.position, history.resistance, steady);
  if (moving.largest_contact_radius > 0)
    reversal.error = std::hypot(reversal.error, rolling_stiffness_mesh_error * moving.spacing /
                                                    moving.largest_contact_radius * reversal.value);
  return reversal;
}

std::string seeds_of(const SolvedCase& solved) {
  std::string seeds;
  for (const char* body : {"Particle", "Substrate"}) {
    const TopographySpec surface = solved.entries.topography(body);
    seeds += (seeds.empty() ? "" : " on ") +
             (surface.generator() ? std::to_string(surface.generator()->seed) : std::string("-"));
  }
  return seeds;
}

}  // namespace

Uncertain SteadyPath::resistance() const {
  if (!std::isfinite(dissipated.total.value)) return force;
  return with_stated_error(dissipated.total, unbalanced);
}

Uncertain SteadyPath::of(DissipationPart part) const {
  switch (part) {
    case DissipationPart::friction:
      return dissipated.friction;
    case DissipationPart::plastic:
      return dissipated.plastic;
    case DissipationPart::adhesion:
      return dissipated.adhesion;
    case DissipationPart::force:
      return force;
    default:
      return resistance();
  }
}

bool SteadyPath::still_changes() const {
  constexpr double errors_that_tell = 3, change_that_matters = 0.02;
  return std::abs(drift) > change_that_matters && std::abs(drift) > errors_that_tell * drift_error;
}

PathOfMotion path_of(const MotionMode& mode, double particle_radius) {
  if (&mode == &rolling_mode()) return {Motion::rolling, particle_radius};
  return {&mode == &torsion_mode() ? Motion::torsion : Motion::sliding, 1};
}

double PathOfMotion::block_length(double contact_radius) const {
  return kind == Motion::torsion ? 1 : contact_radius / arm;
}

SteadyPath steady_path(const EnergyHistory& history, std::size_t first, std::size_t last, double block) {
  SteadyPath steady;
  if (last < first + fewest_steady_rows - 1) return steady;
  const Values& x = history.position;
  const Values work = work_against_motion(history.position, history.resistance);
  const Values total =
      history.has_energies ? sum_of(history.friction, history.plastic, history.adhesion) : work;
  const auto keep = [&](DissipationPart part, const Values& sum) {
    if (!sum.empty())
      steady.sums.energy[static_cast<std::size_t>(part)].assign(sum.begin() + static_cast<long>(first),
                                                                sum.begin() + static_cast<long>(last) + 1);
  };
  steady.sums.position.assign(x.begin() + static_cast<long>(first), x.begin() + static_cast<long>(last) + 1);
  steady.sums.block = block;
  keep(DissipationPart::total, total), keep(DissipationPart::force, work);
  steady.path = std::abs(x[last] - x[first]);
  // A block has a step at least: no more of them than steps.
  const auto wanted =
      block > 0 ? static_cast<std::size_t>(std::max<long>(std::lround(steady.path / block), fewest_blocks))
                : fewest_blocks;
  const std::size_t count = std::min(wanted, last - first);
  steady.blocks = static_cast<int>(count);
  const auto mean_rate = [&](const Values& sum) {
    return mean_of_blocks(block_rates(x, sum, first, last, count));
  };
  const Values forces = resampled_along(x, history.resistance, first, last);
  const CorrelatedMean force = correlated_mean(forces);
  steady.force = {per_path_length(x, work, first, last),
                  force.standard_error * student_factor(force.independent - 1)};
  steady.independent = force.independent;
  const Values rates = block_rates(x, total, first, last, count);
  if (!history.has_energies && forces.size() >= 4)
    add_drift_of_force(forces, x[last] > x[first] ? 1 : -1, steady);
  if (history.has_energies && count >= fewest_blocks) add_drift(rates, steady);
  steady.fluctuation = scatter_of({history.resistance.begin() + static_cast<long>(first),
                                   history.resistance.begin() + static_cast<long>(last) + 1})
                           .sd;
  if (!history.has_energies) return steady;
  keep(DissipationPart::friction, history.friction), keep(DissipationPart::plastic, history.plastic),
      keep(DissipationPart::adhesion, history.adhesion);
  steady.dissipated.friction = mean_rate(history.friction);
  steady.dissipated.plastic = mean_rate(history.plastic);
  steady.dissipated.adhesion = mean_rate(history.adhesion);
  steady.dissipated.total = mean_of_blocks(rates);
  steady.independent = correlated_mean(rates).independent;
  steady.unbalanced = (history.unbalanced[last] - history.unbalanced[first]) / steady.path;
  return steady;
}

Uncertain MovingCase::resistance() const {
  if (has_energies() || !first.reached()) return first.resistance();
  if (!back.reached()) return {std::abs(first.force.value), first.force.sd};
  // Whichever sign the column counts as against the motion.
  const double path = first.path + back.path;
  return {std::abs(first.force.value * first.path + back.force.value * back.path) / path,
          std::hypot(first.force.sd * first.path, back.force.sd * back.path) / path};
}

MovingCase moving_case(const SolvedCase& solved, const MotionMode& mode) {
  return moving_case(solved, energy_history(solved, mode), path_of(mode, solved.hertz().radius));
}

MovingCase moving_case(const SolvedCase& solved, const EnergyHistory& history, const PathOfMotion& motion) {
  MovingCase moving;
  moving.folder = solved.folder.string();
  moving.seeds = seeds_of(solved);
  moving.spacing = solved.interface_spacing();
  if (history.size() == 0) return moving;
  moving.load = *std::max_element(history.normal_force.begin(), history.normal_force.end());
  moving.largest_contact_radius =
      *std::max_element(history.contact_radius.begin(), history.contact_radius.end());
  const MotionRows rows = rows_of(history, motion);
  bool is_first = true;
  for (const auto& leg : motion_legs(history.position)) {
    const std::size_t from = steady_onset(rows, leg);
    const bool reached = from <= leg.last;
    SteadyPath& path = is_first ? moving.first : moving.back;
    if (reached && !path.reached()) {
      const double radius = mean_of(history.contact_radius, from, leg.last),
                   block = motion.block_length(radius);
      // A short return path is for the stiffness: what it dissipates beyond its onset says nothing yet.
      const bool is_brief = !is_first && motion.rolls() &&
                            std::abs(history.position[leg.last] - history.position[from]) < block;
      if (!is_brief) path = steady_path(history, from, leg.last, block);
      if (is_first) {
        moving.contact_radius = radius;
        moving.contact_area = mean_of(history.contact_area, from, leg.last);
        moving.load = mean_of(history.normal_force, from, leg.last);
        moving.path_in_radii = path.path / block;
      }
    }
    is_first = false;
  }
  moving.reversal = reversal_of(history, motion, moving);
  return moving;
}

const MotionMode* mode_of(const SolvedCase& solved) {
  for (const MotionMode* mode : {&sliding_mode(), &rolling_mode(), &torsion_mode()})
    if (solved.motion() == mode->motion) return mode;
  return nullptr;
}

}  // namespace asperity
