#include "diagnosis/conceal/rough_layer.h"

#include <boost/math/special_functions/ellint_1.hpp>
#include <cmath>

#include "core/error.h"
#include "diagnosis/conceal/normal_truth.h"
#include "diagnosis/conceal/tabled_contact.h"

namespace asperity::hidden {
namespace {

/// int s/(r + s) K(k) ds over a ring, midpoints graded towards s = r where K has a logarithm.
double ring_integral(double r, double inner, double outer) {
  const auto part = [&](double from, double to) {  // the singular end is `from`
    constexpr int points = 24;
    constexpr double grade = 3;
    double sum = 0;
    for (int i = 0; i < points; ++i) {
      const double t = (i + 0.5) / points, s = from + (to - from) * std::pow(t, grade);
      const double weight = std::abs(to - from) * grade * std::pow(t, grade - 1) / points;
      const double k = 2 * std::sqrt(r * s) / (r + s);
      sum += weight * s / (r + s) * boost::math::ellint_1(std::min(k, 1 - 1e-15));
    }
    return sum;
  };
  if (r <= inner) return part(inner, outer);
  if (r >= outer) return part(outer, inner);
  return part(r, inner) + part(r, outer);
}

}  // namespace

RoughLayer::RoughLayer(const Sphere& sphere, double decay_length, double pressure_at_zero_gap, double reach,
                       int rings)
    : length_(decay_length),
      pressure_(pressure_at_zero_gap),
      profile_(rings),
      area_(rings),
      influence_(rings, rings) {
  const double width = reach / rings;
  for (int i = 0; i < rings; ++i) {
    const double r = (i + 0.5) * width;
    profile_(i) = sphere.radius - std::sqrt(sphere.radius * sphere.radius - r * r);
    area_(i) = pi * width * width * (2 * i + 1);
    for (int j = 0; j < rings; ++j)
      influence_(i, j) = 4 / (pi * sphere.reduced_modulus) * ring_integral(r, j * width, (j + 1) * width);
  }
  log_pressure_ = Eigen::VectorXd::Constant(rings, -40.0);
}

double RoughLayer::force(double approach) {
  // Newton's method in q = ln(p/P0), from the last state; steps of q are kept within what the exponential
  // bears.
  constexpr int most_iterations = 3000;
  constexpr double longest_step = 2, tolerance = 1e-10;
  const Eigen::Index n = profile_.size();
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Eigen::VectorXd p = pressure_ * log_pressure_.array().exp();
    const Eigen::VectorXd residual =
        length_ * log_pressure_ + profile_ + influence_ * p - Eigen::VectorXd::Constant(n, approach);
    Eigen::MatrixXd slope = influence_ * p.asDiagonal();
    slope.diagonal().array() += length_;
    Eigen::VectorXd step = slope.partialPivLu().solve(residual);
    const double largest = step.cwiseAbs().maxCoeff();
    if (largest > longest_step) step *= longest_step / largest;
    log_pressure_ -= step;
    if (largest < tolerance) return area_.dot((pressure_ * log_pressure_.array().exp()).matrix());
  }
  throw WorkError("the rough layer's pressures did not settle");
}

/// Tabulated once; the zero of the approach is first touch, a thousandth of the largest force.
std::unique_ptr<NormalTruth> rough_truth(const Sphere& sphere, double length, double largest_approach) {
  std::vector<double> approach, force;
  constexpr double pressure_share = 0.02;  // of E*: asperities of slope 0.05 (Persson 2007)
  constexpr int rings = 56, points = 500;
  constexpr double first_touch = 1e-3, room = 1.7;
  const double largest_force = sphere.force(largest_approach);
  RoughLayer layer(sphere, length, pressure_share * sphere.reduced_modulus,
                   room * sphere.contact_radius(largest_approach + 4 * length), rings);
  const double low = -12 * length, high = largest_approach + 6 * length;
  double begin = low;
  for (int i = 0; i <= points; ++i) {
    const double d = low + (high - low) * i / points, f = layer.force(d);
    if (f < first_touch * largest_force) begin = d;
    approach.push_back(d);
    force.push_back(f);
  }
  for (double& d : approach) d -= begin;
  return std::make_unique<TabledContact>(std::move(approach), std::move(force));
}

}  // namespace asperity::hidden
