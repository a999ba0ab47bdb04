// A spring that yields, rolled over hills far higher than what it resists.
#include "dem_compare/derive/rolling_stiffness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

}  // namespace
}  // namespace asperity
