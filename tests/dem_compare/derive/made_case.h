// Solved cases made from laws with noise, as `solve` writes them.
#pragma once

#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "core/quantity.h"
#include "core/shear_moduli.h"
#include "dem_compare/derive/derivation.h"
#include "dem_compare/laws/lubkin_torsion.h"

namespace asperity::test {

inline const ElasticBody glass{71e9, 0.17}, silicon{179e9, 0.25};
inline const Hertz standard{reduced_modulus(glass, silicon), 8.5e-6};

struct Truth {
  double mu = 0.23, offset = 12e-6;  ///< sliding
  double torsion_coefficient = 0.12, torsion_offset = 12e-6;
  bool torsion_with_contact = true;  ///< lambda = a, else r
  double noise = 0.02;               ///< of the resistance along the way, relative
  double realisation_scatter = 0;    ///< relative
};

/// A way of sliding, torsion or rolling there and back, as `solve` writes it; noise correlated over about two
/// steps.
inline SolvedCase make_case(const Truth& truth, const std::string& type, double load, int seed,
                            std::mt19937& random, const Hertz& hertz = standard) {
  std::normal_distribution<double> normal;
  const bool sliding = type == "sliding", rolling = type == "rolling";
  const double a = hertz.contact_radius(load);
  const double length = sliding ? 1 : truth.torsion_with_contact ? a : hertz.radius;
  const double mu = sliding ? truth.mu : truth.torsion_coefficient,
               offset = sliding ? truth.offset : truth.torsion_offset;
  const double limit = mu * length * (load + offset);
  const double stiffness = sliding ? 8 * reduced_shear_modulus(glass, silicon) * a
                                   : no_slip_torsion_stiffness(torsion_modulus(glass, silicon), a);
  // Virgin curve: bilinear is enough, the stiffness has tests of its own.
  const auto virgin = [&](double way) { return std::min(limit, stiffness * way); };
  History history;
  double correlated = 0;
  const auto add = [&](double force, double position, double resistance) {
    for (const auto& column : history_columns())
      if (column.always) (history.*column.values).push_back(0);
    history.normal_force.back() = force;
    history.normal_displacement.back() = hertz.approach(force);
    history.contact_radius.back() = hertz.contact_radius(force);
    history.contact_area.back() = hertz.contact_area(force);
    (sliding   ? history.lateral_displacement
     : rolling ? history.rolling_angle
               : history.torsion_angle)
        .back() = position;
    (sliding   ? history.lateral_force
     : rolling ? history.rolling_moment
               : history.torsion_moment)
        .back() = resistance;
  };
  constexpr int load_steps = 8;
  for (int i = 1; i <= load_steps; ++i) add(load * i / load_steps, 0, 0);
  const double slip_way = limit / stiffness, way = 40 * slip_way;
  const auto noisy = [&](double resistance) {
    correlated = 0.5 * correlated + std::sqrt(0.75) * normal(random);
    return resistance * (1 + truth.noise * correlated);
  };
  std::vector<double> ways{0.5 * slip_way, slip_way};
  constexpr int steps = 150;
  for (int i = 1; i <= steps; ++i) ways.push_back(slip_way + (way - slip_way) * i / steps);
  std::normal_distribution<double> scatter(1, truth.realisation_scatter);
  std::mt19937 of_seed(static_cast<unsigned>(seed * 7919) + static_cast<unsigned>(random()));
  const double common = truth.realisation_scatter > 0 ? scatter(of_seed) : 1;
  for (const double w : ways) add(load, w, w > slip_way ? common * noisy(virgin(w)) : common * virgin(w));
  for (const double w : ways)
    add(load, way - w, w > 2 * slip_way ? -common * noisy(limit) : common * (limit - 2 * virgin(w / 2)));
  std::map<std::string, std::string> entries{
      {"Particle/Radius", format_quantity(hertz.radius, Dimension::length)},
      {"Particle/Young modulus", "71 GPa"},
      {"Particle/Poisson ratio", "0.17"},
      {"Substrate/Young modulus", "179 GPa"},
      {"Substrate/Poisson ratio", "0.25"},
      {"Interface/Friction coefficient", "0.2"},
      {"Experiment/Type", type},
      {"Substrate/Topography", "generated(rms=1.5 nm, seed=" + std::to_string(seed) + ")"}};
  SolvedCase solved;
  solved.folder = type + "_" + std::to_string(load) + "_" + std::to_string(seed);
  solved.entries = CaseEntries(entries);
  solved.result = case_result_of({{"format", CaseResult::format},
                                  {"experiment", type},
                                  {"mesh", {{"interface_spacing", 1e-8}}},
                                  {"versions", {{"asperity", "0.1.0"}}}},
                                 "made");
  solved.history = history;
  return solved;
}

}  // namespace asperity::test
