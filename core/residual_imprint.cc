#include "core/residual_imprint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Approach `d` of a loading at a force; NaN above its steps.
double loading_approach(const std::vector<double>& d, const std::vector<double>& f, double force) {
  if (force <= 0) return 0;
  if (f.size() < 2 || f[0] <= 0 || d[0] <= 0 || d[1] <= d[0] || f[1] <= f[0]) return unknown;
  if (force < f[0]) return d[0] * std::pow(force / f[0], std::log(d[1] / d[0]) / std::log(f[1] / f[0]));
  // The turning points of loading and unloading may differ by the solver's tolerance.
  const double reached = std::min(force, f.back());
  std::size_t i = 0;
  while (i + 2 < f.size() && f[i + 1] < reached) ++i;
  const double g0 = std::pow(f[i], 2.0 / 3.0), g1 = std::pow(f[i + 1], 2.0 / 3.0);
  return d[i] + (std::pow(reached, 2.0 / 3.0) - g0) / (g1 - g0) * (d[i + 1] - d[i]);
}

}  // namespace

ResidualImprint residual_imprint(const std::vector<double>& loading, const std::vector<double>& loading_force,
                                 const std::vector<double>& unloading,
                                 const std::vector<double>& unloading_force) {
  if (unloading.size() < 2) return {unknown, unknown, unknown};
  std::size_t end = unloading.size() - 1;
  while (end > 1 && unloading_force[end - 1] <= 0) --end;
  const double force = std::max(0.0, unloading_force[end]);
  const double at_same_force = loading_approach(loading, loading_force, force);
  const bool extrapolated = force > 0 && std::isfinite(at_same_force) && force < loading_force[0];
  const double error =
      extrapolated ? std::abs(at_same_force - loading[0] * std::pow(force / loading_force[0], 2.0 / 3.0))
                   : 0.0;
  return {unloading[end] - at_same_force, force, error};
}

}  // namespace asperity
