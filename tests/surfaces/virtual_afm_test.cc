#include "surfaces/virtual_afm.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "core/error.h"
#include "surfaces/generate.h"
#include "surfaces/possible_spectra.h"
#include "surfaces/spectrum.h"
#include "surfaces/statistics.h"

namespace asperity {
namespace {

/// A roughness of the paper, as measured, and a spectrum for which it is looked up.
struct Target {
  const char* surface;
  double rms;  ///< as measured [m]
  SelfAffineSpectrum spectrum;
};
// the spectra differ so that short and long correlation, rough and smooth asperities all come up
const std::vector<Target> targets{{"Si as received", 0.3e-9, {0, 0.8, 500e-9, 20e-9}},
                                  {"Si etched, 1600 W", 1.5e-9, {0, 0.8, 800e-9, 20e-9}},
                                  {"Si etched, 1800 W", 2.7e-9, {0, 1.0, 1500e-9, 20e-9}},
                                  {"rail, smoothest", 2.5e-9, {0, 0.8, 200e-9, 20e-9}},
                                  {"rail, middle", 3.6e-9, {0, 0.6, 200e-9, 25e-9}},
                                  {"rail, roughest", 4.8e-9, {0, 0.9, 300e-9, 30e-9}}};

constexpr double psd_tolerance = 0.03;  // per decade

/// Running mean with its standard error.
class Sample {
 public:
  void add(double value) { sum_ += value, squares_ += value * value, ++count_; }
  double mean() const { return sum_ / count_; }
  double error() const { return std::sqrt((squares_ / count_ - mean() * mean()) / (count_ - 1)); }

 private:
  double sum_ = 0, squares_ = 0;
  int count_ = 0;
};

/// What the acceptance asks for, over `realisations` surfaces of a target.
struct Outcome {
  Sample Sq, Ssk, excess;  ///< per realisation: mean of its windows; per surface skewness and Sku - 3
  double skewness_error = 0,
         kurtosis_error = 0;  ///< standard errors of their means that Gaussian heights have
  /// measured over model power spectral density per decade of wave numbers, from long to short waves: of the
  /// windows (the model seen through their Hann window), and of the whole periodic surfaces
  std::vector<double> window_psd, surface_psd;
};

/// What a Hann window of side 2 pi / ring makes of a spectrum, averaged over the directions and the width of
/// a ring: each wave is smeared by (sin(pi u) / (pi u) / (1 - u^2))^2 in both directions, u in rings.
double through_hann(const SelfAffineSpectrum& spectrum, double q, double ring) {
  constexpr int reach = 4, per_ring = 4, directions = 8;
  const auto kernel = [](double u) {
    if (std::abs(u) < 1e-9) return 1.0;
    if (std::abs(std::abs(u) - 1) < 1e-9) return 0.25;
    return std::pow(std::sin(M_PI * u) / (M_PI * u) / (1 - u * u), 2);
  };
  double sum = 0, weights = 0;
  for (int i = -reach * per_ring; i <= reach * per_ring; ++i)
    for (int j = -reach * per_ring; j <= reach * per_ring; ++j) {
      const double u = i / static_cast<double>(per_ring), v = j / static_cast<double>(per_ring),
                   weight = kernel(u) * kernel(v);
      for (int k = 0; k < directions; ++k)
        for (const double across : {-0.4, -0.2, 0.0, 0.2, 0.4}) {
          const double angle = M_PI / 2 * (k + 0.5) / directions, radius = q + across * ring;
          sum += weight * spectrum(std::hypot(radius * std::cos(angle) + u * ring,
                                              radius * std::sin(angle) + v * ring));
          weights += weight;
        }
    }
  return sum / weights;
}

/// Means over decades of wave numbers down from `upper` to `lower`. What is left of a decade above `lower` is
/// dropped if the sampling error of so few waves (1/sqrt of their number in all maps) exceeds half of the
/// tolerance.
std::vector<double> by_decades(const RadialSpectrum& spectrum, const std::vector<double>& ratio, int maps,
                               double lower, double upper) {
  const std::vector<double>&q = spectrum.q, &modes = spectrum.modes;
  std::vector<double> means;
  for (; upper > lower; upper /= 10) {
    double sum = 0, weight = 0;
    for (std::size_t k = 0; k < q.size(); ++k)
      if (q[k] <= upper && q[k] > std::max(lower, upper / 10)) sum += modes[k] * ratio[k], weight += modes[k];
    if (1 / std::sqrt(weight * maps) < psd_tolerance / 2) means.insert(means.begin(), sum / weight);
  }
  return means;
}

Outcome run(const Target& target, int realisations, std::uint64_t first_seed, bool all_windows) {
  const AfmSettings afm;
  const SelfAffineSpectrum spectrum = calibrated(target.spectrum, target.rms, afm);
  Outcome outcome;
  std::vector<double> window_ratio, surface_ratio;
  RadialSpectrum window_spectrum, surface_spectrum;
  const double ring = 2 * M_PI / afm.size;
  double surface_side = 0;
  int windows_in_all = 0;
  const auto add = [](std::vector<double>& ratio, const RadialSpectrum& radial, double weight) {
    ratio.resize(radial.C.size(), 0.0);
    for (std::size_t k = 0; k < ratio.size(); ++k) ratio[k] += radial.C[k] * weight;
  };
  for (int i = 0; i < realisations; ++i) {
    const Topography surface = afm_surface(spectrum, afm, first_seed + i);
    surface_side = surface.lx;
    const auto windows = all_windows ? all_afm_windows(surface, afm) : afm_windows(surface, afm);
    windows_in_all += static_cast<int>(windows.size());
    outcome.Sq.add(measure(windows).Sq.mean);
    const HeightMoments moments = height_moments(surface);
    outcome.Ssk.add(moments.Ssk);
    outcome.excess.add(moments.Sku - 3);
    if (i == 0) {
      const GaussianTest gaussian = gaussian_test(surface);
      outcome.skewness_error = gaussian.skewness_error / std::sqrt(realisations);
      outcome.kurtosis_error = gaussian.kurtosis_error / std::sqrt(realisations);
    }
    surface_spectrum = radial_spectrum(surface);
    add(surface_ratio, surface_spectrum, 1.0 / realisations);
    for (const Topography& window : windows) {
      window_spectrum = radial_spectrum(window);
      add(window_ratio, window_spectrum, 1.0 / (windows.size() * realisations));
    }
  }
  for (std::size_t k = 0; k < window_ratio.size(); ++k)
    window_ratio[k] /= through_hann(spectrum, window_spectrum.q[k], ring);
  for (std::size_t k = 0; k < surface_ratio.size(); ++k) surface_ratio[k] /= spectrum(surface_spectrum.q[k]);
  // levelling takes from the two longest waves of a window
  const double q_s = 2 * M_PI / spectrum.cutoff, surface_ring = 2 * M_PI / surface_side;
  outcome.window_psd = by_decades(window_spectrum, window_ratio, windows_in_all, 2.5 * ring, q_s - 3 * ring);
  outcome.surface_psd =
      by_decades(surface_spectrum, surface_ratio, realisations, 0.5 * surface_ring, q_s - surface_ring);
  return outcome;
}

void check(const Target& target, const Outcome& outcome) {
  std::printf(
      "%-18s %.1f nm: Sq %.4f +- %.4f nm (%+.2f %%), skewness %+.4f +- %.4f, excess kurtosis %+.4f +- %.4f, "
      "PSD of windows",
      target.surface, target.rms * 1e9, outcome.Sq.mean() * 1e9, outcome.Sq.error() * 1e9,
      100 * (outcome.Sq.mean() / target.rms - 1), outcome.Ssk.mean(), outcome.skewness_error,
      outcome.excess.mean(), outcome.kurtosis_error);
  for (const double ratio : outcome.window_psd) std::printf(" %.3f", ratio);
  std::printf(", of surfaces");
  for (const double ratio : outcome.surface_psd) std::printf(" %.3f", ratio);
  std::printf("\n");
  EXPECT_NEAR(outcome.Sq.mean() / target.rms, 1, 0.01) << target.surface;
  EXPECT_GE(outcome.window_psd.size(), 1u);  // 2.5 rings to the cut-off: a decade and a half at most
  EXPECT_GE(outcome.surface_psd.size(), 2u);
  for (const double ratio : outcome.window_psd) EXPECT_NEAR(ratio, 1, psd_tolerance) << target.surface;
  for (const double ratio : outcome.surface_psd) EXPECT_NEAR(ratio, 1, psd_tolerance) << target.surface;
  EXPECT_NEAR(outcome.Ssk.mean(), 0, 3 * outcome.skewness_error) << target.surface;
  EXPECT_NEAR(outcome.excess.mean(), 0, 3 * outcome.kurtosis_error) << target.surface;
}

}  // namespace

// 24 realisations with all the windows that fit on each of them
TEST(VirtualAfm_analytic, measures_what_it_was_calibrated_to) {
  std::uint64_t seed = 1;
  for (const Target& target : targets) {
    if (target.spectrum.rolloff > 500e-9)
      continue;  // too few independent waves in six surfaces for one percent
    check(target, run(target, 6, seed, true));
    seed += 6;
  }
}

TEST(VirtualAfmNightly_analytic, measures_what_it_was_calibrated_to_over_200_realisations) {
  std::uint64_t seed = 1000;
  for (const Target& target : targets) {
    check(target, run(target, 200, seed, false));
    seed += 1000;
  }
}

TEST(VirtualAfm_analytic, levelling_lowers_Sq_by_one_to_twenty_percent) {
  const AfmSettings afm;
  EXPECT_NEAR(expected_measured_Sq({1, 0.8, 200e-9, 20e-9}, afm).mean, 0.9985, 0.0005);
  EXPECT_NEAR(expected_measured_Sq({1, 0.8, 2.5e-6, 20e-9}, afm).mean, 0.82, 0.01);
}

TEST(VirtualAfm_analytic, expected_Sq_and_its_scatter_are_those_of_many_windows) {
  AfmSettings afm;
  afm.pixels = 128;
  const SelfAffineSpectrum spectrum{1e-9, 0.8, 600e-9, 80e-9};
  Sample Sq;
  std::vector<double> values;
  for (int seed = 0; seed < 40; ++seed)
    for (const Topography& window : afm_windows(afm_surface(spectrum, afm, seed), afm)) {
      Sq.add(height_moments(window).Sq);
      values.push_back(height_moments(window).Sq);
    }
  const ExpectedSq expected = expected_measured_Sq(spectrum, afm);
  EXPECT_NEAR(Sq.mean(), expected.mean, 3 * Sq.error());
  EXPECT_NEAR(Sq.error() * std::sqrt(values.size()), expected.sd, 0.15 * expected.sd);
}

TEST(VirtualAfm_behaviour, refines_its_grid_for_a_cutoff_below_the_scans_pixels) {
  AfmSettings afm;
  EXPECT_EQ(afm_grid({1, 0.8, 200e-9, 20e-9}, afm).stride, 1);
  EXPECT_EQ(afm_grid({1, 0.8, 200e-9, 5e-9}, afm).stride, 2);
  afm.pixels = 64;
  const SelfAffineSpectrum fine{1e-9, 0.8, 500e-9, 40e-9};
  const auto windows = afm_windows(afm_surface(fine, afm, 1), afm);
  ASSERT_EQ(windows.size(), 5u);
  EXPECT_EQ(windows[0].nx, 64);
  EXPECT_NEAR(windows[0].lx, 2.5e-6, 1e-12);
  EXPECT_THROW(afm_grid({1, 0.8, 200e-9, 0.1e-9}, AfmSettings{}), InputError);
}

TEST(CorrelationLength_analytic, of_a_ring_of_waves_is_where_J0_falls_to_1_over_e) {
  // C flat up to one wave number: rho = 2 J1(x)/x with x = q r, which falls to 1/e at x = 2.5838
  EXPECT_NEAR(correlation_length({1, 0.8, 100e-9, 100e-9}), 2.5838 * 100e-9 / (2 * M_PI), 1e-3 * 100e-9);
}

TEST(Tip_analytic, leaves_a_plane_and_rounds_a_spike) {
  Topography plane;
  plane.nx = plane.ny = 41;
  plane.lx = plane.ly = 41e-9;
  plane.heights.assign(41 * 41, 2e-9);
  const Tip sphere{Tip::Shape::spherical, 10e-9}, parabola{Tip::Shape::parabolic, 10e-9};
  EXPECT_EQ(dilated(plane, sphere).heights, plane.heights);
  plane.at(20, 20) = 6e-9;  // 4 nm high: its image is the tip upside down
  const Topography round = dilated(plane, sphere), parabolic = dilated(plane, parabola);
  for (int ix = 0; ix < 41; ++ix) {
    const double u = (ix - 20) * 1e-9;
    const double ball = std::abs(u) <= 10e-9 ? 6e-9 - 10e-9 + std::sqrt(100e-18 - u * u) : 0;
    EXPECT_NEAR(round.at(ix, 20), std::max(2e-9, ball), 1e-20);
    EXPECT_NEAR(parabolic.at(ix, 20), std::max(2e-9, 6e-9 - u * u / 20e-9), 1e-20);
  }
}

TEST(Tip_analytic, under_which_the_calibrated_surface_still_measures_the_target) {
  AfmSettings afm;
  afm.size = 0.5e-6;
  afm.pixels = 128;
  afm.tip = {Tip::Shape::spherical, 20e-9};
  const SelfAffineSpectrum shape{0, 0.8, 100e-9, 20e-9};
  const SelfAffineSpectrum spectrum = calibrated(shape, 2e-9, afm);
  AfmSettings sharp = afm;
  sharp.tip.radius = 0;
  EXPECT_GT(spectrum.rms, 1.01 * calibrated(shape, 2e-9, sharp).rms);  // the tip fills the valleys
  Sample Sq;
  for (int seed = 100; seed < 112; ++seed)
    Sq.add(measure(all_afm_windows(afm_surface(spectrum, afm, seed), afm)).Sq.mean);
  EXPECT_NEAR(Sq.mean(), 2e-9, 0.01 * 2e-9);
}

TEST(PossibleSpectra_behaviour, says_which_published_pairs_a_gaussian_surface_can_have) {
  RatioOptions options;
  options.hursts = {0.8};
  options.points = 4;
  options.windows = 16;
  const AfmSettings afm;
  const auto curves = ratio_curves(afm, options);
  for (std::size_t i = 1; i < curves[0].points.size(); ++i)
    EXPECT_LT(curves[0].points[i].ratio,
              curves[0].points[i - 1].ratio);  // fewer independent heights, fewer extremes

  const auto as_received = possible_spectra({0.3e-9, 0.1e-9, 1.0e-9, 0.1e-9}, afm, curves);
  EXPECT_TRUE(as_received.rolloff_of_means.empty());
  EXPECT_GT(as_received.least_possible, as_received.ratio);
  EXPECT_NE(as_received.sentence.find("cannot both hold"), std::string::npos);

  const auto etched = possible_spectra({1.5e-9, 0.2e-9, 10.5e-9, 0.7e-9}, afm, curves);
  ASSERT_FALSE(etched.rolloff_of_means.empty());
  EXPECT_LT(etched.rolloff_of_means.lower, 800e-9);
  EXPECT_GT(etched.rolloff_of_means.upper, 500e-9);
  EXPECT_LE(etched.rolloff_within_errors.lower, etched.rolloff_of_means.lower);
  ASSERT_EQ(etched.examples.size(), 3u);
  for (const PossibleSpectrum& example : etched.examples)
    EXPECT_NEAR(expected_measured_Sq(example.spectrum, afm).mean, 1.5e-9, 1e-6 * 1.5e-9);
}

TEST(Calibration_behaviour, refuses_to_meet_no_roughness) {
  const SelfAffineSpectrum shape{0, 0.8, 100e-9, 20e-9};
  for (const double target : {0.0, -1e-9, double(NAN)})
    EXPECT_THROW(calibrated(shape, target, AfmSettings{}), InputError) << target;
}

TEST(PossibleSpectra_behaviour, curves_reach_from_the_shortest_rolloff_to_the_longest) {
  AfmSettings afm;
  afm.size = 0.5e-6, afm.pixels = 32;
  RatioOptions options;
  options.hursts = {0.8}, options.points = 3, options.windows = 2;
  auto points = ratio_curves(afm, options).front().points;
  EXPECT_DOUBLE_EQ(points[0].rolloff, 2.5 * 20e-9);  // of the cut-off
  EXPECT_DOUBLE_EQ(points[2].rolloff, 2 * 0.5e-6);   // of the scan
  EXPECT_DOUBLE_EQ(points[1].rolloff, std::sqrt(points[0].rolloff * points[2].rolloff));
  options.shortest_rolloff = 80e-9, options.longest_rolloff = 320e-9;
  points = ratio_curves(afm, options).front().points;
  EXPECT_DOUBLE_EQ(points[0].rolloff, 80e-9);
  EXPECT_DOUBLE_EQ(points[2].rolloff, 320e-9);
  options.longest_rolloff = 80e-9;
  EXPECT_THROW(ratio_curves(afm, options), InputError);
}

TEST(PossibleSpectra_behaviour, refuses_published_values_that_say_nothing) {
  const AfmSettings afm;
  const std::vector<RatioCurve> some(1);
  const auto refusal = [&](const PublishedRoughness& published, const std::vector<RatioCurve>& curves) {
    try {
      possible_spectra(published, afm, curves);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  const std::string values =
      "RMS and peak to valley must be larger than zero, and the uncertainty of the RMS smaller than it";
  EXPECT_EQ(refusal({1e-9, 1e-9, 5e-9, 1e-9}, some), values) << "an uncertainty as large as the RMS";
  EXPECT_EQ(refusal({1e-9, -1e-10, 5e-9, 1e-9}, some), values);
  EXPECT_EQ(refusal({1e-9, 1e-10, 5e-9, -1e-9}, some), values);
  EXPECT_EQ(refusal({0, 0, 5e-9, 1e-9}, some), values);
  EXPECT_EQ(refusal({1e-9, 1e-10, 0, 1e-9}, some), values);
  EXPECT_EQ(refusal({1e-9, 1e-10, 5e-9, 1e-9}, {}), "no Hurst exponent to look for spectra with");
}

}  // namespace asperity
