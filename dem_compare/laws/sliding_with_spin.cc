#include "dem_compare/laws/sliding_with_spin.h"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <cmath>

#include "dem_compare/laws/hertzian_torsion.h"

namespace asperity {
namespace {

/// Integrals around the circle of radius r (over a): of the force and of the moment per pressure and radius.
struct Ring {
  double force, moment;
};

Ring ring(double r, double eps) {
  // With s = eps + r, k^2 = 4 eps r/s^2: int dt/D = 4 K(k)/s, int D dt = 4 s E(k), and
  // int sin t/D dt = ((eps^2 + r^2) int dt/D - int D dt)/(2 eps r).
  const double s = eps + r, k = 2 * std::sqrt(eps * r) / s;
  if (k >= 1 - 1e-15)
    return {4 / s * r, 4 / s * r * r};  // r = eps: the finite parts; D ln D vanishes in the integral
  const double inverse = 4 / s * boost::math::ellint_1(k), direct = 4 * s * boost::math::ellint_2(k);
  const double sine = ((eps * eps + r * r) * inverse - direct) / (2 * eps * r);
  return {eps * inverse - r * sine, r * (r * inverse - eps * sine)};
}

}  // namespace

SlipResistance SlidingWithSpin::resistance(double normal_force, double contact_radius,
                                           double velocity_over_spin) const {
  const double friction = coefficient * normal_force, eps = velocity_over_spin / contact_radius;
  if (std::isinf(eps)) return {friction, 0};
  if (eps == 0) return {0, full_slip_torsion_moment(coefficient, normal_force, contact_radius)};
  static boost::math::quadrature::tanh_sinh<double>
      integrator;  // its tables are costly; safe to share between threads
  // Hertz' pressure over P/a^2.
  const auto pressure = [](double r) { return 1.5 * M_1_PI * std::sqrt(std::max(0.0, 1 - r * r)); };
  const auto integrate = [&](auto part) {
    const auto integrand = [&](double r) { return r > 0 ? pressure(r) * r * part(ring(r, eps)) : 0.0; };
    if (eps >= 1) return integrator.integrate(integrand, 0.0, 1.0);
    return integrator.integrate(integrand, 0.0, eps) +
           integrator.integrate(integrand, eps, 1.0);  // a kink at r = eps
  };
  return {friction * integrate([](const Ring& c) { return c.force; }),
          friction * contact_radius * integrate([](const Ring& c) { return c.moment; })};
}

}  // namespace asperity
