// The autocorrelation of heights, from all pairs of known points (Wiener-Khinchin with zero padding, so that
// the two edges of a scan are not taken for neighbours; periodic maps wrap around).
#pragma once

#include <vector>

#include "surfaces/topography.h"

namespace asperity {

/// rho(dx, dy) = <h(x) h(x + d)> / <h^2> over the pairs of known points at lag d, heights counted from their
/// mean.
struct Autocorrelation {
  int reach_x = 0, reach_y = 0;  ///< largest lags kept, half the map [pixels]
  double dx = 0, dy = 0;         ///< pixel [m]
  /// rho and share of pairs, at [jy * (2 reach_x + 1) + jx] for lag (jx - reach_x, jy - reach_y)
  std::vector<double> rho, pair_share;

  /// Mean of rho over all directions at multiples of the larger pixel: entry k belongs to the distance k
  /// step().
  std::vector<double> radial() const;
  double step() const { return dx > dy ? dx : dy; }
  /// Distance at which the radial mean first falls to 1/e [m], interpolated linearly; NaN if it does not
  /// within half the map.
  double length() const;
  /// Mean of rho^power over all pairs of pixels: 1/mean(rho^k) is the number of independent samples for a
  /// k-th moment.
  double mean_power(int power) const;
};

/// Throws InputError if no point is known. A flat map has rho = NaN.
Autocorrelation autocorrelation(const Topography& map);

}  // namespace asperity
