// What a moving contact has dissipated along its path, by mechanism, as history.csv of a solved case has it.
// SI units.
#pragma once

#include <vector>

#include "dem_compare/cases/motion_mode.h"
#include "results/solved_case.h"

namespace asperity {

/// Rows of history.csv; energies count from the first touch.
struct EnergyHistory {
  std::vector<double> position;    ///< path of the mode of motion [m] or [rad]
  std::vector<double> resistance;  ///< [N] or [N m]
  std::vector<double> normal_force, contact_radius, contact_area;
  std::vector<double> friction;  ///< dissipated by slip [J]
  std::vector<double> plastic;   ///< plastic work less what hardening stores [J]
  std::vector<double> adhesion;  ///< lost by bonds that form and break [J]
  std::vector<double>
      unbalanced;  ///< work less stored less dissipated [J]; zero but for errors of the computation
  std::vector<double>
      sticking;               ///< share of the active contact nodes that stick; empty where it is not known
  bool has_energies = false;  ///< the history tells the mechanisms apart

  std::size_t size() const { return position.size(); }
};

/// Rows with unknown cells are left out.
EnergyHistory energy_history(const SolvedCase& solved, const MotionMode& mode);

}  // namespace asperity
