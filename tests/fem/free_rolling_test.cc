#include "fem/programs/free_rolling.h"

#include <gtest/gtest.h>

namespace {

using namespace asperity::fem;
using asperity::HistoryRow;

constexpr RollingContact rolling_contact{8e-6, 2e-7, 1e5};

std::vector<Station> free_from(std::vector<bool> free) {
  std::vector<Station> program(free.size());
  for (std::size_t k = 0; k < free.size(); ++k) program[k].rolls_freely = free[k];
  return program;
}

HistoryRow rolled_to(double angle, double shift, double lateral_force, double approach = 5e-9) {
  HistoryRow r;
  r.normal_force = 1e-4;
  r.rolling_angle = angle, r.shift = shift, r.lateral_force = lateral_force, r.normal_displacement = approach;
  return r;
}

TEST(FreeRolling_analytic, without_friction_goes_by_the_radius) {
  const RollingStep step = free_rolling(free_from({false, true}), {rolled_to(0, 0, 3e-6)},
                                        {rolling_contact.radius, rolling_contact.hertz_radius, 0});
  EXPECT_EQ(step.path_per_angle, rolling_contact.radius);
  EXPECT_EQ(step.back, 0);
}

TEST(FreeRolling_behaviour, gives_way_to_the_force_that_is_left) {
  const RollingStep step = free_rolling(free_from({false, true}), {rolled_to(0, 0, 1e-6)}, rolling_contact);
  EXPECT_DOUBLE_EQ(step.back, 1e-6 / rolling_contact.lateral_stiffness);
}

TEST(FreeRolling_analytic, learns_the_way_per_angle_that_leaves_no_force) {
  constexpr double true_path_per_angle = 7.9e-6, angle = 1e-3;
  // A step by the radius, longer than the true path, has left the spring's force.
  const double left =
      rolling_contact.lateral_stiffness * (rolling_contact.radius - true_path_per_angle) * angle;
  const auto program = free_from({false, true, true});
  const RollingStep step = free_rolling(
      program, {rolled_to(0, 0, 0), rolled_to(angle, rolling_contact.radius * angle, left)}, rolling_contact);
  EXPECT_NEAR(step.back, (rolling_contact.radius - true_path_per_angle) * angle, 1e-18);
  // A quarter of the way to the true one; steps that follow it leave less and less.
  EXPECT_NEAR(step.path_per_angle,
              rolling_contact.radius - 0.25 * (rolling_contact.radius - true_path_per_angle), 1e-15);
  std::vector<Station> many(40);
  for (auto& s : many) s.rolls_freely = true;
  many[0].rolls_freely = false;
  std::vector<HistoryRow> records{rolled_to(0, 0, 0), rolled_to(angle, rolling_contact.radius * angle, left)};
  for (int k = 2; k < 40; ++k) {
    const RollingStep next = free_rolling(many, records, rolling_contact);
    const double shift = records.back().shift + next.path_per_angle * angle - next.back;
    records.push_back(rolled_to(
        k * angle, shift, rolling_contact.lateral_stiffness * (shift - true_path_per_angle * k * angle)));
  }
  EXPECT_NEAR(records.back().lateral_force, 0, 1e-3 * left);
}

TEST(FreeRolling_behaviour, after_sliding_does_not_learn_until_it_has_left_the_contact_behind) {
  const auto program = free_from({false, true, true, true});
  const HistoryRow slid = rolled_to(0, 1e-7, 3e-5);
  const RollingStep soon = free_rolling(program, {slid, rolled_to(0.01, 1.8e-7, 1e-5)}, rolling_contact);
  EXPECT_DOUBLE_EQ(soon.path_per_angle, rolling_contact.radius - 5e-9);
  const RollingStep late =
      free_rolling(program, {slid, rolled_to(0.01, 1.8e-7, 0), rolled_to(0.03, 1.8e-7 + 0.02 * 7.9e-6, 0)},
                   rolling_contact);
  EXPECT_NEAR(late.path_per_angle, 7.9e-6, 1e-15);
}

}  // namespace
