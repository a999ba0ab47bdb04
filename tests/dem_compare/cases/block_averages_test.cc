#include "dem_compare/cases/block_averages.h"

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

}  // namespace
}  // namespace asperity
