#include "surfaces/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "surfaces/generate.h"
#include "surfaces/spectrum_fit.h"

namespace asperity {
namespace {

const SelfAffineSpectrum model{1.5e-9, 0.7, 250e-9, 25e-9};

GenerateOptions options(int pixels, double size, std::uint64_t seed) {
  GenerateOptions options;
  options.nx = options.ny = pixels;
  options.lx = options.ly = size;
  options.seed = seed;
  return options;
}

Topography scan(std::uint64_t seed) {
  return generate_window(model, model.rolloff, options(512, 2.5e-6, seed));
}

}  // namespace

TEST(RadialSpectrum_analytic, of_a_periodic_map_is_the_one_it_was_made_of) {
  auto exact = options(256, 2.5e-6, 1);
  exact.amplitudes = Amplitudes::fixed;
  const RadialSpectrum spectrum = radial_spectrum(generate_periodic(model, exact));
  const double ring = 2 * M_PI / 2.5e-6;
  int compared = 0;
  for (std::size_t i = 0; i < spectrum.q.size(); ++i) {
    const double q = spectrum.q[i];
    if (std::abs(q - 2 * M_PI / model.rolloff) < 2 * ring || std::abs(q - 2 * M_PI / model.cutoff) < 2 * ring)
      continue;
    if (q > 2 * M_PI / model.cutoff) {
      EXPECT_LT(spectrum.C[i], 1e-20 * spectrum.C[0]);
    } else if (q < 2 * M_PI / model.rolloff) {
      EXPECT_NEAR(spectrum.C[i] / model(q), 1, 1e-9);
    } else {  // the mean over a ring of a convex function lies above its value at the mean
      EXPECT_NEAR(spectrum.C[i] / model(q), 1, 0.01);
    }
    ++compared;
  }
  EXPECT_GT(compared, 100);
}

TEST(RadialSpectrum_analytic, of_windows_is_that_of_the_surface_within_sampling_error) {
  const int realisations = 12;
  std::vector<double> mean;
  RadialSpectrum spectrum;
  for (int seed = 0; seed < realisations; ++seed) {
    spectrum = radial_spectrum(scan(seed));
    mean.resize(spectrum.C.size(), 0.0);
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += spectrum.C[i] / realisations;
  }
  double chi_squared = 0;
  int compared = 0;
  const std::size_t band = 6;  // rings: neighbours share what the window smears
  for (std::size_t first = 3; spectrum.q[first + band] < 0.95 * 2 * M_PI / model.cutoff;
       first += band, ++compared) {
    double ratio = 0, modes = 0;
    for (std::size_t i = first; i < first + band; ++i) {
      ratio += spectrum.modes[i] * mean[i] / model(spectrum.q[i]);
      modes += spectrum.modes[i];
    }
    chi_squared += std::pow(ratio / modes - 1, 2) * modes * realisations;
  }
  EXPECT_GE(compared, 14);
  EXPECT_GT(chi_squared / compared, 0.3);  // chi squared of 14 degrees of freedom, 99.5 % limits
  EXPECT_LT(chi_squared / compared, 2.25);
}

/// Independent periodograms that a window leaves of n along one direction: 1/sum_k rho_k^2, rho_k the
/// correlation of the Fourier coefficients of white noise under the window at wave numbers k apart, which is
/// the transform of the window's square (Percival & Walden 1993, ch. 6).
double independent_share(const std::vector<double>& window) {
  const std::size_t n = window.size();
  double square = 0, sum = 0;
  for (const double w : window) square += w * w;
  for (std::size_t k = 0; k < n; ++k) {
    double real = 0, imaginary = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = 2 * M_PI * static_cast<double>(i * k) / static_cast<double>(n);
      real += window[i] * window[i] * std::cos(angle), imaginary += window[i] * window[i] * std::sin(angle);
    }
    sum += (real * real + imaginary * imaginary) / (square * square);
  }
  return 1 / sum;
}

Topography white_noise(std::uint64_t seed, bool periodic) {
  GenerateOptions white = options(64, 1e-6, seed);
  white.rms = 1e-9;
  Topography map = generate_periodic([](double) { return 1.0; }, white);
  map.periodic = periodic;
  return map;
}

TEST(RadialSpectrum_analytic, a_hann_window_leaves_as_many_independent_periodograms_as_its_overlap_says) {
  const RadialSpectrum whole = radial_spectrum(white_noise(1, true)),
                       windowed = radial_spectrum(white_noise(1, false));
  std::vector<double> hann;
  for (int i = 0; i < 64; ++i) hann.push_back(1 - std::cos(2 * M_PI * (i + 0.5) / 64));
  const double share = std::pow(independent_share(hann), 2);  // of both directions
  ASSERT_EQ(whole.modes.size(), windowed.modes.size());
  for (std::size_t i = 5; i < whole.modes.size(); ++i)
    EXPECT_NEAR(windowed.modes[i] / whole.modes[i], share, 1e-6) << i;
}

TEST(RadialSpectrum_analytic, means_over_rings_of_white_noise_scatter_as_their_modes_say) {
  constexpr int realisations = 400;
  constexpr std::size_t first = 6,
                        last = 26;  // many rings: what a window smears over neighbours stays inside
  double mean = 0, square = 0, modes = 0;
  for (int seed = 0; seed < realisations; ++seed) {
    const RadialSpectrum spectrum =
        radial_spectrum(white_noise(1000 + static_cast<std::uint64_t>(seed), false));
    double sum = 0;
    modes = 0;
    for (std::size_t i = first; i < last; ++i)
      sum += spectrum.modes[i] * spectrum.C[i], modes += spectrum.modes[i];
    mean += sum / modes / realisations, square += std::pow(sum / modes, 2) / realisations;
  }
  const double scatter =
      (square / (mean * mean) - 1) * modes;  // 1, for a periodogram's variance is the square of its mean
  EXPECT_NEAR(scatter, 1, 3 * std::sqrt(2.0 / realisations));
}

TEST(RadialSpectrum_analytic, of_oblong_pixels_ends_where_both_directions_still_see_waves) {
  GenerateOptions of = options(64, 1e-6, 1);
  of.nx = 128;  // pixels of 7.8 by 15.6 nm
  const RadialSpectrum spectrum = radial_spectrum(generate_periodic(model, of));
  EXPECT_LE(spectrum.q.back(), 1.05 * M_PI / (1e-6 / 64));
  EXPECT_GE(spectrum.q.back(), 0.95 * M_PI / (1e-6 / 64));
}

TEST(RadialSpectrum_behaviour, generates_the_like_of_what_was_measured) {
  const RadialSpectrum measured = radial_spectrum(scan(5));
  auto like = options(512, 5e-6, 6);
  like.amplitudes = Amplitudes::fixed;
  const RadialSpectrum again = radial_spectrum(generate_periodic(measured.table(), like));
  EXPECT_NEAR(again.rms, measured.rms, 0.1 * measured.rms);
}

TEST(SpectrumFit_analytic, finds_hurst_rolloff_and_cutoff_within_its_errors) {
  const int realisations = 12;
  double hurst = 0, rolloff = 0;
  for (int seed = 0; seed < realisations; ++seed) {
    const SpectrumFit fit = fit_spectrum(radial_spectrum(scan(100 + seed)));
    ASSERT_TRUE(fit.has_rolloff && fit.has_cutoff && !fit.has_noise) << fit.sentence();
    hurst += std::pow((fit.hurst.value - model.hurst) / fit.hurst.error, 2) / realisations;
    rolloff += std::pow((fit.rolloff.value - model.rolloff) / fit.rolloff.error, 2) / realisations;
    EXPECT_NEAR(fit.cutoff.value, model.cutoff, 0.05 * model.cutoff);
    EXPECT_LT(fit.hurst.error, 0.05);
    EXPECT_LT(fit.misfit, 1.6);
  }
  // mean squared deviations in units of the stated errors: chi squared of 12 degrees of freedom, 99.9 %
  // below 2.7
  EXPECT_LT(hurst, 2.7);
  EXPECT_LT(rolloff, 2.7);
  EXPECT_GT(hurst + rolloff, 0.4);
}

TEST(SpectrumFit_analytic, does_not_see_a_rolloff_beyond_the_scan) {
  const SelfAffineSpectrum long_waves{1e-9, 0.8, 10e-6, 2.5e-6 / 256};
  auto few = options(256, 2.5e-6, 3);
  const SpectrumFit fit = fit_spectrum(radial_spectrum(generate_window(long_waves, 2.5e-6, few)));
  EXPECT_FALSE(fit.has_rolloff) << fit.sentence();
  EXPECT_NEAR(fit.hurst.value, 0.8, 4 * fit.hurst.error);
}

TEST(SpectrumFit_analytic, tells_noise_from_a_cutoff) {
  auto white = options(512, 2.5e-6, 77);
  white.rms = 0.5e-9;
  const Topography noise = generate_periodic([](double) { return 1.0; }, white);
  const SelfAffineSpectrum uncut{1.5e-9, 0.7, 250e-9, 2.5e-6 / 256};
  Topography map = generate_window(uncut, uncut.rolloff, options(512, 2.5e-6, 9));
  for (std::size_t i = 0; i < map.heights.size(); ++i) map.heights[i] += noise.heights[i];
  const SpectrumFit fit = fit_spectrum(radial_spectrum(map));
  EXPECT_TRUE(fit.has_noise) << fit.sentence();
  EXPECT_FALSE(fit.has_cutoff);
}

TEST(SpectrumFit_behaviour, refuses_a_map_of_a_few_pixels) {
  EXPECT_THROW(fit_spectrum(radial_spectrum(generate_periodic(model, options(16, 2.5e-6, 1)))), InputError);
}

TEST(SelfAffineSpectrum_analytic, rms_slope_is_the_integral_of_the_spectrum) {
  for (const double hurst : {0.5, 0.8, 1.0}) {
    const SelfAffineSpectrum spectrum{1.5e-9, hurst, 500e-9, 72e-9};
    const double q_s = 2 * M_PI / spectrum.cutoff;
    constexpr int steps = 200000;
    double integral = 0;
    for (int i = 0; i < steps; ++i) {
      const double q = (i + 0.5) / steps * q_s;
      integral += q * q * q * spectrum(q) * q_s / steps / (2 * M_PI);
    }
    EXPECT_NEAR(spectrum.rms_slope() / std::sqrt(integral), 1, 1e-5);
  }
}

}  // namespace asperity
