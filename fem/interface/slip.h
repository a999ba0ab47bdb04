// Shear traction at a point that sticks up to a limit and slips beyond it (return mapping of rigid-plastic
// slip).
//
//   t = t*                 if |t*| < limit      (stick)
//   t = limit t* / |t*|    otherwise            (slip, along t*)
//   with t* = lambda - eps s:  lambda [Pa] traction before, s [m] slip since then, eps [Pa/m] penalty.
// Minus the derivative dt/ds is symmetric and never negative: for a fixed limit the slip work is a convex
// potential. Source: Alart & Curnier (1991), Comput. Methods Appl. Mech. Eng. 92, 353; Simo & Laursen (1992),
// Comput. Struct. 42, 97.
#pragma once

#include <array>
#include <cmath>

namespace asperity::fem {

using PlaneVector = std::array<double, 2>;

/// Traction and its tangent.
struct Shear {
  PlaneVector traction;  ///< [Pa]
  double xx, xy, yy;     ///< -dt/ds over eps [-]
  bool slips;
  double along = 0;  ///< of the tangent, along the slip: none for a given limit [-]

  /// |t|/|t*|: the traction is this share of the trial one.
  double secant() const { return slips ? xx + yy - along : 1; }
};

/// trial traction and limit [Pa].
inline Shear return_to_limit(const PlaneVector& trial, double limit) {
  const double size = std::hypot(trial[0], trial[1]);
  if (size < limit) return {trial, 1, 0, 1, false};
  if (size == 0) return {{0, 0}, 0, 0, 0, true};
  const double nx = trial[0] / size, ny = trial[1] / size, share = limit / size;
  return {{share * trial[0], share * trial[1]}, share * ny * ny, -share * nx * ny, share * nx * nx, true};
}

}  // namespace asperity::fem
