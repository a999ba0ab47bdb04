#include "dem_compare/cases/moving_case.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "dem_compare/laws/lubkin_torsion.h"
#include "dem_compare/laws/mindlin_deresiewicz.h"

namespace asperity {
namespace {

/// There and back through a contact with partial slip, steps growing from each turn.
struct Loop {
  std::vector<double> position, resistance, load;
};

/// `virgin`: resistance of the virgin curve at a way; branches after Masing.
template <class Virgin>
Loop loop(const Virgin& virgin, double first_step, double way, double growth = 1.3) {
  Loop result;
  const auto add = [&](double x, double y) {
    result.position.push_back(x), result.resistance.push_back(y), result.load.push_back(1e-4);
  };
  add(0, 0);
  std::vector<double> ways;
  double x = 0;
  for (double step = first_step; x < way; step = std::min(step * growth, way / 40))
    ways.push_back(x = std::min(x + step, way));
  for (const double w : ways) add(w, virgin(w));
  const double turn = virgin(way);
  for (const double w : ways) add(way - w, turn - 2 * virgin(w / 2));
  return result;
}

/// Of a history that tells neither energies nor what sticks.
MovingCase steady(const Loop& data) {
  EnergyHistory history;
  history.position = data.position, history.resistance = data.resistance, history.normal_force = data.load;
  history.contact_radius = history.contact_area = std::vector<double>(data.position.size(), 1e-7);
  SolvedCase solved;
  solved.folder = "made";
  return moving_case(solved, history, {});
}

/// Mindlin & Deresiewicz: Q = mu P (1 - (1 - x/x_slip)^(3/2)), initial slope 3 mu P/(2 x_slip).
struct Sliding {
  double limit = 3e-5, stiffness = 17200;
  double slip_way() const { return 1.5 * limit / stiffness; }
  double operator()(double x) const {
    return x >= slip_way() ? limit : limit * (1 - std::pow(1 - x / slip_way(), 1.5));
  }
};

TEST(SteadyMotion_analytic, of_sliding_with_partial_slip_gives_the_limit_and_the_stiffness_without_slip) {
  const Sliding law;
  const Loop data = loop(law, law.slip_way() / 10, 60e-9);
  const MovingCase moving = steady(data);
  ASSERT_TRUE(moving.reached());
  EXPECT_NEAR(moving.resistance().value / law.limit, 1, 1e-6);
  EXPECT_LT(moving.first.fluctuation, 1e-6 * law.limit);
  EXPECT_NEAR(moving.load, 1e-4, 1e-15);
  const ReversalStiffness reversal =
      reversal_stiffness(data.position, data.resistance, moving.resistance().value, sliding_partial_slip);
  EXPECT_NEAR(reversal.value / law.stiffness, 1, 1e-6);
}

TEST(SteadyMotion_analytic, of_torsion_with_partial_slip_gives_full_slip_and_the_stiffness_without_slip) {
  const LubkinTorsion law{15e9, 0.3, 1e-4, 0.26e-6};
  const Loop data = loop([&](double angle) { return law.moment(angle); }, 1e-3, 0.08);
  const MovingCase moving = steady(data);
  ASSERT_TRUE(moving.reached());
  EXPECT_NEAR(moving.resistance().value / law.full_slip_moment(), 1,
              2e-3);  // full slip takes an infinite angle
  const ReversalStiffness reversal =
      reversal_stiffness(data.position, data.resistance, moving.resistance().value, torsion_partial_slip);
  EXPECT_NEAR(reversal.value / no_slip_torsion_stiffness(15e9, 0.26e-6), 1, 2e-3);
}

TEST(SteadyMotion_behaviour, that_never_slips_fully_has_no_steady_resistance) {
  const Sliding law;
  const Loop data = loop(law, law.slip_way() / 20, 0.5 * law.slip_way(), 1);
  EXPECT_FALSE(steady(data).reached());
  EXPECT_TRUE(
      std::isnan(reversal_stiffness(data.position, data.resistance, law.limit, sliding_partial_slip).value));
}

TEST(SteadyMotion_behaviour, legs_are_parted_at_reversals_and_rest_belongs_to_none) {
  const auto legs = motion_legs({0, 1e-12, -1e-12, 1, 2, 3, 2.5, 2.5, 1, 1.5});
  ASSERT_EQ(legs.size(), 3u);
  EXPECT_EQ(legs[0].first, 2u);
  EXPECT_EQ(legs[0].last, 5u);
  EXPECT_EQ(legs[0].direction, 1);
  EXPECT_EQ(legs[1].first, 5u);
  EXPECT_EQ(legs[1].last, 8u);
  EXPECT_EQ(legs[1].direction, -1);
  EXPECT_EQ(legs[2].last, 9u);
}

TEST(SteadyMotion_analytic, that_counts_resistance_with_the_other_sign_has_the_same_mean) {
  const Sliding law;
  Loop data = loop(law, law.slip_way() / 10, 60e-9);
  const double mean = steady(data).resistance().value;
  for (double& value : data.resistance) value = -value;
  EXPECT_DOUBLE_EQ(steady(data).resistance().value, mean);
}

TEST(SteadyMotion_behaviour, that_still_rises_is_said_to_change) {
  const Sliding law;
  const Loop data =
      loop([&](double x) { return law(x) * (1 + 0.1 * x / 60e-9); }, law.slip_way() / 10, 60e-9);
  Loop forward;
  for (std::size_t i = 0; i <= data.position.size() / 2; ++i)
    forward.position.push_back(data.position[i]), forward.resistance.push_back(data.resistance[i]),
        forward.load.push_back(1e-4);
  const SteadyPath way = steady(forward).first;
  EXPECT_TRUE(way.still_changes());
  EXPECT_NEAR(way.drift, 0.05, 0.01);
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

/// Out to full slip of 10 and back: secants of 8 and 6 after the turn at 5, of 4 and 6 after that at -0.5.
const std::vector<double> turning_way{0, 1, 2, 3, 4, 5, 4.5, 3.5, 2.5, 1.5, 0.5, -0.5, 0, 1};
const std::vector<double> turning_force{0, 8, 10, 10, 10, 10, 6, 1, -10, -10, -10, -10, -8, -1};

ReversalStiffness after_turns(std::size_t rows, const PartialSlip& slip, double full_slip = 10) {
  const auto part = [&](const std::vector<double>& all) {
    return std::vector<double>(all.begin(), all.begin() + static_cast<long>(rows));
  };
  return reversal_stiffness(part(turning_way), part(turning_force), full_slip, slip);
}

TEST(ReversalStiffness_analytic, is_carried_on_to_the_turn_and_its_error_is_how_far) {
  // Against the change of the resistance: 8 at 4, 6 at 9, so 8 + 2 4/5 at none.
  const ReversalStiffness first = after_turns(12, no_partial_slip);
  EXPECT_DOUBLE_EQ(first.value, 9.6);
  EXPECT_DOUBLE_EQ(first.error, 1.6);
  // The second turn has 4 at 2, 6 at 9: the stiffness grows, and the error is still above zero.
  const ReversalStiffness both = after_turns(14, no_partial_slip);
  EXPECT_DOUBLE_EQ(both.value, (9.6 + 4 - 4.0 / 7) / 2);
  EXPECT_DOUBLE_EQ(both.error, 1.6);
  std::vector<double> x(turning_way.begin(), turning_way.begin() + 12);
  std::vector<double> y(turning_force.begin(), turning_force.begin() + 12);
  y[6] = 8;  // secants of 4 and 6
  EXPECT_DOUBLE_EQ(reversal_stiffness(x, y, 10, no_partial_slip).value, 4 - 4.0 / 7);
  EXPECT_DOUBLE_EQ(reversal_stiffness(x, y, 10, no_partial_slip).error, 4.0 / 7);
}

TEST(ReversalStiffness_analytic, takes_partial_slip_out_at_half_the_change) {
  // Shares 4/20 and 9/20: 8 1.2 = 9.6 and 6 1.45 = 8.7.
  const ReversalStiffness stiffness = after_turns(12, [](double share) { return 1 + share; });
  EXPECT_NEAR(stiffness.value, 9.6 + 0.9 * 4 / 5, 1e-12);
  EXPECT_NEAR(stiffness.error, 0.72, 1e-12);
}

TEST(ReversalStiffness_behaviour, asks_for_two_rows_that_do_not_slip_fully) {
  EXPECT_TRUE(std::isnan(after_turns(7, no_partial_slip).value));
  EXPECT_FALSE(std::isnan(after_turns(8, no_partial_slip).value));
  // A change of 9 is 96 % of twice 4.7.
  EXPECT_TRUE(std::isnan(after_turns(12, no_partial_slip, 4.7).value));
  EXPECT_FALSE(std::isnan(after_turns(12, no_partial_slip, 4.8).value));
}

/// Of Mindlin & Deresiewicz' curve; a small share q leaves 1 + q/6.
TEST(PartialSlip_analytic, of_sliding_grows_from_one_to_three_halves) {
  EXPECT_EQ(sliding_partial_slip(0), 1);
  EXPECT_NEAR(sliding_partial_slip(1e-4), 1 + 1e-4 / 6, 1e-9);
  EXPECT_NEAR(sliding_partial_slip(0.875), 1.5 * 0.75 / 0.875, 1e-12);
  EXPECT_EQ(sliding_partial_slip(1), 1.5);
}

TEST(PartialSlip_analytic, of_torsion_does_not_depend_on_the_contact) {
  const LubkinTorsion law{15e9, 0.3, 1e-4, 0.26e-6};
  EXPECT_EQ(torsion_partial_slip(0), 1);
  for (const double share : {0.05, 0.4, 0.8}) {
    const double moment = share * law.full_slip_moment();
    const double without_slip = moment / no_slip_torsion_stiffness(15e9, 0.26e-6);
    EXPECT_NEAR(torsion_partial_slip(share) / (law.angle(moment) / without_slip), 1, 1e-6) << share;
  }
}

}  // namespace
}  // namespace asperity
