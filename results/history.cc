#include "results/history.h"

#include <algorithm>
#include <cmath>

#include "core/csv.h"
#include "core/error.h"

namespace asperity {
namespace {

/// Of the largest force: solved to about 1e-6 of the load, so smaller changes are a hold.
constexpr double force_noise = 1e-5;

}  // namespace

const std::vector<HistoryColumn>& history_columns() {
  using Columns = HistoryColumns<std::vector<double>>;
#define ASPERITY_COLUMN(member) &HistoryRow::member, &Columns::member
  static const std::vector<HistoryColumn> columns{
      {"step", ASPERITY_COLUMN(step), true},
      {"time [s]", ASPERITY_COLUMN(time), true},
      {"normal_displacement [m]", ASPERITY_COLUMN(normal_displacement), true},
      {"normal_force [N]", ASPERITY_COLUMN(normal_force), true},
      {"lateral_displacement [m]", ASPERITY_COLUMN(lateral_displacement), true},
      {"lateral_force [N]", ASPERITY_COLUMN(lateral_force), true},
      {"rolling_angle [rad]", ASPERITY_COLUMN(rolling_angle), true},
      {"rolling_moment [N m]", ASPERITY_COLUMN(rolling_moment), true},
      {"torsion_angle [rad]", ASPERITY_COLUMN(torsion_angle), true},
      {"torsion_moment [N m]", ASPERITY_COLUMN(torsion_moment), true},
      {"contact_radius [m]", ASPERITY_COLUMN(contact_radius), true},
      {"contact_area [m^2]", ASPERITY_COLUMN(contact_area), true},
      {"max_pressure [Pa]", ASPERITY_COLUMN(max_pressure), true},
      {"plastic_volume [m^3]", ASPERITY_COLUMN(plastic_volume), true},
      {"dissipated_energy [J]", ASPERITY_COLUMN(dissipated_energy), true},
      {"driven_displacement [m]", ASPERITY_COLUMN(driven_displacement), false},
      {"shift [m]", ASPERITY_COLUMN(shift), false},
      {"elastic_energy [J]", ASPERITY_COLUMN(elastic_energy), false},
      {"hardening_energy [J]", ASPERITY_COLUMN(hardening_energy), false},
      {"plastic_work [J]", ASPERITY_COLUMN(plastic_work), false},
      {"friction_work [J]", ASPERITY_COLUMN(friction_work), false},
      {"adhesion_energy [J]", ASPERITY_COLUMN(adhesion_energy), false},
      {"adhesion_loss [J]", ASPERITY_COLUMN(adhesion_loss), false},
      {"attraction [N]", ASPERITY_COLUMN(attraction), false},
      {"work [J]", ASPERITY_COLUMN(work), false},
      {"mean_pressure [Pa]", ASPERITY_COLUMN(mean_pressure), false},
      {"largest_plastic_strain", ASPERITY_COLUMN(largest_plastic_strain), false},
      {"largest_von_mises [Pa]", ASPERITY_COLUMN(largest_von_mises), false},
      {"force_error", ASPERITY_COLUMN(force_error), false},
      {"moment_error", ASPERITY_COLUMN(moment_error), false},
      {"energy_error", ASPERITY_COLUMN(energy_error), false},
      {"newton_iterations", ASPERITY_COLUMN(newton_iterations), false},
      {"linear_iterations", ASPERITY_COLUMN(linear_iterations), false},
      {"penetration", ASPERITY_COLUMN(penetration), false},
      {"wall_time [s]", ASPERITY_COLUMN(wall_time), false},
      {"reaches_rim", ASPERITY_COLUMN(reaches_rim), false},
      {"sticking_share", ASPERITY_COLUMN(sticking_share), false},
      {"shift_across [m]", ASPERITY_COLUMN(shift_across), false},
      {"lateral_force_across [N]", ASPERITY_COLUMN(lateral_force_across), false},
      {"mean_plane_approach [m]", ASPERITY_COLUMN(mean_plane_approach), false},
      {"pressure_radius [m]", ASPERITY_COLUMN(pressure_radius), false},
      {"load_centre_x [m]", ASPERITY_COLUMN(load_centre_x), false},
      {"load_centre_y [m]", ASPERITY_COLUMN(load_centre_y), false},
      {"spots", ASPERITY_COLUMN(spots), false},
      {"contact_perimeter [m]", ASPERITY_COLUMN(contact_perimeter), false},
      {"particle_von_mises [Pa]", ASPERITY_COLUMN(particle_von_mises), false},
      {"substrate_von_mises [Pa]", ASPERITY_COLUMN(substrate_von_mises), false},
      {"particle_plastic_strain", ASPERITY_COLUMN(particle_plastic_strain), false},
      {"substrate_plastic_strain", ASPERITY_COLUMN(substrate_plastic_strain), false},
      {"load_step_error [m]", ASPERITY_COLUMN(load_step_error), false}};
#undef ASPERITY_COLUMN
  return columns;
}

History history_of(const std::vector<HistoryRow>& rows, const std::vector<std::string>& added) {
  History history;
  for (const auto& column : history_columns())
    for (const auto& row : rows) (history.*column.values).push_back(row.*column.of_row);
  for (std::size_t k = 0; k < added.size(); ++k) {
    history.added.push_back({added[k], {}});
    for (const auto& row : rows) history.added.back().values.push_back(row.added.at(k));
  }
  return history;
}

History read_history(const std::filesystem::path& file, const std::vector<std::string>& added) {
  const CsvTable table = read_csv(file);
  History history;
  try {
    for (const auto& column : history_columns())
      if (column.always || table.has(column.name)) history.*column.values = table.numbers(column.name);
    for (const auto& name : added) history.added.push_back({name, table.numbers(name)});
  } catch (const InputError& error) {
    throw InputError(file.string() + ": " + error.what());
  }
  return history;
}

std::string format_history(const History& history) {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;
  for (const auto& column : history_columns()) {
    const auto& values = history.*column.values;
    if (values.empty() && !column.always) continue;
    names.push_back(column.name);
    columns.push_back(values);
    if (values.empty()) columns.back().assign(history.size(), 0.0);
  }
  for (const auto& column : history.added) {
    names.push_back(column.name);
    columns.push_back(column.values);
  }
  return format_csv(names, columns);
}

std::size_t row_of_largest_load(const std::vector<double>& normal_force) {
  if (normal_force.empty()) return 0;
  const auto largest = std::max_element(normal_force.begin(), normal_force.end());
  const double reached = *largest - force_noise * std::abs(*largest);
  const auto first =
      std::find_if(normal_force.begin(), largest, [&](double force) { return force >= reached; });
  return static_cast<std::size_t>(first - normal_force.begin());
}

const HistoryRow& at_largest_load(const std::vector<HistoryRow>& rows) {
  std::vector<double> forces;
  for (const HistoryRow& row : rows) forces.push_back(row.normal_force);
  return rows.at(row_of_largest_load(forces));
}

std::vector<HistoryBranch> history_branches(const History& history) {
  using Kind = HistoryBranch::Kind;
  const auto& force = history.normal_force;
  std::vector<HistoryBranch> branches;
  if (force.size() < 2) return branches;
  const double noise = force_noise * *std::max_element(force.begin(), force.end());
  for (std::size_t i = 1; i < force.size(); ++i) {
    const double change = force[i] - force[i - 1];
    const Kind kind = std::abs(change) <= noise ? Kind::hold : change > 0 ? Kind::loading : Kind::unloading;
    if (!branches.empty() && branches.back().kind == kind)
      branches.back().last = i;
    else
      branches.push_back({kind, i - 1, i});
  }
  return branches;
}

}  // namespace asperity
