// Folders of moving cases as `asperity solve` writes them, made from known powers of each mechanism and from
// hills that give back what they take.
#pragma once

#include <cmath>
#include <filesystem>
#include <random>
#include <sstream>
#include <string>

#include "core/atomic_file.h"
#include "core/csv.h"
#include "core/hertz.h"

namespace asperity::test {

struct MovingFolder {
  std::string experiment = "sliding";
  double load = 1e-4;      ///< [N]
  double radius = 8.5e-6;  ///< [m]
  double friction = 20e-6, plastic = 0,
         adhesion = 0;  ///< dissipated per way [N] or [N m], with hardening stored beside it
  double noise = 0;  ///< of each power along the way, relative, correlated over a quarter of a contact radius
  double hills = 0;  ///< amplitude of the force of hills, over the whole of the powers
  double unbalanced = 0;      ///< energy per way that is lost from the balance
  double path_in_radii = 10;  ///< for torsion: the angle
  bool reverse = false;
  double way_back_in_radii = 0;  ///< 0: all of it
  double back = 1;               ///< plastic power on the way back, over that of the first
  double rms = 1.5;              ///< of the substrate [nm]; 0: smooth
  int seed = 1;
  std::string yield_stress = "3 GPa", work_of_adhesion = "0 J/m^2";
  double relaxing_share = 0;  ///< of the sphere's shear modulus
  double local_friction = 0.2, spacing = 1e-8;
  ElasticBody plane{179e9, 0.25};
  bool with_energies = true;
  double inclination = 0;  ///< of a rail [rad]: experiment "program" that rolls, and spins by its tangent;
                           ///< powers are per angle about the rail's axis
  double spin_moment = 0;  ///< part of them that resists the spin [N m]
  int rolls_towards = 1, spins_towards = 1;  ///< signs of a rail's two angles
  unsigned random = 1;

  Hertz hertz() const { return {reduced_modulus({71e9, 0.17}, plane), radius}; }
  double contact_radius() const { return hertz().contact_radius(load); }
  /// Way of one contact radius.
  double unit() const {
    if (experiment == "program") return contact_radius() / radius / std::cos(inclination);
    return experiment == "sliding"   ? contact_radius()
           : experiment == "rolling" ? contact_radius() / radius
                                     : 1;
  }
};

/// Loading in four steps, two steps of onset with everything sticking, then steady motion in steps of a
/// twentieth of a contact radius.
inline std::string moving_history(const MovingFolder& made) {
  const std::vector<std::string> names{"step",
                                       "time [s]",
                                       "normal_displacement [m]",
                                       "normal_force [N]",
                                       "lateral_displacement [m]",
                                       "lateral_force [N]",
                                       "rolling_angle [rad]",
                                       "rolling_moment [N m]",
                                       "torsion_angle [rad]",
                                       "torsion_moment [N m]",
                                       "contact_radius [m]",
                                       "contact_area [m^2]",
                                       "max_pressure [Pa]",
                                       "plastic_volume [m^3]",
                                       "dissipated_energy [J]",
                                       "elastic_energy [J]",
                                       "hardening_energy [J]",
                                       "plastic_work [J]",
                                       "friction_work [J]",
                                       "adhesion_energy [J]",
                                       "adhesion_loss [J]",
                                       "work [J]",
                                       "sticking_share"};
  std::vector<std::vector<double>> columns(made.with_energies ? names.size() : 15);
  std::mt19937 random(made.random);
  std::normal_distribution<double> normal;
  double friction = 0, plastic = 0, hardening = 0, adhesion = 0, work = 0, position = 0, step = 0;
  const auto add = [&](double force, double resistance, double elastic, double sticking) {
    const bool slides = made.experiment == "sliding", rolls = made.experiment == "rolling",
               spins = made.experiment == "torsion", both = made.experiment == "program";
    const double c = std::cos(made.inclination), s = std::sin(made.inclination);
    const std::vector<double> row{++step,
                                  step,
                                  made.hertz().approach(force),
                                  force,
                                  slides ? position : 0,
                                  slides ? resistance : 0,
                                  rolls  ? position
                                  : both ? made.rolls_towards * position * c
                                         : 0,
                                  rolls  ? resistance
                                  : both ? made.rolls_towards * (resistance - s * made.spin_moment) / c
                                         : 0,
                                  spins  ? position
                                  : both ? made.spins_towards * position * s
                                         : 0,
                                  spins  ? resistance
                                  : both ? made.spins_towards * made.spin_moment
                                         : 0,
                                  made.hertz().contact_radius(force),
                                  made.hertz().contact_area(force),
                                  1e9,
                                  0,
                                  friction + plastic - hardening + adhesion,
                                  elastic,
                                  hardening,
                                  plastic,
                                  friction,
                                  0,
                                  adhesion,
                                  work,
                                  sticking};
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i].push_back(row[i]);
  };
  for (int i = 1; i <= 4; ++i) add(made.load * i / 4, 0, 0, 1);
  constexpr int per_radius = 20;
  const double length = made.unit() / per_radius, all = made.friction + made.plastic + made.adhesion;
  const double hill_wave = 0.37 * 2 * M_PI / made.unit(), stored = made.hills * all / hill_wave;
  const double memory = std::exp(-4.0 / per_radius);
  double noises[3] = {normal(random), normal(random), normal(random)};
  const auto steps = static_cast<int>(std::lround(made.path_in_radii * per_radius));
  const auto move = [&](int direction, int steps, double share_of_plastic) {
    for (int i = 1; i <= steps + 2; ++i) {
      const bool onset = i <= 2;
      for (double& noise : noises) noise = memory * noise + std::sqrt(1 - memory * memory) * normal(random);
      const auto power = [&](double mean, int which) {
        return std::max(0.0, mean * (1 + made.noise * noises[which]));
      };
      const double f = onset ? 0 : power(made.friction, 0),
                   p = onset ? 0 : power(made.plastic * share_of_plastic, 1),
                   a = onset ? 0 : power(made.adhesion, 2);
      const double before = stored * std::sin(hill_wave * position);
      position += direction * length;
      const double after = stored * std::sin(hill_wave * position);
      friction += f * length, adhesion += a * length;
      // A quarter of the plastic work is stored by hardening, and not dissipated.
      plastic += p * length / 0.75, hardening += p * length * 0.25 / 0.75;
      const double done = (f + p / 0.75 + a + made.unbalanced) * length + after - before;
      work += done;
      add(made.load, direction * (onset ? 0 : f + p + a) + made.hills * all * std::cos(hill_wave * position),
          after, onset ? 0.5 : 0.01);
    }
  };
  move(1, steps, 1);
  if (made.reverse)
    move(-1, made.way_back_in_radii > 0 ? static_cast<int>(made.way_back_in_radii * per_radius) : steps,
         made.back);
  return format_csv({names.begin(), names.begin() + static_cast<long>(columns.size())}, columns);
}

inline std::filesystem::path write_moving(const std::filesystem::path& folder, const MovingFolder& made) {
  std::filesystem::create_directories(folder);
  std::ostringstream surface, prm;
  if (made.rms > 0)
    surface << "generated(rms=" << made.rms
            << " nm, hurst=0.8, rolloff=500 nm, cutoff=72 nm, seed=" << made.seed << ")";
  else
    surface << "smooth";
  prm << "subsection Particle\n set Radius = " << made.radius * 1e6
      << " um\n set Young modulus = 71 GPa\n set Poisson ratio = 0.17\n set Yield stress = "
      << made.yield_stress
      << "\n set Topography = generated(rms=0.7 nm, hurst=0.8, rolloff=500 nm, cutoff=72 nm, seed="
      << 100 + made.seed << ")\n";
  if (made.relaxing_share > 0)
    prm << " set Relaxing share = " << made.relaxing_share << "\n set Relaxation time = 0.1 s\n";
  prm << "end\nsubsection Substrate\n set Young modulus = " << made.plane.youngs_modulus * 1e-9
      << " GPa\n set Poisson ratio = " << made.plane.poisson_ratio
      << "\n set Yield stress = " << made.yield_stress << "\n set Topography = " << surface.str()
      << "\nend\nsubsection Interface\n set Friction coefficient = " << made.local_friction
      << "\n set Work of adhesion = " << made.work_of_adhesion
      << "\nend\nsubsection Experiment\n set Type = " << made.experiment
      << "\n set Normal load = " << made.load * 1e6 << " uN\n";
  if (made.experiment == "program") {
    const double way = made.path_in_radii * made.contact_radius();
    prm << " set Program = roll " << made.rolls_towards * way * 1e9 << " nm and spin "
        << made.spins_towards * std::tan(made.inclination) * way / made.radius << " rad\n";
  }
  prm << "end\nsubsection Mesh\n set Interface spacing = " << made.spacing * 1e9 << " nm\nend\n";
  write_file_atomically(folder / "case.prm", prm.str());
  write_file_atomically(folder / "history.csv", moving_history(made));
  write_file_atomically(folder / "result.json", R"({"format": "asperity-result/1", "experiment": ")" +
                                                    made.experiment + R"(", "effective": {},
    "balance": {"force": 2e-7, "energy": 0.003}})");
  return folder;
}

}  // namespace asperity::test
