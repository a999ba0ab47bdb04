#include "surfaces/virtual_afm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include "core/error.h"
#include "core/quantity.h"
#include "core/root.h"
#include "surfaces/fft2d.h"
#include "surfaces/generate.h"
#include "surfaces/statistics.h"

namespace asperity {
namespace {

/// Share of a wave exp(i q x) along one direction of a window that {1} and {x} take away: squared moduli of
/// its mean and of its projection onto x (normalised on the pixels).
struct Projection {
  double constant = 0, linear = 0;
};

Projection project(double q, double spacing, int pixels) {
  std::complex<double> constant = 0, linear = 0;
  const std::complex<double> turn = std::polar(1.0, q * spacing);
  std::complex<double> wave = std::polar(1.0, -0.5 * q * spacing * (pixels - 1));
  for (int i = 0; i < pixels; ++i, wave *= turn) {
    constant += wave;
    linear += wave * (i - 0.5 * (pixels - 1));
  }
  const double n = pixels;
  const double norm = n * (n * n - 1) / 12;  // sum of (i - mean)^2
  return {std::norm(constant) / (n * n), std::norm(linear) / (n * norm)};
}

std::vector<Projection> projections(int n, double period, double spacing, int pixels) {
  std::vector<Projection> table(n);
#pragma omp parallel for schedule(static)
  for (int i = 0; i < n; ++i)
    table[i] = project(2 * M_PI * signed_wave_number(i, n) / period, spacing, pixels);
  return table;
}

}  // namespace

AfmGrid afm_grid(const SelfAffineSpectrum& spectrum, const AfmSettings& afm) {
  constexpr double scans = 4, rolloffs = 4;
  constexpr double pixels_per_cutoff = 2;  // the least that carries the shortest wave
  constexpr double pixels_per_radius = 4;  // of a tip
  constexpr int largest = 16384;
  const double spacing = afm.size / afm.pixels;
  double finest = spectrum.cutoff / pixels_per_cutoff;
  if (afm.tip.radius > 0) finest = std::min(finest, afm.tip.radius / pixels_per_radius);
  AfmGrid grid;
  grid.stride = std::max(1, static_cast<int>(std::ceil(spacing / finest * (1 - 1e-9))));
  const double pixels = std::max(scans * afm.size, rolloffs * spectrum.rolloff) / spacing;
  if (pixels * grid.stride > largest)
    throw InputError("a virtual scan of this surface needs more than " + std::to_string(largest) +
                     " pixels a side; take a longer cutoff, a shorter rolloff or a larger tip");
  grid.pixels = fast_fft_length(pixels) * grid.stride;
  grid.period = grid.pixels * spacing / grid.stride;
  return grid;
}

Topography afm_surface(const SelfAffineSpectrum& spectrum, const AfmSettings& afm, std::uint64_t seed) {
  spectrum.check();
  const AfmGrid grid = afm_grid(spectrum, afm);
  GenerateOptions options;
  options.nx = options.ny = grid.pixels;
  options.lx = options.ly = grid.period;
  options.seed = seed;
  options.rms = spectrum.rms;
  return generate_periodic(spectrum, options);
}

namespace {

/// Windows whose lower left corners are these pixels of the surface, seen by the tip and levelled.
std::vector<Topography> cut_and_level(const Topography& surface, const AfmSettings& afm,
                                      const std::vector<std::array<int, 2>>& corners) {
  const Topography image = dilated(surface, afm.tip);
  const int stride = static_cast<int>(std::lround(afm.size / afm.pixels / image.dx()));
  std::vector<Topography> windows(corners.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t i = 0; i < corners.size(); ++i)
    windows[i] = levelled(cut_window(image, corners[i][0], corners[i][1], afm.pixels, afm.pixels, stride),
                          Level::plane);
  return windows;
}

}  // namespace

std::vector<Topography> afm_windows(const Topography& surface, const AfmSettings& afm) {
  // corners (i, 2 i) / n of the period: for five windows none are closer than 1/5 of the period in one of the
  // directions
  std::vector<std::array<int, 2>> corners;
  for (int i = 0; i < afm.windows; ++i)
    corners.push_back({surface.nx * i / afm.windows, surface.ny * (2 * i % afm.windows) / afm.windows});
  return cut_and_level(surface, afm, corners);
}

std::vector<Topography> all_afm_windows(const Topography& surface, const AfmSettings& afm) {
  const int width = static_cast<int>(std::lround(afm.size / surface.dx()));
  std::vector<std::array<int, 2>> corners;
  for (int iy = 0; iy + width <= surface.ny; iy += width)
    for (int ix = 0; ix + width <= surface.nx; ix += width) corners.push_back({ix, iy});
  return cut_and_level(surface, afm, corners);
}

AfmMeasurement measure(const std::vector<Topography>& windows) {
  const std::size_t n = windows.size();
  std::vector<double> Sq(n), Sz(n), Ssk(n), Sku(n), profile(n);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t i = 0; i < n; ++i) {
    const HeightMoments moments = height_moments(windows[i]);
    Sq[i] = moments.Sq, Sz[i] = moments.Sz, Ssk[i] = moments.Ssk, Sku[i] = moments.Sku;
    for (int iy = 0; iy < windows[i].ny; ++iy) {
      const auto row = windows[i].heights.begin() + static_cast<std::ptrdiff_t>(iy) * windows[i].nx;
      const auto [lowest, highest] = std::minmax_element(row, row + windows[i].nx);
      profile[i] += (*highest - *lowest) / windows[i].ny;
    }
  }
  const auto mean_of = [n](const std::vector<double>& values) {
    WindowMean result;
    for (const double value : values) result.mean += value / n;
    for (const double value : values) result.sd += (value - result.mean) * (value - result.mean);
    result.sd = n > 1 ? std::sqrt(result.sd / (n - 1)) : 0.0;
    return result;
  };
  return {mean_of(Sq), mean_of(Sz), mean_of(Ssk), mean_of(Sku), mean_of(profile)};
}

ExpectedSq expected_measured_Sq(const SelfAffineSpectrum& spectrum, const AfmSettings& afm) {
  const AfmGrid grid = afm_grid(spectrum, afm);
  const int n = grid.pixels, columns = n / 2 + 1;
  const double spacing = afm.size / afm.pixels;
  const auto lost = projections(n, grid.period, spacing, afm.pixels);

  HalfSpectrum power(static_cast<std::size_t>(columns) *
                     n);  // mean square of each wave that the levelling leaves
  std::vector<double> all(n, 0.0), left(n, 0.0);
#pragma omp parallel for schedule(static)
  for (int iy = 0; iy < n; ++iy) {
    const int ky = signed_wave_number(iy, n);
    if (2 * std::abs(ky) >= n) continue;
    for (int kx = 0; 2 * kx < n; ++kx) {
      if (kx == 0 && ky == 0) continue;
      const double C = spectrum(2 * M_PI / grid.period * std::hypot(kx, ky));
      if (C == 0) continue;
      const Projection &x = lost[kx], &y = lost[iy];
      const double kept = C * (1 - x.constant * y.constant - x.linear * y.constant - x.constant * y.linear);
      const int weight = kx == 0 ? 1 : 2;
      all[iy] += weight * C, left[iy] += weight * kept;
      power[static_cast<std::size_t>(iy) * columns + kx] = kept;
    }
  }
  double sum_all = 0, sum_left = 0;
  for (int iy = 0; iy < n; ++iy) sum_all += all[iy], sum_left += left[iy];
  if (!(sum_all > 0))
    throw InputError("no wave of the spectrum fits between the period and two pixels of the virtual scan");
  const double scale = spectrum.rms * spectrum.rms / sum_all;

  const std::vector<double> covariance = inverse_fft(std::move(power), n, n);
  std::vector<double> squares(afm.pixels, 0.0);
#pragma omp parallel for schedule(static)
  for (int jy = 0; jy < afm.pixels; ++jy)
    for (int jx = 0; jx < afm.pixels; ++jx) {
      const double R = covariance[static_cast<std::size_t>(jy) * grid.stride * n +
                                  static_cast<std::size_t>(jx) * grid.stride];
      const double mirrored = jx == 0 ? 0.0
                                      : covariance[static_cast<std::size_t>(jy) * grid.stride * n + n -
                                                   static_cast<std::size_t>(jx) * grid.stride];
      const double pairs =
          (1 - jx / static_cast<double>(afm.pixels)) * (1 - jy / static_cast<double>(afm.pixels));
      squares[jy] += pairs * (R * R + mirrored * mirrored) * (jy == 0 ? 1 : 2);
    }
  double variance = 0;
  for (const double square : squares)
    variance += 2 * scale * scale * square / (static_cast<double>(afm.pixels) * afm.pixels);

  ExpectedSq expected;
  expected.mean_square = scale * sum_left;
  const double shape =
      expected.mean_square * expected.mean_square / variance;  // of the gamma distribution of Sq^2
  expected.mean =
      std::sqrt(expected.mean_square / shape) * std::exp(std::lgamma(shape + 0.5) - std::lgamma(shape));
  expected.sd = std::sqrt(std::max(0.0, expected.mean_square - expected.mean * expected.mean));
  return expected;
}

SelfAffineSpectrum calibrated(SelfAffineSpectrum spectrum, double target, const AfmSettings& afm,
                              int realisations) {
  if (!(target > 0)) throw InputError("the measured rms to calibrate to must be larger than zero");
  AfmSettings sharp = afm;
  sharp.tip.radius = 0;
  spectrum.rms = 1;
  spectrum.rms = target / expected_measured_Sq(spectrum, sharp).mean;
  if (!(afm.tip.radius > 0)) return spectrum;

  // ratio of the measured Sq with the tip to that without, on the same surfaces, so that their scatter
  // cancels
  constexpr int most_iterations = 20;
  constexpr double tolerance = 1e-3;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    double with_tip = 0, without = 0;
    for (int seed = 1; seed <= realisations; ++seed) {
      const Topography surface = afm_surface(spectrum, afm, seed);
      with_tip += measure(afm_windows(surface, afm)).Sq.mean;
      without += measure(afm_windows(surface, sharp)).Sq.mean;
    }
    const double expected = expected_measured_Sq(spectrum, sharp).mean * with_tip / without;
    if (std::abs(expected / target - 1) < tolerance) return spectrum;
    spectrum.rms *= target / expected;
  }
  throw WorkError("no amplitude gives a measured rms of " + format_quantity(target, Dimension::length) +
                  " under a tip of " + format_quantity(afm.tip.radius, Dimension::length) +
                  "; take a sharper tip or a longer cutoff");
}

double correlation_length(const SelfAffineSpectrum& spectrum) {
  // rho(r) = (2 pi Sq^2)^-1 int q C(q) J0(q r) dq, midpoint rule in q with many points per oscillation
  const double q_r = 2 * M_PI / spectrum.rolloff, q_s = 2 * M_PI / spectrum.cutoff;
  SelfAffineSpectrum unit = spectrum;
  unit.rms = 1;
  const double C0 = unit.plateau();
  const auto rho = [&](double r) {
    double sum = 0;
    const auto add = [&](double lower, double upper, int steps) {
      const double width = std::log(upper / lower) / steps;
      for (int i = 0; i < steps; ++i) {
        const double q = lower * std::exp((i + 0.5) * width);
        const double C = q < q_r ? C0 : C0 * std::pow(q / q_r, -2 - 2 * unit.hurst);
        sum += q * q * C * ::j0(q * r) * width / (2 * M_PI);
      }
    };
    constexpr int steps = 2000;
    add(1e-4 * q_r, q_r, steps);
    if (q_s > q_r) add(q_r, q_s, steps);
    return sum;
  };
  double lower = 0, upper = spectrum.cutoff / 16;
  while (rho(upper) > std::exp(-1.0)) lower = upper, upper *= 1.5;
  return root_between([&](double r) { return rho(r) - std::exp(-1.0); }, lower, upper, 40);
}

}  // namespace asperity
