// Residuals where a simulated contact snaps, against steps that are set by hand.
#include "diagnosis/fit/snaps.h"

#include <gtest/gtest.h>

#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

/// Recorded less simulated, as it is forgiven.
std::vector<double> forgiven(const std::vector<double>& recorded, const std::vector<double>& simulated,
                             const char* channel = "normal_force", double snap_width = 0) {
  Samples samples;
  samples.list.resize(recorded.size());
  samples.snap_width = snap_width;
  for (std::size_t i = 0; i < recorded.size(); ++i)
    samples.list[i].normal_displacement = -static_cast<double>(i);
  test::close_run(samples, false);
  samples.response_channels = {channel};
  std::vector<double> residual(recorded.size());
  for (std::size_t i = 0; i < recorded.size(); ++i) residual[i] = recorded[i] - simulated[i];
  forgive_a_sample_at_snaps(samples, simulated, residual);
  return residual;
}

const std::vector<double> snapping{0, 0, 0, 0, -5, -4.9, -4.8, -4.7};

TEST(Snaps_analytic, a_sample_early_or_late_is_forgiven_and_a_second_is_not) {
  const std::vector<double> none(8, 0.0);
  EXPECT_EQ(forgiven(snapping, snapping), none);
  const std::vector<double> early = forgiven({0, 0, 0, -5, -5, -4.9, -4.8, -4.7}, snapping),
                            late = forgiven({0, 0, 0, 0, 0, -4.9, -4.8, -4.7}, snapping),
                            two_late = forgiven({0, 0, 0, 0, 0, 0, -4.8, -4.7}, snapping);
  EXPECT_EQ(early, none);
  EXPECT_EQ(late, none);
  EXPECT_EQ(two_late, (std::vector<double>{0, 0, 0, 0, 0, 4.9, 0, 0}));
}

TEST(Snaps_analytic, noise_at_a_snap_and_steps_that_are_none_stay) {
  // Off the snap by less than half of it: the sample is on its own side.
  EXPECT_EQ(forgiven({0, 0, 0, -1, -5, -4.9, -4.8, -4.7}, snapping)[3], -1);
  const std::vector<double> slope{0, 1, 2, 3, 4, 5, 6, 7};
  EXPECT_EQ(forgiven({0, 1, 2, 4, 4, 5, 6, 7}, slope)[3], 1);
  EXPECT_EQ(forgiven({0, 0, 0, -5, -5, -4.9, -4.8, -4.7}, snapping, "lateral_force")[3], -5);
}

TEST(Snaps_analytic, samples_within_a_load_step_of_a_solution_may_lie_on_either_side_and_between) {
  const std::vector<double> none(8, 0.0), opening{-4.7, -4.8, -4.9, -5, 0, 0, 0, 0};
  const auto forgiven_within = [&](const std::vector<double>& recorded, double width) {
    return forgiven(recorded, opening, "normal_force", width);
  };
  const std::vector<double> two_late{-4.7, -4.8, -4.9, -5, -5, -5, 0, 0},
      two_early{-4.7, -4.8, 0, 0, 0, 0, 0, 0}, ramp{-4.7, -4.8, -4.9, -4, -3, -2, 0, 0};
  for (const auto& recorded : {two_late, two_early, ramp}) {
    EXPECT_EQ(forgiven_within(recorded, 1.5), none);
    EXPECT_NE(forgiven_within(recorded, 0), none);
  }
  // What lies beyond both sides, or farther off, stays.
  const std::vector<double> beyond = forgiven_within({-4.7, -4.8, -4.9, -6, 1, 0, 0, -3}, 1.5);
  EXPECT_EQ(beyond, (std::vector<double>{0, 0, 0, -1, 1, 0, 0, -3}));
  EXPECT_EQ(forgiven_within({0, -4.8, -4.9, -5, 0, 0, 0, 0}, 1.5)[0], 4.7);
}

}  // namespace
}  // namespace asperity
