// Times of the steps of an experiment.
#include <gtest/gtest.h>

#include <vector>

#include "fem/programs/program.h"

namespace {

using namespace asperity;

TEST(Times_behaviour, of_steps_follow_from_speed_and_times_or_are_a_second) {
  ExperimentInput e;
  e.type = Motion::sliding, e.normal_load = 1, e.load_steps = 4, e.hold_steps = 2, e.unload_steps = 2;
  e.distance = 80, e.motion_steps = 4, e.reverse = false;
  const auto times = [&] {
    std::vector<double> times;
    for (const auto& station : fem::make_program(e, {10, 0, 20, 0})) times.push_back(station.duration);
    return times;
  };
  EXPECT_EQ(times(), std::vector<double>(12, 1));
  e.speed = 10, e.load_time = 8, e.hold_time = 6;
  EXPECT_EQ(times(), (std::vector<double>{2, 2, 2, 2, 3, 3, 2, 2, 2, 2, 4, 4}));
  e.type = Motion::torsion, e.angle = 4;
  fem::MotionScales scales;
  scales.contact_radius = 5;
  EXPECT_EQ(fem::make_program(e, scales)[6].duration, 0.5);
  e.type = Motion::program, e.unload = false, e.hold_steps = 0;
  e.program =
      "slide 6 and slide across 8 at 5 m/s in 2 steps; hold 7 s in 3 steps; press 0.5 in 1 step; slide 20 in "
      "1 step";
  const auto last = times();
  const std::vector<double> expected{2, 2, 2, 2, 1, 1, 1, 2, 4, 4, 2};
  ASSERT_EQ(last.size(), expected.size());
  for (std::size_t k = 0; k < last.size(); ++k) EXPECT_NEAR(last[k], expected[k], 1e-12) << k;
}

}  // namespace
