#include "surfaces/generate.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/error.h"
#include "core/quantity.h"
#include "surfaces/fft2d.h"
#include "surfaces/philox.h"

namespace asperity {
namespace {

/// Calls visit(ix, iy, kx, ky, q) for each wave vector of row iy of the half spectrum below the Nyquist wave
/// number.
template <typename Visit>
void for_each_wave_vector(int iy, int nx, int ny, double lx, double ly, Visit visit) {
  const int ky = signed_wave_number(iy, ny);
  if (2 * std::abs(ky) >= ny) return;
  const double qy = 2 * M_PI * ky / ly;
  for (int kx = 0; 2 * kx < nx; ++kx) {
    if (kx == 0 && ky == 0) continue;
    visit(kx, ky, std::hypot(2 * M_PI * kx / lx, qy));
  }
}

/// Amplitude of unit mean square that belongs to the wave vector (kx, ky), with kx > 0 or kx = 0 and ky > 0.
std::complex<double> unit_amplitude(int kx, int ky, const GenerateOptions& options) {
  if (options.amplitudes == Amplitudes::random) {
    const auto [a, b] = normal_pair(kx, ky, options.seed);
    return {a * M_SQRT1_2, b * M_SQRT1_2};
  }
  return std::polar(1.0, 2 * M_PI * uniform_pair(kx, ky, options.seed)[1]);
}

}  // namespace

double discrete_variance(const Spectrum& spectrum, int nx, int ny, double lx, double ly) {
  std::vector<double> row_sums(ny, 0.0);  // summed in a fixed order afterwards
#pragma omp parallel for schedule(static)
  for (int iy = 0; iy < ny; ++iy)
    for_each_wave_vector(iy, nx, ny, lx, ly, [&](int kx, int, double q) {
      row_sums[iy] += (kx == 0 ? 1 : 2) * spectrum(q);  // kx < 0 is the mirror image of kx > 0
    });
  double sum = 0;
  for (const double row_sum : row_sums) sum += row_sum;
  return sum / (lx * ly);
}

SelfAffineSpectrum spectrum_on_pixels(double rms, double hurst, double rolloff, double cutoff,
                                      double spacing) {
  constexpr double usual_cutoff = 20e-9, usual_rolloff = 200e-9, pixels_per_cutoff = 4,
                   cutoffs_per_rolloff = 10, pixels_per_wave = 2;
  SelfAffineSpectrum model;
  model.rms = rms;
  model.hurst = hurst;
  model.cutoff = cutoff > 0 ? cutoff : std::max(usual_cutoff, pixels_per_cutoff * spacing);
  model.rolloff = rolloff > 0 ? rolloff : std::max(usual_rolloff, cutoffs_per_rolloff * model.cutoff);
  model.check();
  const auto in_words = [](double value) { return format_quantity(value, Dimension::length, 4); };
  if (model.cutoff < pixels_per_wave * spacing * (1 - 1e-9))
    throw InputError("a cutoff of " + in_words(model.cutoff) +
                     " needs pixels of at most half of it, but they are " + in_words(spacing) +
                     "; pass more pixels or a longer cutoff");
  return model;
}

Topography generate_periodic(const Spectrum& spectrum, const GenerateOptions& options) {
  const int nx = options.nx, ny = options.ny;
  const double lx = options.lx, ly = options.ly, rms = options.rms;
  if (nx < 2 || ny < 2 || !(lx > 0) || !(ly > 0))
    throw InputError("a generated surface needs a size and at least 2 x 2 pixels");
  double scale = 1 / std::sqrt(lx * ly);
  if (rms >= 0) {
    const double variance = discrete_variance(spectrum, nx, ny, lx, ly);
    if (rms > 0 && !(variance > 0))
      throw InputError(
          "no wave of the spectrum fits between the size and two pixels; take a larger size or more pixels");
    scale *= rms > 0 ? rms / std::sqrt(variance) : 0.0;
  }

  const int columns = nx / 2 + 1;
  HalfSpectrum half(static_cast<std::size_t>(columns) * ny);
#pragma omp parallel for schedule(dynamic, 16)
  for (int iy = 0; iy < ny; ++iy)
    for_each_wave_vector(iy, nx, ny, lx, ly, [&](int kx, int ky, double q) {
      const double C = spectrum(q);
      if (C == 0) return;
      const bool mirrored = kx == 0 && ky < 0;  // a(-q) = conj a(q)
      std::complex<double> a = unit_amplitude(kx, mirrored ? -ky : ky, options);
      if (mirrored) a = std::conj(a);
      // pixel centres lie half a pixel from the origin: with this phase the surface does not move with the
      // pixel size
      const double phase = M_PI * (static_cast<double>(kx) / nx + static_cast<double>(ky) / ny);
      half[static_cast<std::size_t>(iy) * columns + kx] = a * std::polar(scale * std::sqrt(C), phase);
    });

  Topography map;
  map.nx = nx, map.ny = ny, map.lx = lx, map.ly = ly;
  map.heights = inverse_fft(std::move(half), nx, ny);
  map.periodic = true;
  map.channel = "Height";
  map.source = "generated, seed " + std::to_string(options.seed);
  return map;
}

Topography cut_window(const Topography& periodic, int ix, int iy, int nx, int ny, int stride) {
  Topography window;
  window.nx = nx, window.ny = ny;
  window.lx = nx * stride * periodic.dx(), window.ly = ny * stride * periodic.dy();
  window.channel = periodic.channel, window.source = periodic.source;
  window.heights.resize(static_cast<std::size_t>(nx) * ny);
  for (int y = 0; y < ny; ++y)
    for (int x = 0; x < nx; ++x)
      window.at(x, y) = periodic.at((ix + x * stride) % periodic.nx, (iy + y * stride) % periodic.ny);
  return window;
}

Topography generate_window(const Spectrum& spectrum, double longest_wavelength,
                           const GenerateOptions& options) {
  constexpr double margin = 8;  // longest wavelengths between a window and its periodic image
  GenerateOptions larger = options;
  const double dx = options.lx / options.nx, dy = options.ly / options.ny;
  larger.nx = fast_fft_length((options.lx + margin * longest_wavelength) / dx);
  larger.ny = fast_fft_length((options.ly + margin * longest_wavelength) / dy);
  larger.lx = larger.nx * dx, larger.ly = larger.ny * dy;
  const Topography periodic = generate_periodic(spectrum, larger);
  return cut_window(periodic, (larger.nx - options.nx) / 2, (larger.ny - options.ny) / 2, options.nx,
                    options.ny);
}

}  // namespace asperity
