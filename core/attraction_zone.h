// The zone at the edge of a contact in which a short-ranged attraction acts.
#pragma once

#include <cmath>

namespace asperity {

/// Length of the zone of an attraction whose stress at contact is s [Pa] and whose work of adhesion is w
/// [J/m^2], pi E* w/(4 s^2) (Dugdale 1960; Maugis 1992) [m]. reduced_modulus: E* [Pa].
inline double attraction_zone(double reduced_modulus, double work, double stress) {
  return M_PI * reduced_modulus * work / (4 * stress * stress);
}

/// Cells of finite elements over the zone, with which the pull-off force is some 4 % too large; with fewer it
/// grows quickly (docs/solver.md) [-].
constexpr double cells_over_attraction_zone = 3;

}  // namespace asperity
