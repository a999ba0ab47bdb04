// Stiffness after a turn: of rolling a spring that yields, over hills far higher than what it resists.
#include "dem_compare/cases/reversal_stiffness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "dem_compare/laws/lubkin_torsion.h"

namespace asperity {
namespace {

constexpr double stiffness = 2e-11, resistance = 3e-13, hill = 2e-12,
                 wave = 0.02;  // [N m/rad], [N m], [N m], [rad]

struct Rolled {
  std::vector<double> angle, moment;
  double spring = 0;

  void to(double position) {
    spring = std::clamp(spring + stiffness * (position - (angle.empty() ? 0 : angle.back())), -resistance,
                        resistance);
    angle.push_back(position);
    moment.push_back(spring + hill * std::sin(2 * M_PI * position / wave));
  }
};

/// Out in steps of a sixth of the hills' wave, back in finer ones.
Rolled there_and_back(double back) {
  Rolled rolled;
  for (int i = 0; i < 4; ++i) rolled.to(0);  // pressing
  for (int i = 1; i <= 60; ++i) rolled.to(i * wave / 6);
  const double turn = rolled.angle.back();
  for (double step = 1e-3, way = step; way <= back; step *= 1.2, way += step) rolled.to(turn - way);
  return rolled;
}

TEST(RollingStiffness_analytic, is_that_of_the_spring_below_hills_six_times_as_high) {
  const Rolled rolled = there_and_back(0.03);
  const auto found = rolling_stiffness(rolled.angle, rolled.moment, resistance);
  EXPECT_NEAR(found.value / stiffness, 1, 0.1);
  EXPECT_LT(std::abs(found.value - stiffness), 3 * found.error);
  EXPECT_LT(found.error, 0.1 * stiffness);
}

TEST(RollingStiffness_analytic, does_not_depend_on_the_direction) {
  Rolled rolled = there_and_back(0.03);
  const double expected = rolling_stiffness(rolled.angle, rolled.moment, resistance).value;
  for (auto* values : {&rolled.angle, &rolled.moment})
    for (double& v : *values) v = -v;
  EXPECT_NEAR(rolling_stiffness(rolled.angle, rolled.moment, resistance).value, expected, 1e-12 * expected);
}

/// A linear spring's moment lacks k delta until twice the resistance: exact without hills, however long the
/// way back.
TEST(RollingStiffness_analytic, counts_up_to_half_the_width_of_the_loop) {
  std::vector<double> angle, moment;
  for (int i = 0; i <= 40; ++i)
    angle.push_back(0.002 * i), moment.push_back(std::min(resistance, stiffness * angle.back()));
  for (int i = 1; i <= 30; ++i) {
    angle.push_back(0.08 - 0.0025 * i);
    moment.push_back(std::max(-resistance, resistance - stiffness * 0.0025 * i));
  }
  EXPECT_NEAR(rolling_stiffness(angle, moment, resistance).value, stiffness, 1e-9 * stiffness);
}

/// No moment on the way out; it lacks 1.2, 1.8, 3.2 and 3.8 at 1 to 4 on the way back.
TEST(RollingStiffness_analytic, is_the_least_squares_line_through_the_turn_with_its_error) {
  std::vector<double> angle, moment;
  for (int i = 0; i <= 8; ++i) angle.push_back(i), moment.push_back(0);
  const double lack[] = {1.2, 1.8, 3.2, 3.8};
  for (int i = 1; i <= 4; ++i) angle.push_back(8 - i), moment.push_back(-lack[i - 1]);
  const double slope = (1.2 + 2 * 1.8 + 3 * 3.2 + 4 * 3.8) / 30;
  double misfit = 0;
  for (int i = 1; i <= 4; ++i) misfit += std::pow(lack[i - 1] - slope * i, 2);
  const ReversalStiffness all = rolling_stiffness(angle, moment, 100);
  EXPECT_NEAR(all.value, slope, 1e-12);
  EXPECT_NEAR(all.error, std::sqrt(misfit / 3 / 30), 1e-12);
  // Up to the row at which the lack has come to the resistance.
  EXPECT_NEAR(rolling_stiffness(angle, moment, 3.1).value, (1.2 + 2 * 1.8 + 3 * 3.2) / 14, 1e-12);
  // Three rows in any case.
  EXPECT_NEAR(rolling_stiffness(angle, moment, 0.1).value, (1.2 + 2 * 1.8 + 3 * 3.2) / 14, 1e-12);
}

TEST(RollingStiffness_behaviour, needs_a_turn_and_three_rows_after_it) {
  const Rolled straight = there_and_back(0);
  EXPECT_TRUE(std::isnan(rolling_stiffness(straight.angle, straight.moment, resistance).value));
  const Rolled brief = there_and_back(0.0025);
  EXPECT_TRUE(std::isnan(rolling_stiffness(brief.angle, brief.moment, resistance).value));
}

/// Nothing is known of rolling's partial slip.
const PartialSlip secant = partial_slip_of(Motion::rolling);

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
  const ReversalStiffness first = after_turns(12, secant);
  EXPECT_DOUBLE_EQ(first.value, 9.6);
  EXPECT_DOUBLE_EQ(first.error, 1.6);
  // The second turn has 4 at 2, 6 at 9: the stiffness grows, and the error is still above zero.
  const ReversalStiffness both = after_turns(14, secant);
  EXPECT_DOUBLE_EQ(both.value, (9.6 + 4 - 4.0 / 7) / 2);
  EXPECT_DOUBLE_EQ(both.error, 1.6);
  std::vector<double> x(turning_way.begin(), turning_way.begin() + 12);
  std::vector<double> y(turning_force.begin(), turning_force.begin() + 12);
  y[6] = 8;  // secants of 4 and 6
  EXPECT_DOUBLE_EQ(reversal_stiffness(x, y, 10, secant).value, 4 - 4.0 / 7);
  EXPECT_DOUBLE_EQ(reversal_stiffness(x, y, 10, secant).error, 4.0 / 7);
}

TEST(ReversalStiffness_analytic, takes_partial_slip_out_at_half_the_change) {
  // Shares 4/20 and 9/20: 8 1.2 = 9.6 and 6 1.45 = 8.7.
  const ReversalStiffness stiffness = after_turns(12, [](double share) { return 1 + share; });
  EXPECT_NEAR(stiffness.value, 9.6 + 0.9 * 4 / 5, 1e-12);
  EXPECT_NEAR(stiffness.error, 0.72, 1e-12);
}

TEST(ReversalStiffness_behaviour, asks_for_two_rows_that_do_not_slip_fully) {
  EXPECT_TRUE(std::isnan(after_turns(7, secant).value));
  EXPECT_FALSE(std::isnan(after_turns(8, secant).value));
  // A change of 9 is 96 % of twice 4.7.
  EXPECT_TRUE(std::isnan(after_turns(12, secant, 4.7).value));
  EXPECT_FALSE(std::isnan(after_turns(12, secant, 4.8).value));
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
