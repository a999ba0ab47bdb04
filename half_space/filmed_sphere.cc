#include "half_space/filmed_sphere.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

namespace asperity::half_space {
double FilmedSphere::kernel(double y) const {
  double sum = 0;
  for (const FilmTerm& term : bodies_.terms)
    sum += term.share * term.reach / (term.reach * term.reach + y * y);
  return sum / M_PI;
}

double FilmedSphere::kernel_up_to(double x) const {
  double sum = 0;
  for (const FilmTerm& term : bodies_.terms) sum += term.share * std::atan(x / term.reach);
  return sum / M_PI;
}

/// g is even: of 64 points of Gauss between the edges those on one side are unknowns. Where K is narrower
/// than they are apart, g hardly changes over it, so that its integral is taken as a whole and the points
/// sum up what g differs from its value at x.
FilmedSphere::Contact FilmedSphere::at(double a, double sphere_radius) const {
  using Gauss = boost::math::quadrature::gauss<double, 64>;
  const auto& points = Gauss::abscissa();
  const auto& weights = Gauss::weights();
  constexpr int n = 32;
  Eigen::Matrix<double, n + 1, n + 1> matrix;  // the last row is that of the edge
  Eigen::Matrix<double, n + 1, 2> right;       // of a flat end, and of x^2/a^2
  for (int i = 0; i <= n; ++i) {
    const double x = i < n ? points[i] : 1;
    double by_points = 0;
    for (int j = 0; j < n; ++j) {
      matrix(i, j) = a * weights[j] * (kernel(a * (x - points[j])) + kernel(a * (x + points[j])));
      by_points += matrix(i, j);
    }
    matrix(i, n) = 0;
    matrix(i, i) += 1 + kernel_up_to(a * (1 - x)) + kernel_up_to(a * (1 + x)) - by_points;
    right.row(i) << 1, x * x;
  }
  const Eigen::Matrix<double, n + 1, 2> g = matrix.partialPivLu().solve(bodies_.of_films / M_PI * right);
  double flat = 0, curved = 0;
  for (int j = 0; j < n; ++j)
    flat += 2 * M_PI * a * weights[j] * g(j, 0), curved += 2 * M_PI * a * weights[j] * g(j, 1);
  const double height = a * a / sphere_radius, approach = height * g(n, 1) / g(n, 0);
  return {approach, flat * approach - curved * height, flat};
}

namespace {

/// Where a quantity that rises with the radius of the contact [m] reaches a value.
template <class Quantity>
double radius_where(const Quantity& quantity, double value, double low, double high) {
  constexpr int halvings = 40;
  for (int i = 0; i < halvings; ++i) {
    const double middle = std::sqrt(low * high);
    (quantity(middle) < value ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

}  // namespace

double FilmedSphere::radius_at_force(double force, double sphere_radius) const {
  if (!(force > 0)) return 0;
  const auto hertz = [&](double modulus) { return std::cbrt(0.75 * force * sphere_radius / modulus); };
  const double one = hertz(bare_), other = hertz(bodies_.of_films);
  constexpr double beyond = 1.5;  // on a soft film as thin as nothing the contact is wider by the root of two
  return radius_where([&](double a) { return at(a, sphere_radius).force; }, force,
                      std::min(one, other) / beyond, beyond * std::max(one, other));
}

double FilmedSphere::radius_at_approach(double approach, double sphere_radius) const {
  if (!(approach > 0)) return 0;
  const double hertz = std::sqrt(sphere_radius * approach);
  constexpr double beyond = 2;
  return radius_where([&](double a) { return at(a, sphere_radius).approach; }, approach, hertz / beyond,
                      beyond * hertz);
}

}  // namespace asperity::half_space
