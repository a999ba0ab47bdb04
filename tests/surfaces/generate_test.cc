#include "surfaces/generate.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <tuple>

#include "core/error.h"
#include "surfaces/philox.h"
#include "surfaces/sampler.h"
#include "surfaces/surface_of_entry.h"

namespace asperity {
namespace {

double mean_square(const std::vector<double>& heights) {
  double sum = 0;
  for (const double h : heights) sum += h * h;
  return sum / heights.size();
}

SelfAffineSpectrum spectrum() { return {1.5e-9, 0.8, 200e-9, 20e-9}; }

GenerateOptions options(int pixels, double size, std::uint64_t seed = 3) {
  GenerateOptions options;
  options.nx = options.ny = pixels;
  options.lx = options.ly = size;
  options.seed = seed;
  return options;
}

}  // namespace

TEST(Philox_other_code, gives_the_known_answers_of_its_authors) {  // Random123, kat_vectors
  using Bits = std::array<std::uint32_t, 4>;
  EXPECT_EQ(philox4x32({0, 0, 0, 0}, 0), (Bits{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox4x32({~0u, ~0u, ~0u, ~0u}, ~std::uint64_t{0}),
            (Bits{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
}

TEST(SelfAffineSpectrum_analytic, integrates_to_the_mean_square_height) {
  const SelfAffineSpectrum C = spectrum();
  double sum = 0;  // (2 pi)^-1 int q C dq = (2 pi)^-1 int q^2 C d(ln q), midpoint rule
  const double lower = std::log(1e-3 * 2 * M_PI / C.rolloff), upper = std::log(2 * M_PI / C.cutoff);
  const int steps = 200000;
  for (int i = 0; i < steps; ++i) {
    const double q = std::exp(lower + (i + 0.5) * (upper - lower) / steps);
    sum += q * q * C(q) * (upper - lower) / steps / (2 * M_PI);
  }
  EXPECT_NEAR(std::sqrt(sum), 1.5e-9, 1e-5 * 1.5e-9);
}

TEST(SelfAffineSpectrum_analytic, without_its_rolloff_overshoots_by_sqrt_1_plus_H) {
  SelfAffineSpectrum C = spectrum();
  C.cutoff = 1e-15;  // practically none
  const double q_r = 2 * M_PI / C.rolloff;
  const double naive_plateau = 2 * M_PI * C.rms * C.rms * 2 * C.hurst / (q_r * q_r);
  EXPECT_NEAR(std::sqrt(naive_plateau / C.plateau()), std::sqrt(1 + C.hurst), 1e-6);
}

TEST(Generate_analytic, fixed_amplitudes_meet_Sq_exactly) {
  GenerateOptions fixed = options(320, 1.6e-6);
  fixed.amplitudes = Amplitudes::fixed;
  fixed.rms = 1.5e-9;
  EXPECT_NEAR(std::sqrt(mean_square(generate_periodic(spectrum(), fixed).heights)), 1.5e-9, 1e-12 * 1.5e-9);
}

TEST(Generate_analytic, discrete_sum_approaches_the_integral_for_many_rolloffs) {
  EXPECT_NEAR(std::sqrt(discrete_variance(spectrum(), 1024, 1024, 5e-6, 5e-6)), 1.5e-9, 0.005 * 1.5e-9);
}

TEST(Generate_analytic, random_amplitudes_have_the_expected_mean_square) {
  const int realisations = 100;
  double sum = 0, sum_of_squares = 0;
  for (int seed = 0; seed < realisations; ++seed) {
    GenerateOptions random = options(160, 1.6e-6, seed);
    random.rms = 1;
    const double value =
        mean_square(generate_periodic({SelfAffineSpectrum{1, 0.8, 200e-9, 40e-9}}, random).heights);
    sum += value, sum_of_squares += value * value;
  }
  const double mean = sum / realisations;
  const double standard_error = std::sqrt((sum_of_squares / realisations - mean * mean) / realisations);
  EXPECT_NEAR(mean, 1.0, 3 * standard_error);
  EXPECT_LT(standard_error, 0.03);
}

TEST(Generate_behaviour, is_the_same_bit_for_bit_on_any_number_of_threads) {
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto one = generate_periodic(spectrum(), options(900, 4.5e-6)).heights;
  omp_set_num_threads(3);
  const auto three = generate_periodic(spectrum(), options(900, 4.5e-6)).heights;
  omp_set_num_threads(threads);
  EXPECT_EQ(one, three);
}

TEST(Generate_behaviour, is_the_same_surface_on_a_finer_grid) {
  const HeightSampler coarse(generate_periodic(spectrum(), options(480, 1.6e-6)));
  const HeightSampler fine(generate_periodic(spectrum(), options(960, 1.6e-6)));
  for (int i = 0; i < 100; ++i) {
    const double x = 0.9e-6 * std::sin(1.7 * i), y = 0.9e-6 * std::cos(2.3 * i);
    EXPECT_NEAR(coarse.height(x, y), fine.height(x, y), 0.002 * 1.5e-9);
  }
}

TEST(SelfAffineSpectrum_behaviour, refuses_an_rms_that_is_no_length) {
  for (const double rms : {-1e-9, double(INFINITY), double(NAN)})
    EXPECT_THROW((SelfAffineSpectrum{rms, 0.8, 200e-9, 50e-9}).check(), InputError) << rms;
  EXPECT_NO_THROW((SelfAffineSpectrum{0, 0.8, 200e-9, 50e-9}).check());
}

TEST(Generate_behaviour, refuses_a_line_a_point_and_no_size) {
  GenerateOptions options;
  for (const auto& [nx, ny, lx, ly] :
       {std::tuple{1, 8, 1e-6, 1e-6}, {8, 1, 1e-6, 1e-6}, {8, 8, 0.0, 1e-6}, {8, 8, 1e-6, -1e-6}}) {
    options.nx = nx, options.ny = ny, options.lx = lx, options.ly = ly;
    EXPECT_THROW(generate_periodic(SelfAffineSpectrum{1e-9, 0.8, 200e-9, 50e-9}, options), InputError)
        << nx << " " << ny << " " << lx << " " << ly;
  }
}

TEST(Generate_behaviour, differs_from_seed_to_seed) {
  EXPECT_NE(generate_periodic(spectrum(), options(64, 1.6e-6, 1)).heights,
            generate_periodic(spectrum(), options(64, 1.6e-6, 2)).heights);
}

TEST(Generate_behaviour, a_window_does_not_meet_itself_at_its_edges) {
  const Topography window = generate_window(spectrum(), 200e-9, options(256, 1.28e-6));
  EXPECT_FALSE(window.periodic);
  EXPECT_NEAR(window.dx(), 5e-9, 1e-20);
  double jump = 0, step = 0;
  for (int iy = 0; iy < 256; ++iy) {
    jump += std::pow(window.at(255, iy) - window.at(0, iy), 2);
    step += std::pow(window.at(128, iy) - window.at(127, iy), 2);
  }
  EXPECT_GT(jump, 20 * step);
}

TEST(HeightSampler_analytic, keeps_a_sine_of_four_pixels_within_a_fifth_of_a_percent) {
  Topography sine;
  sine.nx = 64, sine.ny = 8;
  sine.lx = 64, sine.ly = 8;
  sine.periodic = true;
  sine.heights.resize(64 * 8);
  for (int iy = 0; iy < 8; ++iy)
    for (int ix = 0; ix < 64; ++ix) sine.at(ix, iy) = std::sin(2 * M_PI * (ix + 0.5) / 4 + 0.3);
  const HeightSampler sampler(sine);
  for (int iy = 0; iy < 8; ++iy)
    for (int ix = 0; ix < 64; ++ix)
      EXPECT_NEAR(sampler.height(ix + 0.5 - 32, iy + 0.5 - 4), sine.at(ix, iy),
                  1e-13);  // passes through each pixel
  double sum = 0;
  const int points = 4096;
  for (int i = 0; i < points; ++i) sum += std::pow(sampler.height(64.0 * (i + 0.5) / points - 32, 0.37), 2);
  EXPECT_NEAR(std::sqrt(2 * sum / points), 1.0, 0.002);
}

TEST(HeightSampler_analytic, sampled_Sq_is_that_of_the_map_at_a_cutoff_of_four_pixels) {
  const Topography map =
      topography_for("generated(rms=1.5 nm, hurst=0.8, rolloff=200 nm, cutoff=20 nm, size=1.6 um, seed=5)");
  const HeightSampler sampler(map);
  double sum = 0;
  const int points = 700;  // not a multiple of the pixels
  for (int iy = 0; iy < points; ++iy)
    for (int ix = 0; ix < points; ++ix)
      sum += std::pow(
          sampler.height(((ix + 0.31) / points - 0.5) * map.lx, ((iy + 0.77) / points - 0.5) * map.ly), 2);
  EXPECT_NEAR(std::sqrt(sum) / points, std::sqrt(mean_square(map.heights)), 1e-3 * 1.5e-9);
}

TEST(HeightSampler_behaviour, continues_a_periodic_map_and_refuses_or_mirrors_another) {
  Topography map = generate_periodic(spectrum(), options(64, 0.5e-6));
  const HeightSampler periodic(map);
  EXPECT_NEAR(periodic.height(0.2e-6, -0.1e-6), periodic.height(0.7e-6, 0.4e-6), 1e-20);
  map.periodic = false;
  const HeightSampler bounded(map), mirrored(map, Outside::mirror);
  EXPECT_NO_THROW(bounded.height(0.25e-6, -0.25e-6));
  for (const auto& [x, y] : {std::pair{0.26e-6, 0.0}, {-0.26e-6, 0.0}, {0.0, 0.26e-6}, {0.0, -0.26e-6}})
    EXPECT_THROW(bounded.height(x, y), InputError) << x << " " << y;
  EXPECT_NEAR(mirrored.height(0.24e-6, 0.1e-6), mirrored.height(0.26e-6, 0.1e-6), 1e-20);
}

TEST(HeightSampler_analytic, fills_missing_points_of_a_plane_with_the_plane) {
  Topography plane;
  plane.nx = plane.ny = 32;
  plane.lx = plane.ly = 32;
  plane.heights.resize(32 * 32);
  plane.missing.assign(32 * 32, 0);
  for (int iy = 0; iy < 32; ++iy)
    for (int ix = 0; ix < 32; ++ix) {
      plane.at(ix, iy) = 3.0 * ix - 2.0 * iy;
      if (std::hypot(ix - 12, iy - 20) < 4) {
        plane.missing[iy * 32 + ix] = 1;
        plane.at(ix, iy) = NAN;
      }
    }
  EXPECT_NEAR(HeightSampler(plane).height(12.5 - 16, 20.5 - 16), 3.0 * 12 - 2.0 * 20, 0.05);
}

}  // namespace asperity
