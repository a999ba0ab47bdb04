#include "core/steady_motion.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(SteadyMotion_analytic, legs_end_where_the_motion_turns) {
  const auto legs = motion_legs({5, 5, 6, 8, 7, 7, 4, 9});
  ASSERT_EQ(legs.size(), 3u);
  EXPECT_EQ(legs[0].first, 1u);
  EXPECT_EQ(legs[0].last, 3u);
  EXPECT_EQ(legs[0].direction, 1);
  EXPECT_EQ(legs[1].first, 3u);
  EXPECT_EQ(legs[1].last, 6u);
  EXPECT_EQ(legs[1].direction, -1);
  EXPECT_EQ(legs[2].first, 6u);
  EXPECT_EQ(legs[2].last, 7u);
  EXPECT_TRUE(motion_legs({}).empty());
  EXPECT_TRUE(motion_legs({3, 3, 3}).empty());
}

/// Rest is a share of the whole path, wherever it lies.
TEST(SteadyMotion_analytic, creeping_by_two_hundred_thousandths_of_the_way_is_rest) {
  EXPECT_EQ(motion_legs({1000, 1000.000015, 1001}).front().first, 1u);
  EXPECT_EQ(motion_legs({1000, 1000.000025, 1001}).front().first, 0u);
}

TEST(SteadyMotion_analytic, sliding_is_steady_from_two_per_cent_of_sticking_on_if_three_rows_are) {
  MotionRows rows;
  rows.position = {0, 1, 2, 3, 4, 5};
  rows.sticking = {1, 0.5, 0.021, 0.02, 0.01, 0};
  EXPECT_EQ(steady_onset(rows, {0, 5, 1}), 3u);
  EXPECT_EQ(steady_rows_of_first_leg(rows).first, 3u);
  EXPECT_EQ(steady_rows_of_first_leg(rows).last, 5u);
  EXPECT_TRUE(steady_rows_of_first_leg(rows).reached());
  rows.sticking[3] = 0.03;  // two rows are left
  EXPECT_EQ(steady_onset(rows, {0, 5, 1}), 6u);
  EXPECT_FALSE(steady_rows_of_first_leg(rows).reached());
  EXPECT_FALSE(steady_rows_of_first_leg({}).reached());
}

/// Of the 40 to 50 active nodes of a coarse contact one or two are about the axis.
TEST(SteadyMotion_analytic, spinning_is_steady_from_five_per_cent_of_sticking_on_where_the_moment_has_risen) {
  MotionRows rows;
  rows.position = {0, -1, -2, -3, -4, -5, -6};
  rows.sticking = {1, 0.5, 0.051, 0.05, 0.04, 0.03, 0.03};
  rows.resistance = {0, -50, -90, -96, -100, -101, -100};
  EXPECT_EQ(steady_onset(rows, {0, 6, -1}), 7u);
  rows.spins = true;
  EXPECT_EQ(steady_onset(rows, {0, 6, -1}), 4u);
  rows.sticking[3] = 0.02;
  EXPECT_EQ(steady_onset(rows, {0, 6, -1}), 3u) << "slips as a whole, though the moment still rises";
  rows.sticking[3] = 0.05;
  rows.resistance[3] = -99.5;
  EXPECT_EQ(steady_onset(rows, {0, 6, -1}), 3u);
}

TEST(SteadyMotion_analytic, rolling_is_steady_after_two_contact_radii_of_way_in_either_direction) {
  MotionRows rows;
  rows.rolling_radius = 10;
  for (const double direction : {1.0, -1.0}) {
    rows.position.clear(), rows.contact_radius.assign(7, 1.5);
    for (int i = 0; i < 7; ++i) rows.position.push_back(0.5 + direction * 0.1 * i);
    rows.contact_radius[3] = 1.75;  // path length 3: still short of it
    EXPECT_EQ(steady_onset(rows, {0, 6, direction > 0 ? 1 : -1}), 4u);
  }
}

TEST(SteadyMotion_analytic,
     without_sticking_it_is_steady_where_two_slopes_are_below_a_fiftieth_of_the_steepest) {
  MotionRows rows;
  rows.position = {0, 2, 4, 6, 8, 10, 12, 14};
  rows.resistance = {0, 100, 150, 151, 160, 161, 162, 163};  // slopes 50, 25, 0.5, 4.5, 0.5, 0.5, 0.5
  EXPECT_EQ(steady_onset(rows, {0, 7, 1}), 5u);
  for (double& x : rows.position) x = -x;
  EXPECT_EQ(steady_onset(rows, {0, 7, -1}), 5u);
  rows.resistance = {0, 100, 150, 200, 250, 300, 350, 400};
  EXPECT_EQ(steady_onset(rows, {0, 7, -1}), 8u);
}

TEST(SteadyMotion_analytic, work_is_the_area_under_the_resistance) {
  const std::vector<double> position{0, 2, 3, 1}, resistance{1, 3, 5, -1};
  EXPECT_EQ(work_against_motion(position, resistance), (std::vector<double>{0, 4, 8, 4}));
  EXPECT_TRUE(work_against_motion({}, {}).empty());
  EXPECT_EQ(per_path_length(position, {0, 4, 8, 14}, 1, 2), 4);
  EXPECT_EQ(per_path_length(position, {0, 4, 8, 14}, 2, 3), 3);  // per distance, there and back
}

}  // namespace
}  // namespace asperity
