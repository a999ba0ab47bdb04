// Shear moduli of a pair of elastic bodies, G = E/(2(1 + nu)):
//   sliding  1/G* = (2 - nu1)/G1 + (2 - nu2)/G2   (Cattaneo 1938; Mindlin 1949; not 2 - nu^2),
//   torsion  1/Gt = 1/G1 + 1/G2                   (Reissner & Sagoci 1944, both bodies in series). SI units.
// Valid for elastically similar bodies (Dundurs' beta = 0); a mismatch couples shear with pressure.
#pragma once

#include "core/hertz.h"

namespace asperity {

/// G of one body [Pa].
inline double shear_modulus(const ElasticBody& body) {
  return body.youngs_modulus / (2 * (1 + body.poisson_ratio));
}

/// G* of the lateral stiffness k_l = 8 G* a [Pa].
inline double reduced_shear_modulus(const ElasticBody& one, const ElasticBody& other) {
  return 1 /
         ((2 - one.poisson_ratio) / shear_modulus(one) + (2 - other.poisson_ratio) / shear_modulus(other));
}
/// k_l = 8 G* a, the lateral stiffness without slip (Mindlin 1949).
inline constexpr double mindlin_factor = 8;
/// Dundurs' beta [-]: how much of the pressure's displacement along the surface the other body does not
/// share; bodies of which it is zero touch without shear where friction would hold (Dundurs 1969; Johnson
/// 1985, eq. 5.3). The sign is that of the first body's larger displacement.
inline double dundurs_beta(const ElasticBody& one, const ElasticBody& other) {
  const double g1 = shear_modulus(one), g2 = shear_modulus(other);
  return ((1 - 2 * one.poisson_ratio) / g1 - (1 - 2 * other.poisson_ratio) / g2) /
         (2 * ((1 - one.poisson_ratio) / g1 + (1 - other.poisson_ratio) / g2));
}
/// Gt of the torsion stiffness (16/3) Gt a^3 [Pa].
inline double torsion_modulus(const ElasticBody& one, const ElasticBody& other) {
  return 1 / (1 / shear_modulus(one) + 1 / shear_modulus(other));
}

}  // namespace asperity
