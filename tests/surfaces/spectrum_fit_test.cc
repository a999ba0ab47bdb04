// The fit of the self-affine model to spectra that are written down ring by ring, so that value and error are
// known.
#include "surfaces/spectrum_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <random>

#include "core/error.h"
#include "surfaces/generate.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

constexpr double fundamental = 2e6;  // [rad/m]: a scan of 3.14 um

double wavelength(double q) { return 2 * M_PI / q; }

/// Ring i at i + 1 times the fundamental wave number, of 3 (i + 1) periodograms. The fit leaves out the
/// first.
RadialSpectrum rings_of(int count, const std::function<double(double)>& C) {
  RadialSpectrum spectrum;
  for (int i = 1; i <= count; ++i) {
    spectrum.q.push_back(fundamental * i);
    spectrum.C.push_back(C(fundamental * i));
    spectrum.modes.push_back(3.0 * i);
  }
  spectrum.rms = 1e-9;
  return spectrum;
}

/// C falling with slope -2 - 2H beyond q_r.
std::function<double(double)> self_affine(double hurst, double q_r) {
  return [=](double q) { return q <= q_r ? 1e-30 : 1e-30 * std::pow(q / q_r, -2 - 2 * hurst); };
}

/// What the maximum of the likelihood says of a spectrum without knees, given its slope.
struct Line {
  double residual = 0;     ///< sum n (C/M - 1) x over sum n, which is zero at the maximum
  double misfit = 0;       ///< deviance per ring
  double slope_error = 0;  ///< from the Fisher matrix
};

Line line_of(const RadialSpectrum& spectrum, double slope, double first_x, std::size_t from) {
  double n = 0, above = 0, nx = 0, nxx = 0;
  const auto x = [&](std::size_t i) { return std::max(0.0, std::log(spectrum.q[i]) - first_x); };
  for (std::size_t i = from; i < spectrum.q.size(); ++i) {
    n += spectrum.modes[i], nx += spectrum.modes[i] * x(i), nxx += spectrum.modes[i] * x(i) * x(i);
    above += spectrum.modes[i] * spectrum.C[i] * std::exp(-slope * x(i));
  }
  Line line;
  for (std::size_t i = from; i < spectrum.q.size(); ++i) {
    const double ratio = spectrum.C[i] * std::exp(-slope * x(i)) / (above / n);
    line.residual += spectrum.modes[i] * (ratio - 1) * x(i) / n;
    line.misfit += 2 * spectrum.modes[i] * (ratio - 1 - std::log(ratio));
  }
  line.misfit /= static_cast<double>(spectrum.q.size() - from);
  line.slope_error = std::sqrt(n / (n * nxx - nx * nx));
  return line;
}

}  // namespace

TEST(SpectrumFit_analytic, of_a_pure_power_has_its_exponent_and_the_error_of_the_fisher_matrix) {
  for (const double hurst : {0.3, 0.8, 1.4, -0.2}) {
    const RadialSpectrum spectrum = rings_of(60, self_affine(hurst, fundamental));
    const SpectrumFit fit = fit_spectrum(spectrum);
    EXPECT_FALSE(fit.has_rolloff || fit.has_cutoff || fit.has_noise) << fit.sentence();
    EXPECT_NEAR(fit.hurst.value, hurst, 1e-9);
    EXPECT_EQ(fit.misfit, 1);
    const Line line = line_of(spectrum, -2 - 2 * hurst, std::log(2 * fundamental), 1);
    EXPECT_NEAR(fit.hurst.error / (line.slope_error / 2), 1, 1e-9);  // the slope is -2 - 2H
    EXPECT_NEAR(fit.longest / wavelength(2 * fundamental), 1, 1e-12);
    EXPECT_NEAR(fit.shortest / wavelength(60 * fundamental), 1, 1e-12);
    EXPECT_EQ(fit.rms, spectrum.rms);
  }
}

/// Rings that scatter more than their periodograms do: the fit is still the maximum of the likelihood, and
/// its errors are widened by the root of the misfit.
TEST(SpectrumFit_analytic, errors_grow_with_the_root_of_the_misfit) {
  for (const double scatter : {0.3, -0.3}) {
    RadialSpectrum spectrum = rings_of(60, self_affine(0.7, fundamental));
    for (double& n : spectrum.modes) n = 100;
    for (std::size_t i = 0; i < spectrum.C.size(); ++i) spectrum.C[i] *= std::exp(i % 2 ? scatter : -scatter);
    const SpectrumFit fit = fit_spectrum(spectrum);
    ASSERT_FALSE(fit.has_rolloff || fit.has_cutoff || fit.has_noise) << fit.sentence();
    const Line line = line_of(spectrum, -2 - 2 * fit.hurst.value, std::log(2 * fundamental), 1);
    EXPECT_NEAR(line.residual, 0, 1e-8);
    EXPECT_GT(line.misfit, 5);
    EXPECT_NEAR(fit.misfit / line.misfit, 1, 1e-8);
    EXPECT_NEAR(fit.hurst.error / (std::sqrt(line.misfit) * line.slope_error / 2), 1, 1e-8);
  }
}

/// The Fisher information by its definition, J^T n J with J the derivatives of ln C by ln C0, H and the
/// wavelength of the roll-off.
TEST(SpectrumFit_analytic, errors_of_hurst_and_rolloff_are_those_of_the_cramer_rao_bound) {
  constexpr int count = 60;
  const double hurst = 0.7, q_r = 8.5 * fundamental;  // between two rings
  const SpectrumFit fit = fit_spectrum(rings_of(count, self_affine(hurst, q_r)));
  ASSERT_TRUE(fit.has_rolloff && !fit.has_cutoff && !fit.has_noise) << fit.sentence();
  EXPECT_NEAR(fit.hurst.value, hurst, 2e-3);  // the knee is searched on a grid
  EXPECT_NEAR(fit.rolloff.value / wavelength(q_r), 1, 2e-3);
  const auto log_C = [&](int i, double h, double rolloff) {
    return std::log(self_affine(h, wavelength(rolloff))(fundamental * i));
  };
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (int i = 2; i <= count; ++i) {
    const double h = 1e-6, l = 1e-6 * wavelength(q_r);
    const Eigen::Vector3d by(
        1, (log_C(i, hurst + h, wavelength(q_r)) - log_C(i, hurst - h, wavelength(q_r))) / (2 * h),
        (log_C(i, hurst, wavelength(q_r) + l) - log_C(i, hurst, wavelength(q_r) - l)) / 2e-6);
    information += 3 * i * by * by.transpose();
  }
  const Eigen::Matrix3d bound = information.inverse();
  EXPECT_NEAR(fit.hurst.error / std::sqrt(bound(1, 1)), 1, 5e-3);
  EXPECT_NEAR(fit.rolloff.error / (wavelength(q_r) * std::sqrt(bound(2, 2))), 1, 5e-3);
}

TEST(SpectrumFit_analytic, a_fit_is_the_maximum_of_the_likelihood_also_where_few_rings_fall) {
  std::mt19937 random(7);
  int compared = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const int count = 40;
    RadialSpectrum spectrum = rings_of(count, self_affine(trial % 2 ? 1.5 : 3, 24 * fundamental));
    for (std::size_t i = 0; i < spectrum.C.size(); ++i)
      spectrum.C[i] *= std::gamma_distribution<double>(spectrum.modes[i] / 8, 8 / spectrum.modes[i])(random);
    const SpectrumFit fit = fit_spectrum(spectrum);
    if (!fit.has_rolloff || fit.has_cutoff || fit.has_noise) continue;
    const double knee = std::log(wavelength(fit.rolloff.value));
    EXPECT_NEAR(line_of(spectrum, -2 - 2 * fit.hurst.value, knee, 1).residual, 0, 1e-7) << trial;
    ++compared;
  }
  EXPECT_GE(compared, 6);
}

/// A sharp end lies anywhere between two rings: the deviation of a uniform distribution is its width over the
/// root of twelve.
TEST(SpectrumFit_analytic, a_sharp_end_is_known_to_the_distance_of_two_rings_over_the_root_of_twelve) {
  for (const double factor : {1e-6, 1e4}) {
    const auto line = self_affine(0.7, fundamental);
    const SpectrumFit fit =
        fit_spectrum(rings_of(60, [&](double q) { return line(q) * (q > 35.5 * fundamental ? factor : 1); }));
    EXPECT_EQ(fit.has_cutoff, factor < 1) << fit.sentence();
    EXPECT_EQ(fit.has_noise, factor > 1) << fit.sentence();
    const SpectrumFit::Number& end = factor < 1 ? fit.cutoff : fit.noise;
    const SpectrumFit::Number& none = factor < 1 ? fit.noise : fit.cutoff;
    EXPECT_NEAR(end.value / wavelength(std::sqrt(35.0 * 36) * fundamental), 1, 1e-12);
    EXPECT_NEAR(end.error / (end.value * std::log(36.0 / 35) / std::sqrt(12.0)), 1, 1e-9);
    EXPECT_EQ(none.value, 0);
    EXPECT_NEAR(fit.hurst.value, 0.7, 1e-6);
  }
}

/// White noise leaves the line by and by: where is less certain than at a sharp end.
TEST(SpectrumFit_analytic, a_gradual_end_is_known_less_well_than_a_sharp_one) {
  const auto line = self_affine(0.7, fundamental);
  const double crossing = 35.5 * fundamental;
  RadialSpectrum spectrum = rings_of(100, [&](double q) { return line(q) + line(crossing); });
  for (double& n : spectrum.modes) n = 4;
  const SpectrumFit fit = fit_spectrum(spectrum);
  ASSERT_TRUE(fit.has_noise) << fit.sentence();
  EXPECT_GT(fit.noise.error, 2 * fit.noise.value / 35 / std::sqrt(12.0));
  EXPECT_LT(fit.noise.error, fit.noise.value);
  EXPECT_NEAR(std::log(fit.noise.value / wavelength(crossing)), 0, 0.7);
}

/// Errors are those that repeated scans show: rings scatter as the means of n periodograms do, gamma
/// distributed.
TEST(SpectrumFit_analytic, values_of_repeated_scans_scatter_as_their_errors_say) {
  std::mt19937 random(1953);
  constexpr int scans = 100;
  int compared = 0;
  double hurst = 0, rolloff = 0, bias = 0;
  for (int scan = 0; scan < scans; ++scan) {
    RadialSpectrum spectrum = rings_of(40, self_affine(0.7, 6.5 * fundamental));
    for (std::size_t i = 0; i < spectrum.C.size(); ++i)
      spectrum.C[i] *= std::gamma_distribution<double>(spectrum.modes[i], 1 / spectrum.modes[i])(random);
    const SpectrumFit fit = fit_spectrum(spectrum);
    ASSERT_TRUE(fit.has_rolloff) << fit.sentence();
    if (fit.has_cutoff || fit.has_noise) continue;  // an end that chance feigns
    const double by_hurst = (fit.hurst.value - 0.7) / fit.hurst.error;
    const double by_rolloff =
        std::log(fit.rolloff.value / wavelength(6.5 * fundamental)) / (fit.rolloff.error / fit.rolloff.value);
    hurst += by_hurst * by_hurst, rolloff += by_rolloff * by_rolloff, bias += by_hurst;
    ++compared;
  }
  EXPECT_GE(compared, 0.95 * scans);
  const double tolerance = 3 * std::sqrt(2.0 / compared);  // of chi squared per degree of freedom
  EXPECT_NEAR(hurst / compared, 1, tolerance);
  EXPECT_NEAR(rolloff / compared, 1, tolerance);
  EXPECT_NEAR(bias / compared, 0, 3 / std::sqrt(compared));
}

TEST(SpectrumFit_behaviour, says_how_many_pixels_a_map_needs_and_takes_that_many) {
  const auto spectrum_of = [](int pixels) {
    GenerateOptions options;
    options.nx = options.ny = pixels;
    options.lx = options.ly = 1e-6;
    return radial_spectrum(generate_periodic(SelfAffineSpectrum{1e-9, 0.8, 300e-9, 1e-9}, options));
  };
  EXPECT_EQ(test::message_of<InputError>([&] { fit_spectrum(spectrum_of(33)); }),
            "the map is too small or too flat for a fit of its spectrum; it needs at least 34 x 34 pixels");
  EXPECT_NO_THROW(fit_spectrum(spectrum_of(34)));
  EXPECT_THROW(fit_spectrum(RadialSpectrum{}), InputError);
  EXPECT_THROW(fit_spectrum(rings_of(40, [](double) { return 0.0; })), InputError);
}

TEST(SpectrumFit_behaviour, a_sentence_says_what_was_seen_and_what_was_not) {
  SpectrumFit fit;
  fit.hurst = {0.812, 0.0234};
  fit.misfit = 1.23;
  fit.longest = 2e-6, fit.shortest = 10e-9;
  EXPECT_EQ(fit.sentence(),
            "Hurst exponent 0.812 ± 0.02, no roll-off up to 2 um, no cut-off down to 10 nm; misfit 1.2 "
            "(1: an isotropic self-affine surface)");
  fit.has_rolloff = fit.has_noise = true;
  fit.rolloff = {250e-9, 12e-9}, fit.noise = {30e-9, 2e-9};
  EXPECT_NE(fit.sentence().find(", roll-off at 250 nm ± 12 nm, noise below 30 nm ± 2 nm; misfit"),
            std::string::npos);
  fit.has_noise = false, fit.has_cutoff = true;
  fit.cutoff = {25e-9, 1e-9};
  EXPECT_NE(fit.sentence().find(", cut-off at 25 nm ± 1 nm; misfit"), std::string::npos);
  fit.hurst.value = 1.2;
  EXPECT_NE(fit.sentence().find("1.2 ± 0.02 (above 1: smoother than any self-affine surface), roll-off"),
            std::string::npos);
  fit.hurst.value = -0.1;
  EXPECT_NE(fit.sentence().find("(below 0: no self-affine surface)"), std::string::npos);
}

}  // namespace asperity
