#include "dem_compare/numbers/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/error.h"
#include "core/root.h"

namespace asperity {

Scatter scatter_of(const std::vector<double>& values) {
  Scatter scatter;
  double sum = 0;
  for (const double value : values)
    if (!std::isnan(value)) sum += value, ++scatter.count;
  scatter.mean = scatter.count ? sum / scatter.count : unknown;
  double squares = 0;
  for (const double value : values)
    if (!std::isnan(value)) squares += (value - scatter.mean) * (value - scatter.mean);
  scatter.sd = scatter.count > 1 ? std::sqrt(squares / (scatter.count - 1)) : unknown;
  scatter.standard_error = scatter.sd / std::sqrt(scatter.count);
  return scatter;
}

namespace {

/// Orders that three spacings are believed. Linear elements have the second, and a higher one is an accident
/// that would make the error look small; a lower one would make it look boundless.
constexpr double lowest_order = 0.5, highest_order = 2;

/// p of f0 + c h^p through three points h1 < h2 < h3; NaN if they do not converge monotonically.
double observed_order(const double* h, const double* f) {
  constexpr double lowest = 0.1, highest = 20;
  const double ratio = (f[2] - f[1]) / (f[1] - f[0]);
  const auto mismatch = [&](double p) {
    return (std::pow(h[2], p) - std::pow(h[1], p)) / (std::pow(h[1], p) - std::pow(h[0], p)) - ratio;
  };
  if (!std::isfinite(ratio) || mismatch(lowest) * mismatch(highest) > 0)
    return std::numeric_limits<double>::quiet_NaN();
  return root_between(mismatch, lowest, highest, 40);
}

}  // namespace

MeshError mesh_error(std::vector<double> spacings, std::vector<double> values, double assumed_order) {
  if (spacings.size() < 2 || spacings.size() != values.size())
    throw InputError("the mesh error needs the same case on two or more spacings");
  std::vector<std::size_t> finest_first(spacings.size());
  std::iota(finest_first.begin(), finest_first.end(), 0);
  std::sort(finest_first.begin(), finest_first.end(),
            [&](auto i, auto j) { return spacings[i] < spacings[j]; });
  const double unit = spacings[finest_first[0]];
  std::vector<double> h, f;
  for (const auto i : finest_first) h.push_back(spacings[i] / unit), f.push_back(values[i]);
  if (h[1] == h[0]) throw InputError("the mesh error needs spacings that differ");

  MeshError error;
  error.order = h.size() > 2 ? observed_order(h.data(), f.data()) : std::numeric_limits<double>::quiet_NaN();
  error.order_is_assumed = !(error.order >= lowest_order && error.order <= highest_order);
  if (error.order_is_assumed) error.order = error.order > highest_order ? highest_order : assumed_order;
  error.extrapolated = f[0] - (f[1] - f[0]) / (std::pow(h[1], error.order) - 1);
  error.relative_error = (f[0] - error.extrapolated) / std::abs(f[0]);
  return error;
}

}  // namespace asperity
