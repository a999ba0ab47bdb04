#include "surfaces/spectrum.h"

#include <algorithm>
#include <cmath>

#include "surfaces/fft2d.h"
#include "surfaces/fill_missing.h"
#include "surfaces/levelling.h"

namespace asperity {
namespace {

/// Hann window of mean square one.
std::vector<double> hann(int n) {
  std::vector<double> window(n);
  for (int i = 0; i < n; ++i) window[i] = (1 - std::cos(2 * M_PI * (i + 0.5) / n)) / std::sqrt(1.5);
  return window;
}

/// Loss of independent wave vectors per direction: sum of the squared correlations between the periodogram at
/// a wave number and at its neighbours, 1 + 2 (2/3)^2 + 2 (1/6)^2 = 35/18 for Hann.
constexpr double hann_overlap = 35.0 / 18.0;

}  // namespace

TabulatedSpectrum RadialSpectrum::table() const {
  TabulatedSpectrum table;
  for (std::size_t i = 0; i < q.size(); ++i)
    if (C[i] > 0) table.q.push_back(q[i]), table.C.push_back(C[i]);
  return table;
}

RadialSpectrum radial_spectrum(const Topography& original) {
  Topography map = levelled(fill_missing(original), original.periodic ? Level::mean : Level::plane);
  double independent = 1;
  if (!original.periodic) {
    const auto wx = hann(map.nx), wy = hann(map.ny);
    for (int iy = 0; iy < map.ny; ++iy)
      for (int ix = 0; ix < map.nx; ++ix) map.at(ix, iy) *= wx[ix] * wy[iy];
    independent = 1 / (hann_overlap * hann_overlap);
  }
  const HalfSpectrum half = forward_fft(map.heights, map.nx, map.ny);

  const double pixels = static_cast<double>(map.nx) * map.ny;
  const double to_C = map.lx * map.ly / (pixels * pixels);
  const double ring_width = 2 * M_PI / std::min(map.lx, map.ly);
  const double nyquist = M_PI / std::max(map.dx(), map.dy());
  const int rings = static_cast<int>(nyquist / ring_width * (1 + 1e-9)) + 1;
  std::vector<double> power(rings, 0.0), wave_number(rings, 0.0), count(rings, 0.0);
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix <= map.nx / 2; ++ix) {
      const int ky = signed_wave_number(iy, map.ny);
      if (ix == 0 && ky <= 0) continue;  // the other half of the column kx = 0, and the mean
      const double q = std::hypot(2 * M_PI * ix / map.lx, 2 * M_PI * ky / map.ly);
      const int ring = static_cast<int>(std::lround(q / ring_width));
      if (ring == 0 || ring >= rings) continue;
      power[ring] += std::norm(half[static_cast<std::size_t>(iy) * (map.nx / 2 + 1) + ix]) * to_C;
      wave_number[ring] += q;
      count[ring] += 1;
    }

  RadialSpectrum spectrum;
  double sum = 0;
  for (int ring = 1; ring < rings; ++ring) {
    if (count[ring] == 0) continue;
    spectrum.q.push_back(wave_number[ring] / count[ring]);
    spectrum.C.push_back(power[ring] / count[ring]);
    spectrum.modes.push_back(std::max(1.0, count[ring] * independent));
    sum += 2 * power[ring] / (map.lx * map.ly);
  }
  spectrum.rms = std::sqrt(sum);
  return spectrum;
}

}  // namespace asperity
