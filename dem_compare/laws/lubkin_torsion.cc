#include "dem_compare/laws/lubkin_torsion.h"

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/root.h"

namespace asperity {
namespace {

/// K(k') - E(k') with k'^2 = 1 - x^2, by the arithmetic-geometric mean (Abramowitz & Stegun 1964, 17.6):
/// K = pi/(2 agm), K - E = K sum 2^(n-1) c_n^2, which loses no digits at either end.
double stick_integral(double x) {
  double a = 1, b = x, weight = 0.5, sum = weight * (1 - x) * (1 + x);
  while (a - b > std::numeric_limits<double>::epsilon() * a) {
    const double c = (a - b) / 2, mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
    weight *= 2;
    sum += weight * c * c;
  }
  return M_PI / (2 * a) * sum;
}

/// (4/pi) [x^3 I(x) + 3 int_x^1 y^2 I(y) dy]
double moment_shape(double x) {
  static boost::math::quadrature::tanh_sinh<double>
      integrator;  // its tables are costly; safe to share between threads
  const auto integrand = [](double y) { return y * y * stick_integral(y); };
  const double rest = x < 1 ? integrator.integrate(integrand, x, 1.0) : 0.0;
  return 4 / M_PI * (x * x * x * stick_integral(x) + 3 * rest);
}

/// c/a where `shape`, falling from a positive value at the lower end to zero at 1, reaches `value`.
template <class Shape>
double stick_ratio_where(const Shape& shape, double value) {
  constexpr double smallest = std::numeric_limits<double>::min();
  // The search runs over log x: the stick zone shrinks exponentially with the angle.
  return std::exp(
      root_between([&](double log_x) { return shape(std::exp(log_x)) - value; }, std::log(smallest), 0.0));
}

}  // namespace

double LubkinTorsion::angle_at(double stick_ratio) const {
  return 3 * coefficient * normal_force / (4 * M_PI * torsion_modulus * contact_radius * contact_radius) *
         stick_integral(stick_ratio);
}

double LubkinTorsion::moment_at(double stick_ratio) const {
  return coefficient * normal_force * contact_radius * moment_shape(stick_ratio);
}

double LubkinTorsion::angle(double moment) const {
  if (moment == 0) return 0;
  const double shape = std::abs(moment) / (coefficient * normal_force * contact_radius);
  if (!(std::abs(moment) < full_slip_moment()))
    throw InputError(
        "a torsion moment at or beyond full slip (3 pi/16 mu P a) has no angle in Lubkin's law; give a "
        "smaller moment");
  return std::copysign(angle_at(stick_ratio_where(moment_shape, shape)), moment);
}

double LubkinTorsion::moment(double angle) const {
  if (angle == 0) return 0;
  const double shape = std::abs(angle) * 4 * M_PI * torsion_modulus * contact_radius * contact_radius /
                       (3 * coefficient * normal_force);
  if (shape >= stick_integral(std::numeric_limits<double>::min()))
    return std::copysign(full_slip_moment(), angle);
  return std::copysign(moment_at(stick_ratio_where(stick_integral, shape)), angle);
}

double PartialSlipTorsion::limit(const NormalState& normal, double) const {
  return full_slip_torsion_moment(sliding_coefficient, std::max(0.0, normal.force), normal.contact_radius);
}

TorsionHistory PartialSlipTorsion::advance(const TorsionHistory& before, const NormalState& normal,
                                           double lever, double increment) const {
  const double largest = limit(normal, lever);
  if (!normal.touching || !(largest > 0)) return {};
  TorsionHistory now = before;
  now.angle += increment;
  const double from = now.turns.empty() ? 0 : now.turns.back();
  if (increment * (before.angle - from) < 0) now.turns.push_back(before.angle);
  // A branch that comes back to the turn before the last one goes on as the branch that was left there; the
  // first branch back meets the virgin curve at the first turn's opposite.
  while (!now.turns.empty()) {
    const double last = now.turns.back(),
                 left = now.turns.size() > 1 ? now.turns[now.turns.size() - 2] : -last;
    if (std::abs(now.angle - last) < std::abs(left - last)) break;
    now.turns.resize(now.turns.size() - std::min<std::size_t>(2, now.turns.size()));
  }
  const LubkinTorsion curve{torsion_modulus, sliding_coefficient, normal.force, normal.contact_radius};
  now.resistance = 0;
  double start = 0, size = 1;
  for (std::size_t i = 0; i <= now.turns.size(); ++i) {
    const double end = i < now.turns.size() ? now.turns[i] : now.angle;
    now.resistance += size * curve.moment((end - start) / size);
    start = end;
    size = 2;
  }
  now.stiffness = no_slip_torsion_stiffness(torsion_modulus, normal.contact_radius);
  constexpr double rounding = 1e-9;
  now.yields = std::abs(now.resistance) >= largest * (1 - rounding);
  return now;
}

}  // namespace asperity
