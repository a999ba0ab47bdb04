// Frictionless contact of an elastic sphere with an elastic plane (Hertz 1882; Johnson 1985, Contact
// Mechanics, ch. 3-4):
//   1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2,   F = (4/3) E* R^(1/2) delta^(3/2),   a^2 = R delta,
//   p0 = 3F/(2 pi a^2),   k_n = dF/d(delta) = 2 E* a.
// First yield under the surface, on the axis (von Mises or Tresca, equal there): p0 = C(nu) Y. SI units.
#pragma once

#include <cmath>
#include <limits>

namespace asperity {

/// Isotropic linear elasticity.
struct ElasticBody {
  double youngs_modulus = 0;  ///< E [Pa]
  double poisson_ratio = 0;   ///< nu [-]
};

/// E/(1 - nu^2), which is E* of a body against a rigid one [Pa].
inline double modulus_alone(const ElasticBody& body) {
  return body.youngs_modulus / (1 - body.poisson_ratio * body.poisson_ratio);
}

/// E* [Pa]
inline double reduced_modulus(const ElasticBody& one, const ElasticBody& other) {
  return 1 / (1 / modulus_alone(one) + 1 / modulus_alone(other));
}

/// Stresses on the axis of symmetry over the peak pressure p0, tension positive (Johnson 1985, eq. 3.45).
struct AxisStress {
  double radial = 0, axial = 0;  ///< sigma_r/p0 (= sigma_theta/p0), sigma_z/p0
  /// Both over p0 [-].
  double von_mises() const { return std::abs(radial - axial); }
  double largest_shear() const { return von_mises() / 2; }
};

/// At a depth z/a > 0 below the centre of contact.
inline AxisStress hertz_axis_stress(double depth_over_radius, double poisson_ratio) {
  const double z = depth_over_radius;
  const double axial = -1 / (1 + z * z);
  return {-(1 + poisson_ratio) * (1 - z * std::atan(1 / z)) - axial / 2, axial};
}

/// Place z/a and height (von Mises stress over p0) of the stress maximum on the axis.
struct SubsurfaceMaximum {
  double depth_over_radius = 0, von_mises = 0;
};

/// For Poisson's ratio nu [-].
SubsurfaceMaximum hertz_subsurface_maximum(double poisson_ratio);

/// C(nu) = p0/Y at first yield.
inline double hertz_yield_factor(double poisson_ratio) {
  return 1 / hertz_subsurface_maximum(poisson_ratio).von_mises;
}

/// One pair of bodies.
struct Hertz {
  double reduced_modulus = 0;  ///< E* [Pa]
  double radius = 0;           ///< R [m]

  /// Normal force F [N] at an approach delta [m]; 0 without contact.
  double force(double approach) const {
    return approach <= 0 ? 0 : 4.0 / 3.0 * reduced_modulus * std::sqrt(radius) * std::pow(approach, 1.5);
  }
  /// The inverse: delta [m] at F [N].
  double approach(double force) const {
    return std::pow(force / (4.0 / 3.0 * reduced_modulus * std::sqrt(radius)), 2.0 / 3.0);
  }
  /// a [m], pi a^2 [m^2], p0 [Pa] and k_n [N/m] at a normal force F [N].
  double contact_radius(double force) const { return std::sqrt(radius * approach(force)); }
  double contact_area(double force) const { return M_PI * radius * approach(force); }
  double peak_pressure(double force) const { return 1.5 * force / contact_area(force); }
  double normal_stiffness(double force) const { return 2 * reduced_modulus * contact_radius(force); }
  /// int F d(delta) = (2/5) F delta [J]
  double elastic_energy(double force) const { return 0.4 * force * approach(force); }
  /// Force at which p0 is reached (Johnson 1985, eq. 4.25).
  double force_at_peak_pressure(double pressure) const {
    const double a = M_PI * pressure * radius / (2 * reduced_modulus);
    return 2.0 / 3.0 * M_PI * a * a * pressure;
  }
  /// Load of first yield of a body with Poisson's ratio nu and yield stress Y; infinite for an elastic body.
  double first_yield_force(double poisson_ratio, double yield_stress) const {
    return std::isinf(yield_stress)
               ? yield_stress
               : force_at_peak_pressure(hertz_yield_factor(poisson_ratio) * yield_stress);
  }
};

}  // namespace asperity
