#include "core/residual_imprint.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {

TEST(ResidualImprint_analytic, a_hertzian_unloading_from_an_imprint_leaves_it_at_any_last_load) {
  // Both branches F = (delta - delta0)^(3/2) in some unit; loading from 0, unloading from an imprint of 0.3.
  const auto approach = [](double force) { return std::pow(force, 2.0 / 3); };
  constexpr double imprint = 0.3;
  std::vector<double> up, up_force, down, down_force;
  for (const double f : {0.2, 0.5, 1.0, 2.0}) up.push_back(approach(f)), up_force.push_back(f);
  for (const double f : {2.0, 1.0, 0.1}) {
    down.push_back(approach(f) + imprint), down_force.push_back(f);
    if (down.size() < 2) continue;
    const ResidualImprint left = residual_imprint(up, up_force, down, down_force);
    EXPECT_NEAR(left.depth, imprint, 1e-12) << f;
    EXPECT_EQ(left.force, f);
    EXPECT_NEAR(left.error, 0, 1e-12);  // the loading is Hertz' from its first step on
  }
  down.push_back(imprint), down_force.push_back(0);
  down.push_back(imprint - 1), down_force.push_back(0);  // drawn apart further
  EXPECT_NEAR(residual_imprint(up, up_force, down, down_force).depth, imprint, 1e-12);
}

/// Rough bodies load along another power below the first step than Hertz': the uncertainty that follows is
/// stated.
TEST(ResidualImprint_analytic, tells_how_far_an_extrapolated_loading_is_from_Hertz) {
  const std::vector<double> up{1.0, 1.5}, force{1.0, 2.0};  // d = F^0.585
  const double power = std::log(1.5) / std::log(2.0), low = 0.01;
  const ResidualImprint left = residual_imprint(up, force, {1.5, 0.05}, {2.0, low});
  EXPECT_NEAR(left.error, std::pow(low, power) - std::pow(low, 2.0 / 3), 1e-12);
  EXPECT_EQ(residual_imprint(up, force, {1.5, 1.2}, {2.0, 1.1}).error, 0);
  // Steeper than Hertz' the extrapolation lies below it; the error is a size.
  const double steep = std::log(1.8) / std::log(2.0);
  EXPECT_NEAR(residual_imprint({1.0, 1.8}, force, {1.8, 0.05}, {2.0, low}).error,
              std::pow(low, 2.0 / 3) - std::pow(low, steep), 1e-12);
}

TEST(ResidualImprint_analytic, there_is_none_where_nothing_was_unloaded) {
  EXPECT_TRUE(std::isnan(residual_imprint({1}, {1}, {1}, {1}).depth));
}

TEST(ResidualImprint_analytic, between_steps_of_the_loading_approach_is_linear_in_force_to_two_thirds) {
  const std::vector<double> up{1, 5, 6}, force{1, 8, 27};  // force^(2/3): 1, 4, 9
  const double at_2 = std::pow(2.0, 1.5), at_7 = std::pow(7.0, 1.5);
  EXPECT_NEAR(residual_imprint(up, force, {6, 4}, {27, at_2}).depth, 4 - (1 + 4.0 / 3), 1e-12);
  EXPECT_NEAR(residual_imprint(up, force, {6, 5.9}, {27, at_7}).depth, 5.9 - (5 + 3.0 / 5), 1e-12);
  EXPECT_NEAR(residual_imprint(up, force, {6, 5.5}, {27, 8}).depth, 0.5, 1e-12);
}

TEST(ResidualImprint_analytic, a_force_above_the_loading_counts_as_its_last_one) {
  EXPECT_NEAR(residual_imprint({1, 5}, {1, 8}, {5, 5.25}, {8, 8.001}).depth, 0.25, 1e-12);
}

TEST(ResidualImprint_analytic, a_loading_that_does_not_rise_tells_no_approach) {
  for (const std::vector<double>& force : {std::vector<double>{0, 8}, {8, 8}, {-1, 8}})
    EXPECT_TRUE(std::isnan(residual_imprint({1, 5}, force, {5, 3}, {8, 2}).depth));
  for (const std::vector<double>& up : {std::vector<double>{0, 5}, {5, 5}})
    EXPECT_TRUE(std::isnan(residual_imprint(up, {1, 8}, {5, 3}, {8, 2}).depth));
  EXPECT_TRUE(std::isnan(residual_imprint({1}, {1}, {5, 3}, {8, 2}).depth));
  // Without force there is no loading to be compared with.
  const ResidualImprint free = residual_imprint({1}, {1}, {5, 3}, {8, -0.5});
  EXPECT_EQ(free.depth, 3);
  EXPECT_EQ(free.force, 0);
  EXPECT_EQ(free.error, 0);
}

}  // namespace asperity
