// Means of a dear and a cheap method together.
#include "core/double_sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/error.h"

namespace asperity {
namespace {

TEST(DoubleSampling_analytic, a_mean_is_that_of_all_times_the_ratio_of_the_solved) {
  const std::vector<double> all{1, 2, 3, 4, 5, 6}, some{1, 2, 3};
  // Both methods in a fixed ratio: what is left is the error of the mean over all.
  const SampledMean fixed = mean_by_double_sampling(all, some, {1.1, 2.2, 3.3});
  EXPECT_NEAR(fixed.value, 1.1 * 3.5, 1e-12);
  EXPECT_NEAR(fixed.sd, 1.1 * std::sqrt(3.5 / 6), 1e-12);
  EXPECT_THROW(mean_by_double_sampling(all, {1}, {1}), InputError);
  EXPECT_THROW(mean_by_double_sampling(all, {1, 2}, {1}), InputError);
  EXPECT_THROW(mean_by_double_sampling(all, {0, 0}, {1, 2}), InputError);
}

TEST(DoubleSampling_analytic, its_standard_deviation_is_the_scatter_of_the_estimate) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  constexpr int trials = 4000, surfaces = 40, solved = 8;
  double sum = 0, squares = 0, stated = 0;
  for (int n = 0; n < trials; ++n) {
    std::vector<double> all, half_spaces, elements;
    for (int k = 0; k < surfaces; ++k) {
      all.push_back(3 + normal(random));
      if (k >= solved) continue;
      half_spaces.push_back(all.back());
      elements.push_back(1.05 * all.back() + 0.1 * normal(random));
    }
    const SampledMean mean = mean_by_double_sampling(all, half_spaces, elements);
    sum += mean.value / trials, squares += mean.value * mean.value / trials, stated += mean.sd / trials;
  }
  EXPECT_NEAR(sum, 3.15, 0.01);
  EXPECT_NEAR(stated / std::sqrt(squares - sum * sum), 1, 0.1);
}

}  // namespace
}  // namespace asperity
