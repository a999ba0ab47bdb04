// How far attraction widens the contact of smooth spheres, and the zone at its edge in which it acts.
#pragma once

#include <cmath>

#include "core/hertz.h"

namespace asperity {

/// Length of the zone of an attraction whose stress at contact is s [Pa] and whose work of adhesion is w
/// [J/m^2], pi E* w/(4 s^2) (Dugdale 1960; Maugis 1992) [m]. reduced_modulus: E* [Pa].
inline double attraction_zone(double reduced_modulus, double work, double stress) {
  return M_PI * reduced_modulus * work / (4 * stress * stress);
}

/// Cells of finite elements over the zone, with which the pull-off force is some 4 % too large; with fewer it
/// grows quickly (docs/solver.md) [-].
constexpr double cells_over_attraction_zone = 3;

/// Radius of a smooth contact under a force F [N] that attraction of a range of nothing and a work of
/// adhesion w [J/m^2] widens, a^3 = 3 R/(4 E*) (F + c + (2 c F + c^2)^(1/2)), c = 3 pi w R (Johnson, Kendall
/// & Roberts 1971) [m]: the most that attraction can. E* [Pa], R [m].
inline double radius_widest_by_attraction(double reduced_modulus, double radius, double work, double force) {
  const double c = 3 * M_PI * work * radius;
  return Hertz{reduced_modulus, radius}.contact_radius(force + c + std::sqrt(2 * c * force + c * c));
}

/// The same of attraction of a long range, which presses like a force of 2 pi w R on top (Derjaguin, Muller &
/// Toporov 1975) [m]: the least.
inline double radius_least_by_attraction(double reduced_modulus, double radius, double work, double force) {
  return Hertz{reduced_modulus, radius}.contact_radius(force + 2 * M_PI * work * radius);
}

}  // namespace asperity
