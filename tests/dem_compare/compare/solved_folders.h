// Folders as `asperity solve` writes them, whose contact is known in closed form: Hertz under load, Mindlin
// and Deresiewicz under shear at constant load, stiffnesses times a factor of the test's own.
#pragma once

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "core/atomic_file.h"
#include "core/shear_moduli.h"
#include "dem_compare/laws/hertzian_torsion.h"
#include "results/history.h"

namespace asperity::test {

struct SolvedFolder {
  std::string experiment = "sliding";  ///< normal, sliding or torsion
  double load = 1e-4;                  ///< [N]
  double stiffness = 1;                ///< lateral or torsion stiffness over that of the smooth contact
  double friction = 0.23;
  double mesh_error_of_friction = 0;  ///< stated, relative
  double mesh_error_of_approach = 0;  ///< the same; 0: not stated
  std::string roughness = "generated(rms=0.3 nm, hurst=0.8, rolloff=500 nm, cutoff=72 nm, seed=1)";
  std::string title{};
  ElasticBody particle{71e9, 0.17}, plane{179e9, 0.25};

  Hertz hertz() const { return {reduced_modulus(particle, plane), 8.5e-6}; }
  double lateral_stiffness() const {
    return stiffness * 8 * reduced_shear_modulus(particle, plane) * hertz().contact_radius(load);
  }
  double torsion_stiffness() const {
    return stiffness *
           no_slip_torsion_stiffness(torsion_modulus(particle, plane), hertz().contact_radius(load));
  }
};

/// Loading in five steps, then the motion as far as sliding.
inline History history_of(const SolvedFolder& solved) {
  History history;
  const auto add = [&](double force, double shift, double lateral) {
    for (const auto& column : history_columns())
      if (column.always) (history.*column.values).push_back(0);
    history.normal_force.back() = force;
    history.normal_displacement.back() = solved.hertz().approach(force);
    history.contact_area.back() = solved.hertz().contact_area(force);
    history.max_pressure.back() = solved.hertz().peak_pressure(force);
    history.lateral_displacement.back() = shift;
    history.lateral_force.back() = lateral;
  };
  for (int i = 1; i <= 5; ++i) add(solved.load * i / 5, 0, 0);
  if (solved.experiment != "sliding") return history;
  const double limit = solved.friction * solved.load, sliding = 1.5 * limit / solved.lateral_stiffness();
  // Mindlin & Deresiewicz 1953: f = limit (1 - (1 - x/x_slip)^(3/2)), x_slip = 3 limit/(2 k)
  for (const double share : {0.2, 0.5, 0.8, 1.0})
    add(solved.load, share * sliding, limit * (1 - std::pow(1 - share, 1.5)));
  for (const double share : {2., 3., 4., 5., 6., 7., 8.}) add(solved.load, share * sliding, limit);
  return history;
}

inline std::filesystem::path write_solved(const std::filesystem::path& folder, const SolvedFolder& solved) {
  const auto body = [](const ElasticBody& elastic) {
    return " set Young modulus = " + std::to_string(elastic.youngs_modulus / 1e9) +
           " GPa\n set Poisson ratio = " + std::to_string(elastic.poisson_ratio) + "\n";
  };
  std::filesystem::create_directories(folder);
  write_file_atomically(
      folder / "case.prm",
      "set Title = " + solved.title + "\nsubsection Particle\n set Radius = 8.5 um\n" +
          body(solved.particle) + "end\nsubsection Substrate\n" + body(solved.plane) +
          " set Topography = " + solved.roughness +
          "\nend\nsubsection Interface\n set Friction coefficient = " + std::to_string(solved.friction) +
          "\nend\nsubsection Experiment\n set Type = " + solved.experiment +
          "\n set Normal load = " + std::to_string(solved.load * 1e6) +
          " uN\nend\nsubsection Mesh\n set Interface spacing = 10 nm\nend\n");
  write_file_atomically(folder / "history.csv", format_history(history_of(solved)));
  nlohmann::json result{{"format", "asperity-result/1"}, {"experiment", solved.experiment}};
  const auto number = [](double value, double relative_sd) {
    return nlohmann::json{{"value", value}, {"sd", relative_sd * value}};
  };
  auto& effective = result["effective"];
  effective["normal_stiffness"] = number(solved.hertz().normal_stiffness(solved.load), 0.01);
  if (solved.mesh_error_of_approach > 0)
    effective["approach"] = number(solved.hertz().approach(solved.load), solved.mesh_error_of_approach);
  if (solved.experiment == "sliding") {
    effective["lateral_stiffness"] = number(solved.lateral_stiffness(), 0.03);
    effective["sliding_friction"] = number(solved.friction, solved.mesh_error_of_friction);
  }
  if (solved.experiment == "torsion") {
    effective["torsion_stiffness"] = number(solved.torsion_stiffness(), 0.03);
    effective["torsion_moment"] = number(
        full_slip_torsion_moment(solved.friction, solved.load, solved.hertz().contact_radius(solved.load)),
        0);
  }
  write_file_atomically(folder / "result.json", result.dump());
  return folder;
}

}  // namespace asperity::test
