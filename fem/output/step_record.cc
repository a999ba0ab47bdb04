#include "fem/output/step_record.h"

#include "core/csv.h"

namespace asperity::fem {

const std::vector<std::pair<const char*, double StepRecord::*>>& StepRecord::columns() {
  static const std::vector<std::pair<const char*, double StepRecord::*>> columns{
      {"step", &StepRecord::step},
      {"time [s]", &StepRecord::time},
      {"normal_displacement [m]", &StepRecord::normal_displacement},
      {"normal_force [N]", &StepRecord::normal_force},
      {"lateral_displacement [m]", &StepRecord::lateral_displacement},
      {"lateral_force [N]", &StepRecord::lateral_force},
      {"rolling_angle [rad]", &StepRecord::rolling_angle},
      {"rolling_moment [N m]", &StepRecord::rolling_moment},
      {"torsion_angle [rad]", &StepRecord::torsion_angle},
      {"torsion_moment [N m]", &StepRecord::torsion_moment},
      {"contact_radius [m]", &StepRecord::contact_radius},
      {"contact_area [m^2]", &StepRecord::contact_area},
      {"max_pressure [Pa]", &StepRecord::max_pressure},
      {"plastic_volume [m^3]", &StepRecord::plastic_volume},
      {"dissipated_energy [J]", &StepRecord::dissipated_energy},
      {"driven_displacement [m]", &StepRecord::driven_displacement},
      {"shift [m]", &StepRecord::shift},
      {"elastic_energy [J]", &StepRecord::elastic_energy},
      {"hardening_energy [J]", &StepRecord::hardening_energy},
      {"plastic_work [J]", &StepRecord::plastic_work},
      {"friction_work [J]", &StepRecord::friction_work},
      {"adhesion_energy [J]", &StepRecord::adhesion_energy},
      {"adhesion_loss [J]", &StepRecord::adhesion_loss},
      {"attraction [N]", &StepRecord::attraction},
      {"work [J]", &StepRecord::work},
      {"mean_pressure [Pa]", &StepRecord::mean_pressure},
      {"largest_plastic_strain", &StepRecord::largest_plastic_strain},
      {"largest_von_mises [Pa]", &StepRecord::largest_von_mises},
      {"force_error", &StepRecord::force_error},
      {"moment_error", &StepRecord::moment_error},
      {"energy_error", &StepRecord::energy_error},
      {"newton_iterations", &StepRecord::newton_iterations},
      {"linear_iterations", &StepRecord::linear_iterations},
      {"penetration", &StepRecord::penetration},
      {"wall_time [s]", &StepRecord::wall_time},
      {"reaches_rim", &StepRecord::reaches_rim},
      {"sticking_share", &StepRecord::sticking_share},
      {"shift_across [m]", &StepRecord::shift_across},
      {"lateral_force_across [N]", &StepRecord::lateral_force_across},
      {"mean_plane_approach [m]", &StepRecord::mean_plane_approach},
      {"pressure_radius [m]", &StepRecord::pressure_radius},
      {"load_centre_x [m]", &StepRecord::load_centre_x},
      {"load_centre_y [m]", &StepRecord::load_centre_y},
      {"spots", &StepRecord::spots},
      {"contact_perimeter [m]", &StepRecord::contact_perimeter},
      {"particle_von_mises [Pa]", &StepRecord::particle_von_mises},
      {"substrate_von_mises [Pa]", &StepRecord::substrate_von_mises},
      {"particle_plastic_strain", &StepRecord::particle_plastic_strain},
      {"substrate_plastic_strain", &StepRecord::substrate_plastic_strain},
      {"load_step_error [m]", &StepRecord::load_step_error}};
  return columns;
}

std::string history_csv(const std::vector<StepRecord>& records) {
  std::vector<std::string> names;
  std::vector<std::vector<double>> values;
  for (const auto& [name, member] : StepRecord::columns()) {
    names.emplace_back(name);
    values.emplace_back();
    for (const auto& record : records) values.back().push_back(record.*member);
  }
  return format_csv(names, values);
}

}  // namespace asperity::fem
