#include "dem_compare/resistance/energy_history.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/csv.h"

namespace asperity {
namespace {

using Values = std::vector<double>;

constexpr const char* energy_columns[] = {"friction_work [J]", "plastic_work [J]",   "hardening_energy [J]",
                                          "adhesion_loss [J]", "elastic_energy [J]", "adhesion_energy [J]",
                                          "work [J]"};

void add_energies(const CsvTable& table, EnergyHistory& history) {
  const auto column = [&](const char* name) { return table.numbers(name); };
  const Values plastic = column("plastic_work [J]"), hardening = column("hardening_energy [J]"),
               elastic = column("elastic_energy [J]"), bonds = column("adhesion_energy [J]"), work = column("work [J]");
  history.friction = column("friction_work [J]");
  history.adhesion = column("adhesion_loss [J]");
  for (std::size_t i = 0; i < plastic.size(); ++i) {
    history.plastic.push_back(plastic[i] - hardening[i]);
    history.unbalanced.push_back(work[i] - elastic[i] - bonds[i] - plastic[i] - history.friction[i] -
                                 history.adhesion[i]);
  }
}

/// All columns that are filled, for whatever is done to each.
template <class Do>
void for_each_column(EnergyHistory& history, const Do& act) {
  for (Values* column :
       {&history.position, &history.resistance, &history.normal_force, &history.contact_radius, &history.contact_area,
        &history.friction, &history.plastic, &history.adhesion, &history.unbalanced, &history.sticking})
    if (!column->empty()) act(*column);
}

void leave_out_unknown_rows(EnergyHistory& history) {
  std::vector<bool> known(history.size(), true);
  for_each_column(history, [&](const Values& column) {
    for (std::size_t i = 0; i < column.size(); ++i) known[i] = known[i] && std::isfinite(column[i]);
  });
  for_each_column(history, [&](Values& column) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < known.size(); ++i)
      if (known[i]) column[kept++] = column[i];
    column.resize(kept);
  });
}

}  // namespace

EnergyHistory energy_history(const SolvedCase& solved, const MotionMode& mode) {
  const ContactHistory& steps = solved.history;
  EnergyHistory history;
  history.position = steps.*mode.position;
  history.resistance = steps.*mode.resistance;
  history.normal_force = steps.normal_force;
  history.contact_radius = steps.radius_of_whole();
  history.contact_area = steps.contact_area;
  if (!std::filesystem::exists(solved.folder / "history.csv")) {  // a history that was made, not read
    leave_out_unknown_rows(history);
    return history;
  }
  const CsvTable table = read_csv(solved.folder / "history.csv");
  history.has_energies = std::all_of(std::begin(energy_columns), std::end(energy_columns),
                                     [&](const char* name) { return table.has(name); });
  if (history.has_energies) add_energies(table, history);
  if (table.has("sticking_share")) history.sticking = table.numbers("sticking_share");
  leave_out_unknown_rows(history);
  return history;
}

}  // namespace asperity
