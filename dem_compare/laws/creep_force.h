// Tractive rolling: a rolling contact that transmits a force Q slips a little, xi = (difference of the
// surfaces' speeds)/speed:
//   Q/(mu P) = 1 - (1 - y/3)^3,   y = C G a^2 xi/(mu P) <= 3   (Vermeulen & Johnson 1964; Shen, Hedrick &
//   Elkins 1983)
// with Kalker's coefficient C of the creep (1967), or C = 16/(4 - 3 nu) along, 16/(4 - nu) across the way of
// rolling (the original, up to 19 % high at small creep). With Kalker's C the law is up to 3 % low. One
// material, circular contact, steady rolling over more than 2 a. SI units.
#pragma once

#include <algorithm>
#include <cmath>

#include "dem_compare/laws/law_registry.h"

namespace asperity {

struct CreepForce {
  double shear_modulus = 0;      ///< G [Pa]
  double coefficient = 0;        ///< mu of sliding [-]
  double creep_coefficient = 0;  ///< C [-]
  static constexpr const char* ratio = "creep [1]";

  /// C along the rolling direction [-].
  static double vermeulen_johnson_along(double poisson_ratio) { return 16 / (4 - 3 * poisson_ratio); }
  /// C across it [-].
  static double vermeulen_johnson_across(double poisson_ratio) { return 16 / (4 - poisson_ratio); }

  /// Q [N] at a creep xi >= 0.
  double force(double creep, double normal_force, double contact_radius) const {
    const double y = creep_coefficient * shear_modulus * contact_radius * contact_radius * creep /
                     (coefficient * normal_force);
    return coefficient * normal_force * (1 - std::pow(std::max(0.0, 1 - y / 3), 3));
  }
  SlipResistance resistance(double normal_force, double contact_radius, double creep) const {
    return {force(creep, normal_force, contact_radius), 0};
  }
};

inline const LawEntry<CreepForce, SteadySlipMode> creep_force_entry{
    {"creep_force", "Q/(mu P) = 1 - (1 - y/3)^3, y = C G a^2 xi/(mu P)",
     "Vermeulen & Johnson 1964; Kalker 1967; Shen, Hedrick & Elkins 1983",
     "one material, circular contact, steady rolling"},
    {{{"shear_modulus", "Pa", "G"}, &CreepForce::shear_modulus},
     {{"sliding_coefficient", "", "mu of sliding"}, &CreepForce::coefficient},
     {{"creep_coefficient", "", "C"}, &CreepForce::creep_coefficient}}};

}  // namespace asperity
