// Residuals where a simulated contact snaps, against steps that are set by hand.
#include "diagnosis/fit/snaps.h"

#include <gtest/gtest.h>

#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

/// Recorded less simulated, as it is forgiven.
std::vector<double> forgiven(const std::vector<double>& recorded, const std::vector<double>& simulated,
                             const char* channel = "normal_force") {
  Samples samples;
  samples.list.resize(recorded.size());
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

}  // namespace
}  // namespace asperity
