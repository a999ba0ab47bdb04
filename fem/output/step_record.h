// What is kept of one accepted step; the rows of history.csv.
#pragma once

#include <string>
#include <vector>

namespace asperity::fem {

struct StepRecord {
  double step = 0, time = 0;
  double normal_displacement = 0, normal_force = 0;
  double lateral_displacement = 0, lateral_force = 0;  ///< of points far from the contact along x [m], [N]
  double rolling_angle = 0, rolling_moment = 0;        ///< [rad], about the contact [N m]
  double torsion_angle = 0, torsion_moment = 0;        ///< [rad], [N m]
  double contact_radius = 0, contact_area = 0, max_pressure = 0;  ///< radius: of the circle with the contact area [m]
  double plastic_volume = 0, dissipated_energy = 0;
  // beyond the fixed columns
  double driven_displacement = 0;  ///< of the driven plane, finite bodies included [m]
  double shift = 0;                ///< of the particle's frame along x, finite bodies included [m]
  double shift_across = 0, lateral_force_across = 0;  ///< the same along y [m], [N]
  double elastic_energy = 0, hardening_energy = 0, plastic_work = 0, friction_work = 0, work = 0;  ///< [J]
  double adhesion_energy = 0, adhesion_loss = 0;  ///< potential of attraction; dissipated by bonds [J]
  double attraction = 0;           ///< part of the normal force that attracts [N]
  double mean_pressure = 0, largest_plastic_strain = 0, largest_von_mises = 0;
  double force_error = 0, moment_error = 0, energy_error = 0;
  double newton_iterations = 0, linear_iterations = 0, penetration = 0, wall_time = 0;
  double reaches_rim = 0, sticking_share = 0;  ///< share of the closed nodes that stick
  double mean_plane_approach = 0;  ///< approach counted from where the mean surfaces, without roughness, would touch [m]
  double pressure_radius = 0;      ///< of the Hertzian pressure with the same second moment [m]
  double load_centre_x = 0, load_centre_y = 0;   ///< of the contact pressure, in the substrate's frame [m]
  double spots = 0, contact_perimeter = 0;       ///< contacts apart from each other; length of their edges [m]
  double particle_von_mises = 0, substrate_von_mises = 0;            ///< largest of each body [Pa]
  double load_step_error = 0;      ///< of the approach, from finite load steps of bodies that yield; positive: it is too large [m]
  double particle_plastic_strain = 0, substrate_plastic_strain = 0;  ///< largest of each body

  static const std::vector<std::pair<const char*, double StepRecord::*>>& columns();
};

/// history.csv: the columns fixed by the program's interface, then the ones above. Columns of other experiments are 0.
std::string history_csv(const std::vector<StepRecord>& records);

}  // namespace asperity::fem
