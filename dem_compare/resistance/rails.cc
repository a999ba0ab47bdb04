#include "dem_compare/resistance/rails.h"

#include <algorithm>
#include <cmath>

#include "core/motion_program.h"
#include "dem_compare/cases/case_numbers.h"
#include "dem_compare/cases/parameter_sets.h"
#include "dem_compare/cases/path_averages.h"
#include "dem_compare/resistance/moving_study.h"

namespace asperity {
namespace {

constexpr double same_angle = 1e-3;

/// Of the moment against the spin, counted along the rolling angle: both angles have the signs that the
/// program gives them.
double against_the_spin(const EnergyHistory& rolling, const EnergyHistory& spin, std::size_t row) {
  return spin.position[row] * rolling.position[row] < 0 ? -spin.resistance[row] : spin.resistance[row];
}

/// Rolling and spinning as one motion about the rail's axis: position is the angle about it, resistance its
/// moment. Empty where the file does not know both moments in the same rows.
EnergyHistory about_the_axis(const SolvedCase& solved, double inclination) {
  EnergyHistory history = energy_history(solved, rolling_mode());
  const EnergyHistory spin = energy_history(solved, torsion_mode());
  if (spin.size() != history.size()) return {};
  const double c = std::cos(inclination), s = std::sin(inclination);
  for (std::size_t i = 0; i < history.size(); ++i) {
    history.resistance[i] = c * history.resistance[i] + s * against_the_spin(history, spin, i);
    history.position[i] /= c;
  }
  return history;
}

Uncertain mean(const std::vector<Uncertain>& values) { return mean_of_realisations(values); }

template <class Of>
Uncertain mean_over(const std::vector<MovingCase>& cases, const Of& of) {
  std::vector<Uncertain> values;
  for (const auto& item : cases) values.push_back(of(item.first));
  return mean(values);
}

void keep_finest_mesh(RailState& rail) {
  double finest = INFINITY;
  for (const auto& item : rail.cases) finest = std::min(finest, item.spacing);
  for (std::size_t i = rail.cases.size(); i-- > 0;)
    if (std::isfinite(finest) && !same_spacing(rail.cases[i].spacing, finest)) {
      rail.cases.erase(rail.cases.begin() + static_cast<long>(i));
      rail.spin_moments.erase(rail.spin_moments.begin() + static_cast<long>(i));
    }
}

}  // namespace

Uncertain RailState::over_sum() const { return ratio(resistance, sum); }

std::optional<double> rail_inclination(const SolvedCase& solved) {
  if (solved.motion() != Motion::program) return std::nullopt;
  const std::string program = solved.entries.text("Experiment/Program");
  if (program == "none") return std::nullopt;  // of an experiment whose result will say it
  const auto parts = parse_motion_program(program);
  if (parts.size() != 1 || !parts[0].rolls_freely() || parts[0].spin == 0 || parts[0].load ||
      parts[0].approach)
    return std::nullopt;
  return std::atan(std::abs(parts[0].spin / (parts[0].roll + parts[0].rolled_arc / solved.hertz().radius)));
}

bool add_rail(MovingContact& contact, const SolvedCase& solved, double inclination) {
  const PathOfMotion path{Motion::rolling, solved.hertz().radius * std::cos(inclination)};
  EnergyHistory history = about_the_axis(solved, inclination);
  MovingCase moving = moving_case(solved, history, path);
  if (!moving.first.reached()) return false;
  const auto same = [&](const RailState& rail) {
    return std::abs(rail.inclination - inclination) < same_angle && same_load(rail.load, moving.load);
  };
  auto rail = std::find_if(contact.rails.begin(), contact.rails.end(), same);
  if (rail == contact.rails.end()) {
    contact.rails.push_back({});
    rail = std::prev(contact.rails.end());
    rail->inclination = inclination, rail->load = moving.load;
  }
  const EnergyHistory spin = energy_history(solved, torsion_mode());
  for (std::size_t i = 0; i < history.size(); ++i) history.resistance[i] = against_the_spin(history, spin, i);
  rail->spin_moments.push_back(moving_case(solved, history, path).first.force);
  rail->cases.push_back(std::move(moving));
  return true;
}

void finish_rails(MovingContact& contact) {
  for (auto& rail : contact.rails) {
    keep_finest_mesh(rail);
    rail.parts.friction =
        mean_over(rail.cases, [](const SteadyPath& path) { return path.dissipated.friction; });
    rail.parts.plastic =
        mean_over(rail.cases, [](const SteadyPath& path) { return path.dissipated.plastic; });
    rail.parts.adhesion =
        mean_over(rail.cases, [](const SteadyPath& path) { return path.dissipated.adhesion; });
    rail.parts.total = mean_over(rail.cases, [](const SteadyPath& path) { return path.dissipated.total; });
    rail.resistance = mean_over(rail.cases, [](const SteadyPath& path) { return path.resistance(); });
    rail.spin_moment = mean(rail.spin_moments);
    const MovingState *rolling = contact.find(rolling_mode(), rail.load),
                      *torsion = contact.find(torsion_mode(), rail.load);
    if (torsion) rail.spin_over_torsion = ratio(rail.spin_moment, torsion->resistance);
    if (rolling && torsion)
      rail.sum =
          rolling->resistance * std::cos(rail.inclination) + torsion->resistance * std::sin(rail.inclination);
  }
  std::stable_sort(contact.rails.begin(), contact.rails.end(), [](const RailState& a, const RailState& b) {
    return std::abs(a.inclination - b.inclination) > same_angle ? a.inclination < b.inclination
                                                                : a.load < b.load;
  });
}

}  // namespace asperity
