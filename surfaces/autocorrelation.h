// The autocorrelation of heights, from all pairs of known points (Wiener-Khinchin with zero padding, so that
// the two edges of a scan are not taken for neighbours; periodic maps wrap around).
#pragma once

#include <cstddef>
#include <vector>

#include "surfaces/topography.h"

namespace asperity {

/// rho(dx, dy) = <h(x) h(x + d)> / <h^2> over the pairs of known points at lag d, heights counted from their
/// mean.
struct Autocorrelation {
  int reach_x = 0, reach_y = 0;  ///< largest lags kept, half the map [pixels]
  double dx = 0, dy = 0;         ///< pixel [m]
  /// at [jy * (2 reach_x + 1) + jx] for lag (jx - reach_x, jy - reach_y) [-]
  std::vector<double> rho;
  int nx = 0, ny = 0;  ///< of the map [pixels]
  bool periodic = false;
  std::size_t known = 0;  ///< points of the map with a height
  /// Number of pairs at each lag [-]; empty where no point is missing, for it is then known without counting.
  std::vector<double> pairs;

  /// Number of pairs of known points at one lag [-], and its share of all pairs of them [-].
  double pair_count(std::size_t index) const;
  double pair_share(std::size_t index) const;

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
