#include "dem_compare/cases/energy_history.h"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

using Values = std::vector<double>;

/// Whether the history tells the mechanisms apart.
bool tells_energies(const History& steps) {
  const Values* const columns[] = {&steps.friction_work, &steps.plastic_work,   &steps.hardening_energy,
                                   &steps.adhesion_loss, &steps.elastic_energy, &steps.adhesion_energy,
                                   &steps.work};
  return std::none_of(std::begin(columns), std::end(columns),
                      [](const Values* column) { return column->empty(); });
}

void add_energies(const History& steps, EnergyHistory& history) {
  history.friction = steps.friction_work;
  history.adhesion = steps.adhesion_loss;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    history.plastic.push_back(steps.plastic_work[i] - steps.hardening_energy[i]);
    history.unbalanced.push_back(steps.work[i] - steps.elastic_energy[i] - steps.adhesion_energy[i] -
                                 steps.plastic_work[i] - history.friction[i] - history.adhesion[i]);
  }
}

/// All columns that are filled, for whatever is done to each.
template <class Do>
void for_each_column(EnergyHistory& history, const Do& act) {
  for (Values* column : {&history.position, &history.resistance, &history.normal_force,
                         &history.contact_radius, &history.contact_area, &history.friction, &history.plastic,
                         &history.adhesion, &history.unbalanced, &history.sticking})
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
  const History& steps = solved.history;
  EnergyHistory history;
  history.position = steps.*mode.position;
  history.resistance = steps.*mode.resistance;
  history.normal_force = steps.normal_force;
  history.contact_radius = steps.radius_of_whole();
  history.contact_area = steps.contact_area;
  history.sticking = steps.sticking_share;
  history.has_energies = tells_energies(steps);
  if (history.has_energies) add_energies(steps, history);
  leave_out_unknown_rows(history);
  return history;
}

}  // namespace asperity
