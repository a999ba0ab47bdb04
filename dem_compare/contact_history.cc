#include "dem_compare/contact_history.h"

#include <algorithm>
#include <cmath>

#include "core/csv.h"
#include "core/error.h"

namespace asperity {

const std::vector<HistoryColumn>& history_columns() {
  static const std::vector<HistoryColumn> columns{
      {"step", &ContactHistory::step},
      {"time [s]", &ContactHistory::time},
      {"normal_displacement [m]", &ContactHistory::normal_displacement},
      {"normal_force [N]", &ContactHistory::normal_force},
      {"lateral_displacement [m]", &ContactHistory::lateral_displacement},
      {"lateral_force [N]", &ContactHistory::lateral_force},
      {"rolling_angle [rad]", &ContactHistory::rolling_angle},
      {"rolling_moment [N m]", &ContactHistory::rolling_moment},
      {"torsion_angle [rad]", &ContactHistory::torsion_angle},
      {"torsion_moment [N m]", &ContactHistory::torsion_moment},
      {"contact_radius [m]", &ContactHistory::contact_radius},
      {"contact_area [m^2]", &ContactHistory::contact_area},
      {"max_pressure [Pa]", &ContactHistory::max_pressure},
      {"plastic_volume [m^3]", &ContactHistory::plastic_volume},
      {"dissipated_energy [J]", &ContactHistory::dissipated_energy}};
  return columns;
}

ContactHistory read_history(const std::filesystem::path& file) {
  const CsvTable table = read_csv(file);
  ContactHistory history;
  try {
    for (const auto& column : history_columns()) history.*column.values = table.numbers(column.name);
    if (table.has("pressure_radius [m]")) history.pressure_radius = table.numbers("pressure_radius [m]");
  } catch (const InputError& error) {
    throw InputError(file.string() + ": " + error.what());
  }
  return history;
}

std::string format_history(const ContactHistory& history) {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;
  for (const auto& column : history_columns()) {
    names.push_back(column.name);
    columns.push_back(history.*column.values);
    if (columns.back().empty()) columns.back().assign(history.size(), 0.0);
  }
  return format_csv(names, columns);
}

std::vector<HistoryBranch> history_branches(const ContactHistory& history) {
  using Kind = HistoryBranch::Kind;
  const auto& force = history.normal_force;
  std::vector<HistoryBranch> branches;
  if (force.size() < 2) return branches;
  // Solved to about 1e-6 of the load: smaller changes are a hold.
  constexpr double noise_share = 1e-5;
  const double noise = noise_share * *std::max_element(force.begin(), force.end());
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
