// Scatter over realisations and error of the mesh: two numbers that are never mixed.
#pragma once

#include <limits>
#include <optional>
#include <vector>

namespace asperity {

/// What has no value, in tables and sums of them.
inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Mean over realisations of a rough surface.
/// All in the unit of the number.
struct Scatter {
  int count = 0;
  double mean = 0;
  double sd = 0;              ///< sample standard deviation of one realisation; NaN for a single one
  double standard_error = 0;  ///< of the mean, sd / count^(1/2); NaN for a single one
};
/// NaNs are left out.
Scatter scatter_of(const std::vector<double>& values);

/// Discretisation error from the same case on two or more spacings (Richardson 1911; Roache 1994): f(h) = f0
/// + c h^p.
/// f0 in the unit of f, the rest relative [-].
struct MeshError {
  double extrapolated = 0;  ///< f0, the limit of vanishing spacing
  double relative_error =
      0;  ///< (f(h_finest) - f0) / |f(h_finest)|: over the value itself, which is known better than f0
  /// Of relative_error, from its scatter over realisations: roughness meshed anew changes contact spot by
  /// contact spot. NaN for a single realisation, or where the order was found and not assumed.
  double standard_error = std::numeric_limits<double>::quiet_NaN();
  double order = 0;  ///< p
  bool order_is_assumed = false;
};
/// The order is found from the three finest spacings. Where there are two, or the three do not converge
/// monotonically or slower than with order 1/2, it is taken as `assumed_order` (1: the cautious choice,
/// contact edges spoil the second order of linear elements); where it comes out above 2, as 2. Throws
/// InputError for fewer than two spacings.
/// spacings [m].
MeshError mesh_error(std::vector<double> spacings, std::vector<double> values, double assumed_order = 1);

/// A result with both of its errors.
struct Estimate : Scatter {
  std::optional<MeshError> mesh;  ///< empty where one spacing was solved only
};

}  // namespace asperity
