#include "surfaces/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "surfaces/autocorrelation.h"
#include "surfaces/generate.h"
#include "surfaces/levelling.h"

namespace asperity {
namespace {

/// Map of a function of the pixel centre (x, y) in units of one pixel.
template <typename Function>
Topography map_of(int nx, int ny, Function height) {
  Topography map;
  map.nx = nx, map.ny = ny, map.lx = nx, map.ly = ny;
  map.heights.resize(static_cast<std::size_t>(nx) * ny);
  for (int iy = 0; iy < ny; ++iy)
    for (int ix = 0; ix < nx; ++ix) map.at(ix, iy) = height(ix + 0.5, iy + 0.5);
  return map;
}

void hide(Topography& map, int ix, int iy) {
  map.missing.resize(map.heights.size(), 0);
  map.missing[static_cast<std::size_t>(iy) * map.nx + ix] = 1;
  map.at(ix, iy) = NAN;
}

double largest_known(const Topography& map) {
  double largest = 0;
  for (std::size_t i = 0; i < map.heights.size(); ++i)
    if (map.missing.empty() || !map.missing[i]) largest = std::max(largest, std::abs(map.heights[i]));
  return largest;
}

Topography gaussian(double rolloff, std::uint64_t seed, int pixels = 256) {
  GenerateOptions options;
  options.nx = options.ny = pixels;
  options.lx = options.ly = pixels;
  options.seed = seed;
  options.rms = 1;
  return generate_window(SelfAffineSpectrum{1, 0.8, rolloff, 4}, rolloff, options);
}

}  // namespace

TEST(Levelling_analytic, removes_the_polynomial_it_is_named_after) {
  const auto constant = map_of(40, 30, [](double, double) { return 3.0; });
  const auto plane = map_of(40, 30, [](double x, double y) { return 1e3 + 2 * x - 5 * y; });
  const auto quadratic =
      map_of(40, 30, [](double x, double y) { return 7 + x - y + x * x + 3 * x * y - 2 * y * y; });
  const auto offsets = map_of(40, 30, [](double, double y) { return std::sin(9 * y); });
  const auto tilts = map_of(40, 30, [](double x, double y) { return std::sin(9 * y) + x * std::cos(5 * y); });
  const auto bows =
      map_of(40, 30, [](double x, double y) { return std::sin(9 * y) + x * x * std::cos(5 * y); });
  EXPECT_LT(largest_known(levelled(constant, Level::mean)), 1e-12);
  EXPECT_LT(largest_known(levelled(plane, Level::plane)), 1e-9);
  EXPECT_LT(largest_known(levelled(quadratic, Level::quadratic)), 1e-8);
  EXPECT_LT(largest_known(levelled(offsets, Level::rows0)), 1e-12);
  EXPECT_LT(largest_known(levelled(tilts, Level::rows1)), 1e-11);
  EXPECT_LT(largest_known(levelled(bows, Level::rows2)), 1e-9);
  EXPECT_GT(largest_known(levelled(plane, Level::mean)), 10);
  EXPECT_GT(largest_known(levelled(quadratic, Level::plane)), 10);
  EXPECT_GT(largest_known(levelled(bows, Level::rows1)), 10);
}

TEST(Levelling_analytic, missing_points_take_no_part) {
  auto map = map_of(40, 30, [](double x, double y) { return 2 * x - 5 * y; });
  for (int ix = 3; ix < 20; ++ix) hide(map, ix, 7);
  for (int ix = 0; ix < 39; ++ix) hide(map, ix, 9);  // one point left in this row
  for (int ix = 0; ix < 40; ++ix) hide(map, ix, 11);
  const auto flat = levelled(map, Level::plane);
  EXPECT_LT(largest_known(flat), 1e-10);
  EXPECT_TRUE(std::isnan(flat.at(5, 7)));
  EXPECT_EQ(flat.missing_count(), map.missing_count());
  EXPECT_LT(largest_known(levelled(map, Level::rows2)), 1e-8);
}

TEST(Levelling_behaviour, knows_its_names) {
  EXPECT_EQ(parse_level("rows1"), Level::rows1);
  EXPECT_EQ(level_name(Level::quadratic), "quadratic");
  EXPECT_THROW(parse_level("plain"), InputError);
}

TEST(Statistics_analytic, of_a_sine) {
  const double amplitude = 2, wavelength = 64;
  auto map =
      map_of(512, 64, [&](double x, double) { return 5 + amplitude * std::sin(2 * M_PI * x / wavelength); });
  map.periodic = true;
  const auto statistics = height_statistics(map);
  const double q = 2 * M_PI / wavelength;
  EXPECT_NEAR(statistics.Sq, amplitude / std::sqrt(2), 1e-12);
  EXPECT_NEAR(statistics.Sa, 2 / M_PI * amplitude, 1e-3);
  EXPECT_NEAR(statistics.Sz, 2 * amplitude * std::cos(q / 2),
              1e-12);  // the nearest pixels are half a pixel off
  EXPECT_NEAR(statistics.Ssk, 0, 1e-12);
  EXPECT_NEAR(statistics.Sku, 1.5, 1e-12);
  // differences over one pixel see the slope times sinc(q/2), second differences the curvature times
  // sinc(q/2)^2
  const double sinc = std::sin(q / 2) / (q / 2);
  EXPECT_NEAR(statistics.rms_slope, q * sinc * amplitude / std::sqrt(2), 1e-12);
  EXPECT_NEAR(statistics.rms_curvature, 0.5 * q * q * sinc * sinc * amplitude / std::sqrt(2), 1e-12);
}

TEST(Statistics_analytic, leave_missing_points_out) {
  auto map = map_of(100, 80, [](double x, double) { return x < 50 ? 1.0 : -1.0; });
  map.at(3, 3) = 1e6;
  hide(map, 3, 3);
  const auto statistics = height_statistics(map);
  EXPECT_NEAR(statistics.Sq, 1, 1e-6);
  EXPECT_NEAR(statistics.Sz, 2, 1e-15);
}

TEST(Autocorrelation_analytic, length_of_an_exponential_correlation) {
  // rho = exp(-r/a) has the two-dimensional spectrum (1 + a^2 q^2)^(-3/2)
  const double a = 12;
  GenerateOptions options;
  options.nx = options.ny = 1024;
  options.lx = options.ly = 1024;
  options.amplitudes = Amplitudes::fixed;
  options.rms = 1;
  const auto map = generate_periodic([&](double q) { return std::pow(1 + a * a * q * q, -1.5); }, options);
  EXPECT_NEAR(autocorrelation(map).length(), a,
              0.04 * a);  // short waves beyond the Nyquist wave number are lacking
}

TEST(Autocorrelation_analytic, of_white_noise_counts_every_pixel_as_independent) {
  GenerateOptions options;
  options.nx = options.ny = 128;
  options.lx = options.ly = 128;
  const auto noise = generate_periodic([](double) { return 1.0; }, options);
  EXPECT_NEAR(1 / autocorrelation(noise).mean_power(4), 128 * 128, 0.03 * 128 * 128);
}

TEST(Gaussianity_analytic, skewness_and_kurtosis_scatter_by_their_stated_errors) {
  const int realisations = 150;
  double skewness = 0, skewness_error = 0, kurtosis = 0, kurtosis_error = 0;
  int rejected = 0;
  for (int seed = 0; seed < realisations; ++seed) {
    const Topography map = levelled(gaussian(40, 1000 + seed, 256), Level::plane);
    const HeightStatistics statistics = height_statistics(map);
    const GaussianTest test = gaussian_test(map);
    skewness += statistics.Ssk * statistics.Ssk / realisations;
    kurtosis += std::pow(statistics.Sku - 3, 2) / realisations;
    skewness_error += std::pow(test.skewness_error, 2) / realisations;
    kurtosis_error += std::pow(test.kurtosis_error, 2) / realisations;
    rejected += test.verdict == GaussianTest::Verdict::not_gaussian;
  }
  EXPECT_NEAR(std::sqrt(skewness / skewness_error), 1, 0.2);
  EXPECT_NEAR(std::sqrt(kurtosis / kurtosis_error), 1, 0.25);
  EXPECT_LE(rejected,
            8);  // 1 % of 150 expected; the kurtosis has a heavier tail than its limiting distribution
}

/// Of n independent Gaussian heights the skewness has the variance 6/n, the kurtosis 24/n (Fisher 1930), for
/// large n.
TEST(Gaussianity_analytic, errors_of_independent_heights_are_fishers) {
  GenerateOptions options;
  options.nx = options.ny = 256;
  options.lx = options.ly = 256;
  options.rms = 1;
  const GaussianTest test = gaussian_test(generate_periodic([](double) { return 1.0; }, options));
  const double n = 256 * 256;
  EXPECT_NEAR(test.skewness_error / std::sqrt(6 / n), 1, 0.01);
  EXPECT_NEAR(test.kurtosis_error / std::sqrt(24 / n), 1, 0.01);
}

/// Of correlated ones, 6 and 24 times the mean over all pairs of rho^3 and rho^4 (Lomnicki 1961, Metrika 4,
/// 37).
TEST(Gaussianity_analytic, errors_of_correlated_heights_follow_the_correlation_they_were_made_with) {
  constexpr int n = 128;
  constexpr double length = 5;  // rho = exp(-(r/length)^2), whose spectrum is Gaussian, too
  GenerateOptions options;
  options.nx = options.ny = n;
  options.lx = options.ly = n;
  options.rms = 1;
  double skewness = 0, kurtosis = 0;
  constexpr int realisations = 40;
  for (int seed = 0; seed < realisations; ++seed) {
    options.seed = static_cast<std::uint64_t>(seed);
    const GaussianTest test = gaussian_test(
        generate_periodic([](double q) { return std::exp(-q * q * length * length / 4); }, options));
    skewness += std::pow(test.skewness_error, 2) / realisations,
        kurtosis += std::pow(test.kurtosis_error, 2) / realisations;
  }
  // Mean of rho^k over the map: integral of exp(-k r^2/length^2), pi length^2/k, over its area.
  const double area = n * n;
  EXPECT_NEAR(skewness / (6 * M_PI * length * length / 3 / area), 1, 0.05);
  EXPECT_NEAR(kurtosis / (24 * M_PI * length * length / 4 / area), 1, 0.05);
}

TEST(Gaussianity_analytic, is_denied_to_a_surface_of_one_sided_pits) {
  Topography map = gaussian(20, 7);
  for (double& h : map.heights) h = -h * h;
  const GaussianTest test = gaussian_test(map);
  EXPECT_EQ(test.verdict, GaussianTest::Verdict::not_gaussian);
  EXPECT_NE(test.sentence.find("not Gaussian"), std::string::npos);
}

TEST(Gaussianity_behaviour, is_not_judged_from_a_handful_of_asperities) {
  EXPECT_EQ(gaussian_test(levelled(gaussian(250, 3), Level::plane)).verdict,
            GaussianTest::Verdict::too_few_samples);
}

}  // namespace asperity
