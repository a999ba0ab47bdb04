// Noise that neighbours share: its filter, its measurement, and paths without the noise of their sensor.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "diagnosis/fit/noise.h"
#include "diagnosis/recording/monotonic_path.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

/// White noise and an autoregression together, of unit variance.
std::vector<double> shared_noise(std::size_t count, const SharedNoise& shared, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> values;
  double slow = std::sqrt(shared.share) * normal(random);
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(slow + std::sqrt(1 - shared.share) * normal(random));
    slow =
        shared.memory * slow + std::sqrt(shared.share * (1 - shared.memory * shared.memory)) * normal(random);
  }
  return values;
}

constexpr std::size_t count = 20000;

TEST(SharedNoise_analytic, whitening_leaves_nothing_that_neighbours_share) {
  const Samples samples = test::approach_and_back(0, 1e-8, count / 2);
  const SharedNoise shared{0.4, 0.7};
  const auto white = NoiseFilter(samples, std::vector<double>(count, 1.0), {shared})
                         .whitened(shared_noise(count, shared, 1));
  double square = 0;
  for (const double value : white) square += value * value;
  EXPECT_NEAR(square / count, 1, 0.03);
  for (const std::size_t lag : {1u, 2u, 5u, 10u}) {
    double product = 0;
    for (std::size_t i = lag; i < white.size(); ++i) product += white[i] * white[i - lag];
    EXPECT_NEAR(product / square, 0, 0.025) << lag;  // 3.5 standard deviations
  }
}

TEST(SharedNoise_analytic, columns_are_whitened_as_residuals_are) {
  const Samples samples = test::approach_and_back(0, 1e-8, 50);
  const NoiseFilter filter(samples, std::vector<double>(100, 2.0), {SharedNoise{0.6, 0.5}});
  const auto noise = shared_noise(100, {0.6, 0.5}, 2);
  std::vector<std::size_t> all(100);
  for (std::size_t i = 0; i < 100; ++i) all[i] = i;
  Eigen::MatrixXd columns(100, 2);
  for (Eigen::Index i = 0; i < 100; ++i)
    columns(i, 0) = noise[static_cast<std::size_t>(i)], columns(i, 1) = -2 * columns(i, 0);
  filter.whiten(all, columns);
  const auto white = filter.whitened(noise);
  for (Eigen::Index i = 0; i < 100; ++i) {
    EXPECT_NEAR(columns(i, 0), white[static_cast<std::size_t>(i)], 1e-12);
    EXPECT_NEAR(columns(i, 1), -2 * columns(i, 0), 1e-12);
  }
}

TEST(SharedNoise_analytic, deviation_share_and_memory_are_measured_from_noise) {
  const Samples samples = test::approach_and_back(0, 1e-8, count / 2);
  for (const SharedNoise& shared : {SharedNoise{0.2, 0.7}, SharedNoise{1, 0.5}, SharedNoise{}}) {
    auto noise = shared_noise(count, shared, 3);
    for (double& value : noise) value *= 3;
    const MeasuredNoise found = measured_noise(samples, noise, std::vector<double>(count, 2.0), 0);
    EXPECT_NEAR(found.sd, 1.5, 0.04);
    EXPECT_NEAR(found.shared.neighbours(), shared.neighbours(), 0.03);
    if (shared.share > 0) {
      EXPECT_NEAR(found.shared.memory, shared.memory, 0.11);
    }
  }
}

TEST(SharedNoise_behaviour, residuals_that_hold_structure_do_not_change_the_noise) {
  const Samples samples = test::approach_and_back(0, 1e-8, 500);
  auto residual = shared_noise(1000, {}, 4);
  Noise noise;
  noise.sd.assign(1000, 1.0);
  noise.shared = {{}};
  noise.from = {"high frequencies"};
  EXPECT_TRUE(refine_noise(samples, residual, noise));
  EXPECT_NEAR(noise.sd[0], 1, 0.1);
  for (std::size_t i = 0; i < 1000; ++i) residual[i] += 3 * std::sin(static_cast<double>(i) / 50);
  Noise before = noise;
  EXPECT_FALSE(refine_noise(samples, residual, noise));
  EXPECT_EQ(noise.sd, before.sd);
}

TEST(OneWay_analytic, pools_what_falls_and_leaves_what_rises) {
  EXPECT_EQ(nearest_rising({1, 2, 3}), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(nearest_rising({1, 3, 2, 4}), (std::vector<double>{1, 2.5, 2.5, 4}));
  EXPECT_EQ(nearest_rising({3, 2, 1}), (std::vector<double>{2, 2, 2}));
}

TEST(OneWay_behaviour, takes_the_jitter_of_a_sensor_out_of_a_stroke_and_keeps_a_reversal) {
  std::vector<double> path;
  for (int i = 0; i < 200; ++i) path.push_back(i + (i % 2 ? 0.7 : 0));
  const auto smooth = monotonic_path(path, 1);
  for (std::size_t i = 1; i < smooth.size(); ++i) EXPECT_GE(smooth[i], smooth[i - 1]);
  for (std::size_t i = 0; i < smooth.size(); ++i) EXPECT_NEAR(smooth[i], path[i], 0.7);
  std::vector<double> mirrored = path;
  for (double& x : mirrored) x = -x;
  EXPECT_EQ(monotonic_path(mirrored, -1)[100], -smooth[100]);
  for (int i = 0; i < 20; ++i) path.push_back(199 - i);
  EXPECT_EQ(monotonic_path(path, 1), path);
}

}  // namespace
}  // namespace asperity
