// What a single point says of finite load steps, by closed forms; whole contacts are in
// normal_experiment_test.cc.
#include "fem/solver/load_step_error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::fem {
namespace {

using Tensor = SymmetricTensor<Simd<double>>;

/// A deviator in the plane of xx - yy and xy, `size` long at `angle` from pure xx - yy.
Tensor deviator(double size, double angle) {
  Tensor result{};
  result[0][0] = size * std::cos(angle) / std::sqrt(2.0);
  result[1][0] = -result[0][0];
  result[3][0] = size * std::sin(angle) / std::sqrt(2.0);
  return result;
}

/// A step that flows by `flow` in the direction at `angle`, from the yield surface of radius `limit` at angle
/// 0.
FlowTurn turned_by(double angle, double limit, double flow, double stiffness) {
  const Tensor start = deviator(limit, 0), end = deviator(limit, angle), increment = deviator(flow, angle);
  Tensor change{}, trial{};
  for (int c = 0; c < 6; ++c) change[c] = end[c] - start[c], trial[c] = end[c] + stiffness * increment[c];
  return flow_turn(start, trial, limit, increment, change, 0);
}

TEST(LoadStepError_analytic, a_point_that_turns_leaves_half_its_flow_times_the_chord_squared) {
  // (n - n0) : (limit n - limit n0) = limit |n - n0|^2 = 2 limit (1 - cos angle). Flow is large enough that
  // the straight way to the trial stress leaves the yield surface at once: (limit + stiffness flow) cos angle
  // > limit.
  const double limit = 0.7e9, flow = 6e-3;
  for (const double angle : {0.1, -0.1, 0.8}) {
    const FlowTurn turn = turned_by(angle, limit, flow, 60e9);
    EXPECT_NEAR(turn.energy, flow * limit * (1 - std::cos(angle)), 1e-9 * flow * limit) << angle;
    // e = flow (n - n0) / 2, n and n0 `angle` apart.
    const Tensor expected = deviator(0.5 * flow, angle), onset = deviator(0.5 * flow, 0);
    for (int c = 0; c < 6; ++c)
      EXPECT_NEAR(turn.strain[c], expected[c][0] - onset[c][0], 1e-9 * flow) << angle;
  }
  EXPECT_NEAR(turned_by(0, limit, flow, 60e9).energy, 0, 1e-9 * flow * limit) << "a straight way";
}

TEST(LoadStepError_analytic, flow_that_begins_within_the_step_turns_from_where_it_begins) {
  // Straight on from half the yield stress: the direction at the onset is that at the end.
  const double limit = 0.7e9, stiffness = 60e9, flow = 1e-3;
  const Tensor start = deviator(0.5 * limit, 0.3), trial = deviator(limit + stiffness * flow, 0.3);
  Tensor change{};
  for (int c = 0; c < 6; ++c) change[c] = deviator(limit, 0.3)[c] - start[c];
  EXPECT_NEAR(flow_turn(start, trial, limit, deviator(flow, 0.3), change, 0).energy, 0, 1e-9 * flow * limit);
}

TEST(LoadStepError_analytic, without_flow_nothing_is_left) {
  const FlowTurn turn = turned_by(0.5, 1e9, 0, 60e9);
  EXPECT_EQ(turn.energy, 0);
  for (const double component : turn.strain) EXPECT_EQ(component, 0);
}

TEST(LoadStepError_analytic, a_change_of_force_at_a_turning_point_tells_nothing) {
  EXPECT_EQ(telling_change(2e-6, 1e-4), 2e-6);
  EXPECT_EQ(telling_change(-2e-6, 1e-4), -2e-6) << "unloading";
  EXPECT_EQ(telling_change(5e-7, 1e-4), 0);
  EXPECT_EQ(telling_change(5e-7, -1e-4), 0) << "pulled";
}

TEST(LoadStepError_analytic, a_step_is_divided_by_its_share_of_the_approach_over_what_is_asked) {
  const double approach = 2e-9, force = 1e-4, size = approach * force;
  EXPECT_EQ(parts_of_step(0.004 * size, approach, force, 5 * force, 0.005), 1);
  EXPECT_EQ(parts_of_step(0.012 * size, approach, force, 5 * force, 0.005), 3);
  EXPECT_EQ(parts_of_step(0.012 * size, -approach, -force, 5 * force, 0.005), 3) << "unloading";
  EXPECT_EQ(parts_of_step(size, approach, force, 5 * force, 0.005), 16) << "at most";
  EXPECT_EQ(parts_of_step(size, approach, force, 5 * force, 0), 1) << "never";
  EXPECT_EQ(parts_of_step(0, approach, force, 5 * force, 0.005), 1) << "nothing has yielded";
  // Where attraction softens the force hardly changes: a hundredth of it counts.
  EXPECT_EQ(parts_of_step(0.012 * approach * 0.01 * force, approach, 1e-9 * force, force, 0.005), 3);
}

}  // namespace
}  // namespace asperity::fem
