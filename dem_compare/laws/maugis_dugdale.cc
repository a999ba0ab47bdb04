#include "dem_compare/laws/maugis_dugdale.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>
#include <sstream>
#include <tuple>

#include "core/error.h"
#include "core/hertz.h"

namespace asperity {
namespace {

/// A contact of radius a in Maugis' units, with the derivatives by a.
struct Dugdale {
  double force, force_slope, approach, approach_slope;
};

/// u = tan t reaches far over 1 for small contacts: searched for as t in (0, pi/2).
Dugdale dugdale(double a, double lambda) {
  const auto slope_by_m = [&](double u, double m, double t) {  // of the balance
    return lambda * a * a * (u / m + m * t) + 4.0 / 3 * lambda * lambda * a * (m * t / u + 1 / m - 1);
  };
  const auto balance = [&](double t) {  // and its derivative; the search looks inside of (0, pi/2) only
    const double u = std::tan(t), m = 1 / std::cos(t);
    const double value =
        lambda * a * a / 2 * (u + (m * m - 2) * t) + 4.0 / 3 * lambda * lambda * a * (u * t - m + 1) - 1;
    return std::make_tuple(value, slope_by_m(u, m, t) * m * u);
  };
  constexpr double quarter = M_PI / 2;
  std::uintmax_t iterations = 200;
  const double t = boost::math::tools::newton_raphson_iterate(
      balance, quarter / 2, 0.0, quarter, std::numeric_limits<double>::digits - 2, iterations);
  const double u = std::tan(t), m = 1 / std::cos(t);
  const double by_a = lambda * a * (u + (m * m - 2) * t) + 4.0 / 3 * lambda * lambda * (u * t - m + 1);
  const double m_slope = -by_a / slope_by_m(u, m, t);
  return {a * a * a - lambda * a * a * (u + m * m * t),
          3 * a * a - 2 * lambda * a * (u + m * m * t) - lambda * a * a * 2 * m * (1 / u + t) * m_slope,
          a * a - 4.0 / 3 * lambda * a * u, 2 * a - 4.0 / 3 * lambda * (u + a * m / u * m_slope)};
}

/// Smallest radius that is told from none, in Maugis' units.
constexpr double smallest = 1e-6;

/// Largest radius where `value` (convex and rising there) reaches `target`, by Newton's method from above; 0
/// if none.
template <class Value, class Slope>
double descend(double a, double lambda, double target, const Value& value, const Slope& slope) {
  constexpr int most_iterations = 200;
  for (int i = 0; i < most_iterations; ++i) {
    const Dugdale contact = dugdale(a, lambda);
    if (!(slope(contact) > 0)) return 0;
    const double next = a - (value(contact) - target) / slope(contact);
    if (next < smallest) return 0;
    if (next >= a * (1 - 4 * std::numeric_limits<double>::epsilon())) return next;
    a = next;
  }
  return a;
}

}  // namespace

double MaugisDugdale::lambda() const { return units().lambda(cohesive_stress); }

double MaugisDugdale::pull_off_force() const {
  const double l = lambda(), widest = 3;  // every pull-off radius lies below (3/2)^(1/3)
  const auto minimum =
      boost::math::tools::brent_find_minima([&](double a) { return dugdale(a, l).force; }, smallest, widest,
                                            std::numeric_limits<double>::digits / 2);
  return -minimum.second * units().force();
}

NormalState MaugisDugdale::advance(const NormalState& before, double approach) const {
  if (approach < 0 && !before.touching) return {approach, 0, 0, 0, false};
  const double target = approach / units().approach(), l = lambda();
  const double above =
      std::sqrt(std::max(0.0, target)) + std::cbrt(8.0 / 3);  // over JKR's radius, over every other
  const double a = descend(
      above, l, target, [](const Dugdale& c) { return c.approach; },
      [](const Dugdale& c) { return c.approach_slope; });
  if (a == 0) return {approach, 0, 0, 0, false};
  const Dugdale contact = dugdale(a, l);
  return {approach, contact.force * units().force(), a * units().length(),
          contact.force_slope / contact.approach_slope * units().force() / units().approach(), true};
}

double MaugisDugdale::approach(double force) const {
  const double target = force / units().force(), l = lambda();
  const double above =
      std::cbrt(std::max(0.0, target)) + 3;  // over JKR's radius, cbrt(P + 3 + (6 P + 9)^(1/2))
  const double a = descend(
      above, l, target, [](const Dugdale& c) { return c.force; },
      [](const Dugdale& c) { return c.force_slope; });
  if (a == 0) {
    std::ostringstream message;
    message << "an adhesive contact cannot carry " << force * 1e6 << " uN; its pull-off force is "
            << pull_off_force() * 1e6 << " uN";
    throw InputError(message.str());
  }
  return dugdale(a, l).approach * units().approach();
}

}  // namespace asperity
