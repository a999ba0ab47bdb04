#include "dem_compare/resistance/moving_case.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <regex>

#include "dem_compare/derive/parameter_sets.h"
#include "dem_compare/derive/steady_motion.h"
#include "dem_compare/resistance/stretches.h"
#include "dem_compare/statistics.h"

namespace asperity {
namespace {

using Values = std::vector<double>;

/// Nodes that have just closed, or lie at the axis of a spin, may stick while the contact slips as a whole.
constexpr double few_sticking = 0.02;
constexpr std::size_t fewest_stretches = 4, fewest_rows = 3;

double mean_of(const Values& values, std::size_t first, std::size_t last) {
  double sum = 0;
  for (std::size_t i = first; i <= last; ++i) sum += values[i];
  return sum / static_cast<double>(last - first + 1);
}

/// First row of a leg that is steady; one past its last if there is none.
std::size_t onset(const EnergyHistory& history, const MotionLeg& leg, const WayOfMotion& motion) {
  const auto none = leg.last + 1;
  constexpr double nearly = 0.95;
  const double later = mean_of(history.resistance, (leg.first + leg.last + 1) / 2, leg.last);
  for (std::size_t i = leg.first + 1; i <= leg.last; ++i) {
    const double way = std::abs(history.position[i] - history.position[leg.first]);
    const bool steady = motion.rolls()              ? way * motion.arm >= history.contact_radius[i]
                        : !history.sticking.empty() ? history.sticking[i] <= few_sticking
                                                    : history.resistance[i] / later >= nearly;
    if (steady) return i;
  }
  return none;
}

/// Running integral of the resistance against the motion.
Values work_against_motion(const EnergyHistory& history) {
  Values work(history.size(), 0.0);
  for (std::size_t i = 1; i < history.size(); ++i)
    work[i] = work[i - 1] + 0.5 * (history.resistance[i] + history.resistance[i - 1]) *
                                (history.position[i] - history.position[i - 1]);
  return work;
}

Values sum_of(const Values& a, const Values& b, const Values& c) {
  Values sum(a);
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += b[i] + c[i];
  return sum;
}

void add_drift(const Values& rates, SteadyWay& steady) {
  const auto half = static_cast<long>(rates.size() / 2);
  const Uncertain change =
      mean_of_stretches({rates.end() - half, rates.end()}) - mean_of_stretches({rates.begin(), rates.begin() + half});
  const double mean = mean_of_stretches(rates).value;
  steady.drift = change.value / mean;
  steady.drift_error = change.sd / std::abs(mean);
}

std::string seeds_of(const SolvedCase& solved) {
  static const std::regex seed(R"(seed\s*=\s*(\d+))");
  std::string seeds;
  for (const char* entry : {"Particle/Topography", "Substrate/Topography"}) {
    const std::string text = solved.entries.text(entry);
    std::smatch found;
    seeds += (seeds.empty() ? "" : " on ") + (std::regex_search(text, found, seed) ? found[1].str() : std::string("-"));
  }
  return seeds;
}

}  // namespace

Uncertain SteadyWay::resistance() const {
  if (!std::isfinite(dissipated.total.value)) return force;
  return {dissipated.total.value, std::hypot(dissipated.total.sd, unbalanced)};
}

Uncertain SteadyWay::of(WayPart part) const {
  switch (part) {
    case WayPart::friction:
      return dissipated.friction;
    case WayPart::plastic:
      return dissipated.plastic;
    case WayPart::adhesion:
      return dissipated.adhesion;
    case WayPart::force:
      return force;
    default:
      return resistance();
  }
}

bool SteadyWay::still_changes() const {
  constexpr double errors_that_tell = 3, change_that_matters = 0.05;
  return std::abs(drift) > change_that_matters && std::abs(drift) > errors_that_tell * drift_error;
}

WayOfMotion way_of(const MotionMode& mode, double particle_radius) {
  if (&mode == &rolling_mode()) return {WayOfMotion::Kind::roll, particle_radius};
  return {&mode == &torsion_mode() ? WayOfMotion::Kind::spin : WayOfMotion::Kind::slide, 1};
}

double WayOfMotion::stretch_length(double contact_radius) const { return kind == Kind::spin ? 1 : contact_radius / arm; }

SteadyWay steady_way(const EnergyHistory& history, std::size_t first, std::size_t last, double stretch) {
  SteadyWay steady;
  if (last < first + fewest_rows - 1) return steady;
  const Values& x = history.position;
  const Values work = work_against_motion(history);
  const Values total = history.has_energies ? sum_of(history.friction, history.plastic, history.adhesion) : work;
  const auto keep = [&](WayPart part, const Values& sum) {
    if (!sum.empty())
      steady.sums.energy[static_cast<std::size_t>(part)].assign(sum.begin() + static_cast<long>(first), sum.begin() + static_cast<long>(last) + 1);
  };
  steady.sums.position.assign(x.begin() + static_cast<long>(first), x.begin() + static_cast<long>(last) + 1);
  steady.sums.stretch = stretch;
  keep(WayPart::total, total), keep(WayPart::force, work);
  steady.way = std::abs(x[last] - x[first]);
  // A stretch has a step at least: no more of them than steps.
  const auto wanted = static_cast<std::size_t>(std::max<long>(std::lround(steady.way / stretch), fewest_stretches));
  const std::size_t count = std::min(wanted, last - first);
  steady.stretches = static_cast<int>(count);
  const auto mean_rate = [&](const Values& sum) {
    return mean_of_stretches(rates_of_stretches(x, sum, first, last, count));
  };
  steady.force = mean_rate(work);
  steady.fluctuation = scatter_of({history.resistance.begin() + static_cast<long>(first), history.resistance.begin() + static_cast<long>(last) + 1}).sd;
  if (!history.has_energies) return steady;
  keep(WayPart::friction, history.friction), keep(WayPart::plastic, history.plastic), keep(WayPart::adhesion, history.adhesion);
  steady.dissipated.friction = mean_rate(history.friction);
  steady.dissipated.plastic = mean_rate(history.plastic);
  steady.dissipated.adhesion = mean_rate(history.adhesion);
  const Values rates = rates_of_stretches(x, total, first, last, count);
  steady.dissipated.total = mean_of_stretches(rates);
  steady.unbalanced = (history.unbalanced[last] - history.unbalanced[first]) / steady.way;
  if (count >= fewest_stretches) add_drift(rates, steady);
  return steady;
}

MovingCase moving_case(const SolvedCase& solved, const MotionMode& mode) {
  return moving_case(solved, energy_history(solved, mode), way_of(mode, solved.hertz().radius));
}

MovingCase moving_case(const SolvedCase& solved, const EnergyHistory& history, const WayOfMotion& motion) {
  MovingCase moving;
  moving.folder = solved.folder.string();
  moving.seeds = seeds_of(solved);
  moving.spacing = solved.interface_spacing();
  if (history.size() == 0) return moving;
  moving.load = *std::max_element(history.normal_force.begin(), history.normal_force.end());
  bool is_first = true;
  for (const auto& leg : motion_legs(history.position)) {
    const std::size_t from = onset(history, leg, motion);
    const bool reached = from + fewest_rows <= leg.last + 1;
    SteadyWay& way = is_first ? moving.first : moving.back;
    if (reached && !way.reached()) {
      const double radius = mean_of(history.contact_radius, from, leg.last),
                   stretch = motion.stretch_length(radius);
      // A short way back is for the stiffness: what it dissipates beyond its onset says nothing yet.
      const bool is_brief = !is_first && motion.rolls() && std::abs(history.position[leg.last] - history.position[from]) < stretch;
      if (!is_brief) way = steady_way(history, from, leg.last, stretch);
      if (is_first) {
        moving.contact_radius = radius;
        moving.contact_area = mean_of(history.contact_area, from, leg.last);
        moving.load = mean_of(history.normal_force, from, leg.last);
        moving.way_in_radii = way.way / stretch;
      }
    }
    is_first = false;
  }
  return moving;
}

std::optional<MovingCase> rolled_with_energies(const SolvedCase& solved) {
  if (!std::filesystem::exists(solved.folder / "history.csv") || !energy_history(solved, rolling_mode()).has_energies) return std::nullopt;
  return moving_case(solved, rolling_mode());
}

const MotionMode* mode_of(const SolvedCase& solved) {
  for (const MotionMode* mode : {&sliding_mode(), &rolling_mode(), &torsion_mode()})
    if (experiment_of(solved) == mode->experiment) return mode;
  return nullptr;
}

}  // namespace asperity
