#include "surfaces/autocorrelation.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <limits>

#include "core/error.h"
#include "surfaces/fft2d.h"
#include "surfaces/fftw_parts.h"

namespace asperity {
namespace {

constexpr std::size_t worth_sharing = 1u << 18;  // points; below, starting threads costs more than it saves

/// The map, the grid with zeros around it that its transform takes, and the lags that are kept.
struct LagGrid {
  int nx = 0, ny = 0, padded_nx = 0, padded_ny = 0, reach_x = 0, reach_y = 0;

  int columns() const { return padded_nx / 2 + 1; }
  int lags_x() const { return 2 * reach_x + 1; }
  int lags_y() const { return 2 * reach_y + 1; }
  bool is_large() const { return static_cast<std::size_t>(padded_nx) * padded_ny > worth_sharing; }
};

LagGrid lag_grid(const Topography& map) {
  LagGrid grid{map.nx, map.ny, map.nx, map.ny, (map.nx - 1) / 2, (map.ny - 1) / 2};
  if (map.periodic) return grid;
  grid.padded_nx = fast_fft_length(1.5 * map.nx + 1);
  grid.padded_ny = fast_fft_length(1.5 * map.ny + 1);
  grid.reach_x = map.nx / 2;
  grid.reach_y = map.ny / 2;
  return grid;
}

/// Rows of the map transformed along x; those of zeros around it need no memory.
template <class ValueAt>
void transform_rows(const LagGrid& grid, const ValueAt& value_at, HalfSpectrum& rows) {
  const FftwPlan plan = plan_to_complex(grid.padded_nx);
#pragma omp parallel if (grid.is_large())
  {
    const auto in = fftw_reals(grid.padded_nx);
    const auto out = fftw_complexes(grid.columns());
#pragma omp for schedule(static)
    for (int iy = 0; iy < grid.ny; ++iy) {
      std::fill_n(in.get(), grid.padded_nx, 0.0);
      for (int ix = 0; ix < grid.nx; ++ix) in[ix] = value_at(ix, iy);
      fftw_execute_dft_r2c(plan.get(), in.get(), out.get());
      for (int ix = 0; ix < grid.columns(); ++ix)
        rows[static_cast<std::size_t>(iy) * grid.columns() + ix] = {out[ix][0], out[ix][1]};
    }
  }
}

/// Each column to its power spectrum and back: rows [0, ny) of the map become rows of the lags along y that
/// are kept, from -reach_y on.
void correlate_columns(const LagGrid& grid, HalfSpectrum& rows) {
  const FftwPlan forward = plan_complex(grid.padded_ny, FFTW_FORWARD),
                 backward = plan_complex(grid.padded_ny, FFTW_BACKWARD);
  const double pixels = static_cast<double>(grid.padded_nx) * grid.padded_ny;
  constexpr int block = 8;  // columns gathered together: one cache line of each row is used whole
#pragma omp parallel if (grid.is_large())
  {
    std::vector<FftwComplexes> lines;
    for (int b = 0; b < block; ++b) lines.push_back(fftw_complexes(grid.padded_ny));
#pragma omp for schedule(static)
    for (int first = 0; first < grid.columns(); first += block) {
      const int width = std::min(block, grid.columns() - first);
      for (int iy = 0; iy < grid.padded_ny; ++iy)
        for (int b = 0; b < width; ++b) {
          const auto value = iy < grid.ny ? rows[static_cast<std::size_t>(iy) * grid.columns() + first + b]
                                          : std::complex<double>(0.0);
          lines[b][iy][0] = value.real();
          lines[b][iy][1] = value.imag();
        }
      for (int b = 0; b < width; ++b) {
        fftw_complex* line = lines[b].get();
        fftw_execute_dft(forward.get(), line, line);
        for (int iy = 0; iy < grid.padded_ny; ++iy) {
          line[iy][0] = std::norm(std::complex<double>(line[iy][0], line[iy][1])) / pixels;
          line[iy][1] = 0;
        }
        fftw_execute_dft(backward.get(), line, line);
      }
      for (int lag = 0; lag < grid.lags_y(); ++lag) {
        const int iy = (lag - grid.reach_y + grid.padded_ny) % grid.padded_ny;
        for (int b = 0; b < width; ++b)
          rows[static_cast<std::size_t>(lag) * grid.columns() + first + b] = {lines[b][iy][0],
                                                                              lines[b][iy][1]};
      }
    }
  }
}

/// Sum over pixels of f(x) f(x + d) for all lags d that are kept, in the order of Autocorrelation::rho.
template <class ValueAt>
std::vector<double> lag_products(const LagGrid& grid, const ValueAt& value_at) {
  HalfSpectrum rows(static_cast<std::size_t>(grid.columns()) * std::max(grid.ny, grid.lags_y()));
  transform_rows(grid, value_at, rows);
  correlate_columns(grid, rows);
  std::vector<double> products(static_cast<std::size_t>(grid.lags_x()) * grid.lags_y());
  const FftwPlan plan = plan_to_real(grid.padded_nx);
#pragma omp parallel if (grid.is_large())
  {
    const auto in = fftw_complexes(grid.columns());
    const auto out = fftw_reals(grid.padded_nx);
#pragma omp for schedule(static)
    for (int lag = 0; lag < grid.lags_y(); ++lag) {
      for (int ix = 0; ix < grid.columns(); ++ix) {
        const auto& value = rows[static_cast<std::size_t>(lag) * grid.columns() + ix];
        in[ix][0] = value.real();
        in[ix][1] = value.imag();
      }
      fftw_execute_dft_c2r(plan.get(), in.get(), out.get());
      for (int i = 0; i < grid.lags_x(); ++i)
        products[static_cast<std::size_t>(lag) * grid.lags_x() + i] =
            out[(i - grid.reach_x + grid.padded_nx) % grid.padded_nx];
    }
  }
  return products;
}

}  // namespace

Autocorrelation autocorrelation(const Topography& map) {
  const std::size_t known = map.heights.size() - map.missing_count();
  if (known == 0) throw InputError("the topography '" + map.source + "' has no known points");
  const auto is_known = [&](int ix, int iy) {
    return map.missing.empty() || !map.missing[static_cast<std::size_t>(iy) * map.nx + ix];
  };
  double mean = 0;
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
      if (is_known(ix, iy)) mean += map.at(ix, iy);
  mean /= known;

  const LagGrid grid = lag_grid(map);
  Autocorrelation result;
  result.reach_x = grid.reach_x, result.reach_y = grid.reach_y;
  result.dx = map.dx(), result.dy = map.dy();
  result.nx = map.nx, result.ny = map.ny, result.periodic = map.periodic;
  result.known = known;
  if (known < map.heights.size()) {
    result.pairs = lag_products(grid, [&](int ix, int iy) { return is_known(ix, iy) ? 1.0 : 0.0; });
    for (double& count : result.pairs) count = std::round(count);
  }
  result.rho =
      lag_products(grid, [&](int ix, int iy) { return is_known(ix, iy) ? map.at(ix, iy) - mean : 0.0; });
  const double variance = result.rho[result.rho.size() / 2] / known;  // of lag zero
  for (std::size_t i = 0; i < result.rho.size(); ++i) {
    const double count = result.pair_count(i);
    result.rho[i] = count > 0 ? result.rho[i] / count / variance : 0.0;
  }
  return result;
}

double Autocorrelation::pair_count(std::size_t index) const {
  if (!pairs.empty()) return pairs[index];
  if (periodic) return static_cast<double>(nx) * ny;
  const int lags_x = 2 * reach_x + 1;
  const int jx = static_cast<int>(index % lags_x) - reach_x, jy = static_cast<int>(index / lags_x) - reach_y;
  return static_cast<double>(nx - std::abs(jx)) * (ny - std::abs(jy));
}

double Autocorrelation::pair_share(std::size_t index) const { return pair_count(index) / known / known; }

std::vector<double> Autocorrelation::radial() const {
  const int rings = static_cast<int>(std::min(reach_x * dx, reach_y * dy) / step()) + 1;
  std::vector<double> sum(rings, 0.0), weight(rings, 0.0);
  std::size_t index = 0;
  for (int jy = -reach_y; jy <= reach_y; ++jy)
    for (int jx = -reach_x; jx <= reach_x; ++jx, ++index) {
      const double distance = std::hypot(jx * dx, jy * dy) / step();
      const int ring = static_cast<int>(distance);
      // each lag is shared between the two distances it lies between
      const double share = pair_share(index);
      const double upper = share * (distance - ring), lower = share - upper;
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
  for (std::size_t i = 0; i < rho.size(); ++i) sum += pair_share(i) * std::pow(rho[i], power);
  return sum;
}

}  // namespace asperity
