// First pass of a hard sphere over a soft plane that it ploughs: the front half of the contact carries the
// load at the hardness H (Eldredge & Tabor 1955):   P = H pi a^2/2,   F = (2/3) H a^3/R. An upper bound where
// the whole contact yields; nothing of it is left in later passes over the same track, nor below yield (the
// paper's loads). SI units.
#pragma once

#include <cmath>

#include "dem_compare/laws/rotation_fields.h"

namespace asperity {

struct PlasticRolling {
  double hardness = 0;  ///< H [Pa]
  double radius = 0;    ///< R [m]
  RotationalStiffness stiffness{};
  static constexpr LengthScale length = LengthScale::particle_radius;

  /// a [m] of the front half at a force [N].
  double contact_radius(double normal_force) const { return std::sqrt(2 * normal_force / (M_PI * hardness)); }
  /// At the sphere's centre [N].
  double rolling_force(double normal_force) const {
    return 2.0 / 3 * hardness * std::pow(contact_radius(normal_force), 3) / radius;
  }
  /// About the contact [N m].
  double limit(const NormalState& normal, double lever) const {
    return normal.force > 0 ? rolling_force(normal.force) * lever : 0;
  }
};

inline const LawEntry<PlasticRolling, RollingMode> plastic_rolling_entry{
    {"plastic_rolling", "F = 2/3 H a^3/R, P = H pi a^2/2", "Eldredge & Tabor 1955",
     "fully plastic contact, first pass over a track"},
    {{{"hardness", "Pa", "H"}, &PlasticRolling::hardness}, {{"radius", "m", "R"}, &PlasticRolling::radius}},
    spring_fields<PlasticRolling>()};

}  // namespace asperity
