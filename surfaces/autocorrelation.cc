#include "surfaces/autocorrelation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "surfaces/fft2d.h"

namespace asperity {
namespace {

/// Sum over pixels of f(x) f(x + d) for all lags d on the padded grid.
std::vector<double> correlate(const std::vector<double>& padded, int nx, int ny) {
  HalfSpectrum half = forward_fft(padded, nx, ny);
  for (auto& value : half) value = std::norm(value) / (static_cast<double>(nx) * ny);
  return inverse_fft(std::move(half), nx, ny);
}

}  // namespace

Autocorrelation autocorrelation(const Topography& map) {
  const std::size_t known = map.heights.size() - map.missing_count();
  if (known == 0) throw InputError("the topography '" + map.source + "' has no known points");
  double mean = 0;
  for (std::size_t i = 0; i < map.heights.size(); ++i)
    if (map.missing.empty() || !map.missing[i]) mean += map.heights[i];
  mean /= known;

  const int padded_nx = map.periodic ? map.nx : fast_fft_length(1.5 * map.nx + 1);
  const int padded_ny = map.periodic ? map.ny : fast_fft_length(1.5 * map.ny + 1);
  std::vector<double> heights(static_cast<std::size_t>(padded_nx) * padded_ny, 0.0), mask = heights;
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix) {
      if (!map.missing.empty() && map.missing[static_cast<std::size_t>(iy) * map.nx + ix]) continue;
      heights[static_cast<std::size_t>(iy) * padded_nx + ix] = map.at(ix, iy) - mean;
      mask[static_cast<std::size_t>(iy) * padded_nx + ix] = 1;
    }
  const std::vector<double> products = correlate(heights, padded_nx, padded_ny),
                            pairs = correlate(mask, padded_nx, padded_ny);

  Autocorrelation result;
  result.reach_x = map.periodic ? (map.nx - 1) / 2 : map.nx / 2;
  result.reach_y = map.periodic ? (map.ny - 1) / 2 : map.ny / 2;
  result.dx = map.dx(), result.dy = map.dy();
  const double variance = products[0] / known;
  for (int jy = -result.reach_y; jy <= result.reach_y; ++jy)
    for (int jx = -result.reach_x; jx <= result.reach_x; ++jx) {
      const std::size_t index =
          static_cast<std::size_t>((jy + padded_ny) % padded_ny) * padded_nx + (jx + padded_nx) % padded_nx;
      const double count = std::round(pairs[index]);
      result.rho.push_back(count > 0 ? products[index] / count / variance : 0.0);
      result.pair_share.push_back(count / known / known);
    }
  return result;
}

std::vector<double> Autocorrelation::radial() const {
  const int rings = static_cast<int>(std::min(reach_x * dx, reach_y * dy) / step()) + 1;
  std::vector<double> sum(rings, 0.0), weight(rings, 0.0);
  std::size_t index = 0;
  for (int jy = -reach_y; jy <= reach_y; ++jy)
    for (int jx = -reach_x; jx <= reach_x; ++jx, ++index) {
      const double distance = std::hypot(jx * dx, jy * dy) / step();
      const int ring = static_cast<int>(distance);
      // each lag is shared between the two distances it lies between
      const double upper = pair_share[index] * (distance - ring), lower = pair_share[index] - upper;
      if (ring < rings) sum[ring] += lower * rho[index], weight[ring] += lower;
      if (ring + 1 < rings) sum[ring + 1] += upper * rho[index], weight[ring + 1] += upper;
    }
  for (int ring = 0; ring < rings; ++ring) sum[ring] /= weight[ring];
  sum[0] = rho[rho.size() / 2];  // lag zero alone: the nearest neighbours belong to distance one
  return sum;
}

double Autocorrelation::length() const {
  const std::vector<double> mean = radial();
  const double target = std::exp(-1.0);
  for (std::size_t ring = 1; ring < mean.size(); ++ring)
    if (mean[ring] <= target) return step() * (ring - (target - mean[ring]) / (mean[ring - 1] - mean[ring]));
  return std::numeric_limits<double>::quiet_NaN();
}

double Autocorrelation::mean_power(int power) const {
  double sum = 0;
  for (std::size_t i = 0; i < rho.size(); ++i) sum += pair_share[i] * std::pow(rho[i], power);
  return sum;
}

}  // namespace asperity
