// The two exact ends of torsion of a Hertzian contact: without slip, and slipping everywhere.
//   K = (16/3) Gt a^3,   1/Gt = 1/G1 + 1/G2    (Reissner & Sagoci 1944; Mindlin 1949)
//   M = (3 pi/16) mu P a                        (Lubkin 1951; Johnson 1985, sec. 7.3)
// Elastic half-spaces; torsion does not couple with pressure, whatever the mismatch of the bodies. SI units.
#pragma once

#include <cmath>

namespace asperity {

/// [N m/rad]
inline double no_slip_torsion_stiffness(double torsion_modulus, double contact_radius) {
  return 16.0 / 3.0 * torsion_modulus * contact_radius * contact_radius * contact_radius;
}
/// (3 pi/16) mu: coefficient of torsion for lambda = a
inline double full_slip_torsion_coefficient(double sliding_coefficient) {
  return 3 * M_PI / 16 * sliding_coefficient;
}
/// [N m]
inline double full_slip_torsion_moment(double sliding_coefficient, double normal_force,
                                       double contact_radius) {
  return full_slip_torsion_coefficient(sliding_coefficient) * normal_force * contact_radius;
}

}  // namespace asperity
