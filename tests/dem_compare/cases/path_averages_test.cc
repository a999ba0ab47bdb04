#include "dem_compare/cases/path_averages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "dem_compare/resistance/trend.h"

namespace asperity {
namespace {

TEST(Stretches_analytic, student_factor_widens_to_what_tables_have) {
  // t of 95.45 % (two-sided): 13.97 for one degree of freedom, 2.869 for four; 2 for many.
  EXPECT_NEAR(student_factor(1), 13.97 / 2, 5e-3);
  EXPECT_NEAR(student_factor(4), 2.869 / 2, 5e-3);
  EXPECT_NEAR(student_factor(1e6), 1, 1e-4);
}

TEST(Stretches_analytic, rates_add_up_to_the_whole_whatever_the_rows) {
  const std::vector<double> x{0, 1, 1.5, 4, 6}, sum{0, 2, 3, 8, 12};
  for (const double rate : block_rates(x, sum, 0, 4, 3)) EXPECT_NEAR(rate, 2, 1e-12);
  // Backwards the sum still grows.
  const std::vector<double> back{6, 4, 1.5, 1, 0};
  for (const double rate : block_rates(back, {0, 4, 9, 10, 12}, 0, 4, 5)) EXPECT_NEAR(rate, 2, 1e-12);
}

TEST(Stretches_analytic, two_sds_hold_the_truth_19_times_in_20_even_of_few_stretches) {
  std::mt19937 random(4);
  std::normal_distribution<double> normal(1, 0.1);
  constexpr int repetitions = 2000;
  int within = 0;
  for (int i = 0; i < repetitions; ++i) {
    std::vector<double> values(5);
    for (double& value : values) value = normal(random);
    const Uncertain mean = mean_of_blocks(values);
    within += std::abs(mean.value - 1) < 2 * mean.sd;
  }
  // Autocorrelations of five values are themselves uncertain: the share may be a little off 0.954.
  EXPECT_NEAR(within / double(repetitions), 0.954, 0.025);
}

TEST(Stretches_analytic, realisations_err_as_they_scatter_or_as_each_leaves_open) {
  EXPECT_NEAR(mean_of_realisations({{1, 0.1}, {3, 0.1}}).sd, 1, 1e-12);     // sd 2^(1/2) over 2^(1/2)
  EXPECT_NEAR(mean_of_realisations({{1, 0.3}, {1, 0.4}}).sd, 0.25, 1e-12);  // (0.09 + 0.16)^(1/2)/2
  EXPECT_FALSE(mean_of_realisations({{1, NAN}, {2, 0.1}}).has_sd());        // two alone do not tell
  EXPECT_FALSE(std::isfinite(mean_of_realisations({}).value));
}

/// Three paths of four blocks tell the mean of all of them by nine degrees of freedom, not by three.
TEST(Stretches_analytic, two_sds_of_the_mean_over_few_paths_hold_the_truth_19_times_in_20) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal(1, 0.1);
  constexpr int repetitions = 2000;
  int within = 0, within_shared = 0, within_own = 0;
  for (int i = 0; i < repetitions; ++i) {
    std::vector<Uncertain> paths(3);
    double own = 0, shared = 0, sum = 0;
    for (Uncertain& path : paths) {
      std::vector<double> blocks(4);
      for (double& block : blocks) block = normal(random);
      path = mean_of_blocks(blocks);
      own += path.sd * path.sd / 9, sum += path.value / 3;
    }
    for (const Uncertain& path : with_shared_degrees_of_freedom(paths)) shared += path.sd * path.sd / 9;
    const Uncertain mean = mean_of_realisations(paths);
    within += std::abs(mean.value - 1) < 2 * mean.sd;
    within_shared += std::abs(sum - 1) < 2 * std::sqrt(shared);
    within_own += std::abs(sum - 1) < 2 * std::sqrt(own);
  }
  EXPECT_NEAR(within_shared / double(repetitions), 0.954, 0.025);
  EXPECT_GT(within, within_shared - 1);  // or by how far they are apart, if that is more
  EXPECT_GT(within_own, 0.985 * repetitions);
}

/// What the energy balance leaves open is no scatter of few blocks: however many paths share it, it stays.
TEST(Stretches_analytic, a_stated_error_is_not_widened_and_does_not_shrink_when_paths_share) {
  const Uncertain mean{1, 0.01 * student_factor(3), 3};
  const Uncertain open = with_stated_error(mean, 0.1);  // ten times the scatter
  EXPECT_NEAR(open.sd, std::hypot(0.01, 0.1), 1e-4);
  for (const Uncertain& one : with_shared_degrees_of_freedom({open, open, open}))
    EXPECT_NEAR(one.sd, std::hypot(0.01, 0.1), 1e-4);
  // None: the mean as it was. As large as the scatter: 3 * 2^(4/2) degrees of freedom, t of 95.45 % 2.231.
  EXPECT_DOUBLE_EQ(with_stated_error(mean, 0).sd, mean.sd);
  EXPECT_NEAR(with_stated_error(mean, 0.01).sd, 0.01 * std::sqrt(2) * 2.231 / 2, 2e-5);
  EXPECT_DOUBLE_EQ(with_stated_error({1, 0.3}, 0.4).sd, 0.5);
}

TEST(Stretches_analytic, means_share_degrees_of_freedom_after_welch_and_satterthwaite) {
  // Equal ones of 3 degrees each: 9 together. t of 95.45 %: 3.307 for 3, 2.320 for 9.
  const double own = 3.307 / 2, together = 2.320 / 2;
  const std::vector<Uncertain> equal(3, {1, 0.1 * own, 3});
  for (const Uncertain& mean : with_shared_degrees_of_freedom(equal)) {
    EXPECT_NEAR(mean.sd, 0.1 * together, 1e-4);
    EXPECT_NEAR(mean.degrees_of_freedom, 9, 1e-9);
  }
  // One that errs by far the most has nearly its own alone; what is no mean of few stays as it is.
  const auto apart = with_shared_degrees_of_freedom({{1, 0.1 * own, 3}, {1, 1e-4 * own, 3}, {1, 0.2}});
  EXPECT_NEAR(apart[0].sd, 0.1 * own, 1e-4);
  EXPECT_DOUBLE_EQ(apart[2].sd, 0.2);
  EXPECT_FALSE(std::isfinite(apart[2].degrees_of_freedom));
}

TEST(Trend_analytic, line_has_slope_and_error_of_the_closed_form) {
  // Slope (3 - 1)/2 with error (0.3^2 + 0.4^2)^(1/2)/2.
  const Trend two = fit_trend({1, 3}, {{1, 0.3}, {3, 0.4}});
  EXPECT_NEAR(two.slope.value, 1, 1e-12);
  EXPECT_NEAR(two.slope.sd, 0.25, 1e-12);
  EXPECT_EQ(two.sign(), Trend::Sign::rises);
  // y = 0, 1, 0 at -1, 0, 1: no slope; a misfit of (2/3)^(1/2) with one degree of freedom, over 2^(1/2).
  const Trend three = fit_trend({-1, 0, 1}, {{0, 0.1}, {1, 0.1}, {0, 0.1}});
  EXPECT_NEAR(three.slope.value, 0, 1e-12);
  EXPECT_NEAR(three.slope.sd, std::sqrt(1. / 3.), 1e-12);
  EXPECT_EQ(three.sign(), Trend::Sign::none);
}

TEST(Trend_analytic, numbers_that_are_exact_do_not_outweigh_the_others) {
  // Nothing yields on two surfaces, 1 +- 0.3 does on the third: (1 - 0)/2 +- 0.3/2, and a misfit of
  // (1/6)^(1/2) over 2^(1/2).
  const Trend trend = fit_trend({0, 1, 2}, {{0, 0}, {0, 0}, {1, 0.3}});
  EXPECT_NEAR(trend.slope.value, 0.5, 1e-12);
  EXPECT_NEAR(trend.slope.sd, std::sqrt(1. / 12.), 1e-12);
}

TEST(Trend_analytic, without_uncertainty_or_with_one_abscissa_nothing_is_told) {
  EXPECT_EQ(fit_trend({1, 2}, {{1, NAN}, {2, 0.1}}).sign(), Trend::Sign::unknown);
  EXPECT_EQ(fit_trend({1, 1}, {{1, 0.1}, {2, 0.1}}).sign(), Trend::Sign::unknown);
  EXPECT_EQ(fit_exponent_of({1, 2}, {{1, 0.9}, {2, 0.1}}).sign(),
            Trend::Sign::unknown);  // 1 +- 0.9 may be nothing at all
}

TEST(Trend_analytic, exponent_of_a_power_law_is_found_in_units_of_any_size) {
  const auto law = [](double x) {
    const double y = 3e-16 * std::pow(x, 4. / 3.);
    return Uncertain{y, 0.01 * y};
  };
  const Trend trend = fit_exponent_of({1e-4, 3e-4, 1e-3}, {law(1e-4), law(3e-4), law(1e-3)});
  EXPECT_NEAR(trend.slope.value, 4. / 3., 1e-9);
  EXPECT_GT(trend.slope.sd, 0);
}

TEST(Trend_analytic, mean_of_slopes_that_may_err_together_is_no_better_than_each) {
  const Uncertain mean = cautious_mean({{1, 0.2}, {1, 0.2}, {1, 0.2}});
  EXPECT_NEAR(mean.value, 1, 1e-12);
  EXPECT_NEAR(mean.sd, 0.2, 1e-12);
}

/// First-order autoregression, rho the correlation of neighbours.
std::vector<double> correlated_series(std::mt19937& random, double rho, int count) {
  std::normal_distribution<double> normal;
  std::vector<double> values{normal(random)};
  for (int i = 1; i < count; ++i)
    values.push_back(rho * values.back() + std::sqrt(1 - rho * rho) * normal(random));
  return values;
}

TEST(CorrelatedMean_analytic, counts_the_independent_stretches_of_an_autoregression) {
  std::mt19937 random(1);
  constexpr double rho = 0.8;
  double independent = 0;
  constexpr int series = 100, count = 2000;
  for (int s = 0; s < series; ++s)
    independent += correlated_mean(correlated_series(random, rho, count)).independent / series;
  // N_eff = N (1 - rho)/(1 + rho); the sum that stops at the first zero is a few percent off.
  EXPECT_NEAR(independent / (count * (1 - rho) / (1 + rho)), 1, 0.08);
}

TEST(CorrelatedMean_analytic, is_within_its_standard_error_in_two_thirds_of_series) {
  std::mt19937 random(2);
  for (const double rho : {0.0, 0.5, 0.8}) {
    int within = 0;
    constexpr int series = 1000, count = 200;
    for (int s = 0; s < series; ++s) {
      const CorrelatedMean mean = correlated_mean(correlated_series(random, rho, count));
      within += std::abs(mean.mean) < mean.standard_error;
    }
    EXPECT_NEAR(within / double(series), 0.683, 0.06) << rho;
  }
}

/// Bartlett: the mean of N values is known to sd ((1 + rho)/((1 - rho) N))^(1/2).
TEST(CorrelatedMean_analytic, states_the_standard_error_of_an_autoregression) {
  std::mt19937 random(3);
  constexpr int series = 100, count = 2000;
  for (const double rho : {0.0, 0.6, 0.8}) {
    double error = 0, sd = 0;
    for (int s = 0; s < series; ++s) {
      const CorrelatedMean mean = correlated_mean(correlated_series(random, rho, count));
      error += mean.standard_error / series, sd += mean.sd / series;
    }
    EXPECT_NEAR(sd, 1, 0.02) << rho;
    EXPECT_NEAR(error / std::sqrt((1 + rho) / (1 - rho) / count), 1, 0.04) << rho;
  }
}

TEST(CorrelatedMean_analytic, of_few_values_is_that_worked_out_by_hand) {
  // Mean 5, sd 1; rho_1 = 3/6, rho_2 = 0: N_eff = 6/(1 + 2/2) = 3.
  const CorrelatedMean step = correlated_mean({6, 6, 6, 4, 4, 4});
  EXPECT_DOUBLE_EQ(step.mean, 5);
  EXPECT_DOUBLE_EQ(step.sd, 1);
  EXPECT_DOUBLE_EQ(step.independent, 3);
  EXPECT_DOUBLE_EQ(step.standard_error, 1 / std::sqrt(2.0));
  // The correlation vanishes next to each value: what comes after no longer counts, though it is positive.
  const CorrelatedMean vanishing = correlated_mean({1, 0, 1, 0, -1, 0, -1, 0});
  EXPECT_DOUBLE_EQ(vanishing.independent, 8);
  EXPECT_DOUBLE_EQ(vanishing.standard_error, std::sqrt(0.5 / 7));
  const CorrelatedMean alternating = correlated_mean({1, -1, 1, -1, 1, -1});
  EXPECT_DOUBLE_EQ(alternating.independent, 6);
  EXPECT_DOUBLE_EQ(alternating.standard_error, 1 / std::sqrt(5.0));
}

/// A ramp of N values: N cov_k = M (M^2 - 1)/12 - M k^2/4 with M = N - k, above zero up to k = 0.37 N.
TEST(CorrelatedMean_analytic, of_a_ramp_sums_its_correlation_to_the_last_positive_one) {
  constexpr int count = 30;
  std::vector<double> ramp;
  for (int i = 0; i < count; ++i) ramp.push_back(7 - 0.5 * i);
  const auto covariance = [](int k) {
    const double m = count - k;
    return m * (m * m - 1) / 12 - m * k * k / 4;
  };
  double sum = 1;
  for (int k = 1; covariance(k) > 0; ++k) sum += 2 * covariance(k) / covariance(0);
  const CorrelatedMean mean = correlated_mean(ramp);
  EXPECT_NEAR(mean.mean, 7 - 0.5 * 14.5, 1e-12);
  EXPECT_NEAR(mean.sd, 0.5 * std::sqrt((count * count - 1) / 12.0), 1e-12);
  EXPECT_NEAR(mean.independent, count / sum, 1e-9);
  EXPECT_NEAR(mean.standard_error, mean.sd / std::sqrt(count / sum - 1), 1e-9);
}

TEST(CorrelatedMean_analytic, of_values_all_alike_is_exact_and_of_two_is_known_to_their_scatter) {
  const CorrelatedMean alike = correlated_mean({3, 3, 3, 3, 3});
  EXPECT_EQ(alike.mean, 3);
  EXPECT_EQ(alike.sd, 0);
  EXPECT_EQ(alike.standard_error, 0);
  EXPECT_EQ(alike.independent, 5);
  const CorrelatedMean two = correlated_mean({0, 2});
  EXPECT_DOUBLE_EQ(two.mean, 1);
  EXPECT_DOUBLE_EQ(two.standard_error, 1);
}

TEST(ResampledAlong_analytic, takes_a_median_step_and_goes_straight_between_rows) {
  const std::vector<double> uneven{0, 1, 2, 4, 8}, squares{0, 1, 4, 16, 64};
  const std::vector<double> expected{0, 4, 16, 40, 64};  // steps of 1, 1, 2, 4: the upper of the middle two
  EXPECT_EQ(resampled_along(uneven, squares, 0, 4), expected);
  std::vector<double> falling = uneven;
  for (double& x : falling) x = 10 - x;
  EXPECT_EQ(resampled_along(falling, squares, 0, 4), expected);
  // Rows 1 to 3: a way of 3 in steps of 2 is two of 1.5.
  EXPECT_EQ(resampled_along(uneven, squares, 1, 3), (std::vector<double>{1, 7, 16}));
  EXPECT_EQ(resampled_along(uneven, squares, 3, 4), (std::vector<double>{16, 64}));
}

TEST(ResampledAlong_analytic, passes_over_rows_at_rest) {
  const std::vector<double> x{0, 0, 1, 2, 2, 2, 2, 3}, y{1, 1, 2, 3, 4, 5, 6, 7};
  EXPECT_EQ(resampled_along(x, y, 0, 7), (std::vector<double>{1, 2, 3, 7}));
  EXPECT_EQ(resampled_along(x, y, 3, 6), (std::vector<double>{3}));
}

}  // namespace
}  // namespace asperity
