#include "paper/hertz_collision.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/root.h"

namespace asperity {

double hertz_restitution(double c) {
  const double no_return = 2 * std::sqrt(5.0 / 6);
  if (!(c >= 0 && c < no_return))
    throw InputError("a Hertz collision comes back for damping factors from 0 to 1.83 only");
  // Mass, E* R^(1/2) and impact speed are one: x'' = -(4/3) x^(3/2) - c (2 x^(1/2))^(1/2) x'.
  const auto acceleration = [c](double x, double v) {
    const double approach = std::max(x, 0.0);
    return -4.0 / 3 * std::pow(approach, 1.5) - c * std::sqrt(2 * std::sqrt(approach)) * v;
  };
  constexpr double step = 1e-4;  // of a collision that lasts about three
  double x = 0, v = 1;
  while (true) {
    const double k1 = acceleration(x, v), v2 = v + step / 2 * k1;
    const double k2 = acceleration(x + step / 2 * v, v2), v3 = v + step / 2 * k2;
    const double k3 = acceleration(x + step / 2 * v2, v3), v4 = v + step * k3;
    const double k4 = acceleration(x + step * v3, v4);
    const double next = x + step / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    if (next <= 0) return -v;
    x = next;
  }
}

double hertz_damping_factor(double restitution) {
  constexpr double strongest =
      1.1;  // a restitution just below 0.1; from 2 (5/6)^(1/2) on bodies do not part at all
  return root_between([&](double c) { return hertz_restitution(c) - restitution; }, 0.0, strongest, 30);
}

}  // namespace asperity
