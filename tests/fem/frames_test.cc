// Frames of an animation: which steps are shown, and when.
#include "fem/output/frames.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace asperity;
using namespace asperity::fem;

ExperimentInput experiment(Motion type) {
  ExperimentInput e;
  e.type = type;
  e.load_steps = 20, e.unload_steps = 20;
  e.normal_load = 100e-6;
  return e;
}

MotionScales scales_of_motion() {
  MotionScales s;
  s.largest_shift = s.largest_roll = 10e-9, s.full_slip_shift = 1e-9, s.largest_angle = 0.01,
  s.full_slip_angle = 0.05;
  s.rolling_radius = 5e-6, s.contact_radius = 200e-9;
  return s;
}

std::vector<int> shown_steps(const Frames& frames) {
  std::vector<int> steps;
  for (std::size_t k = 0; k < frames.shown.size(); ++k)
    if (frames.shown[k]) steps.push_back(static_cast<int>(k) + 1);
  return steps;
}

Frames frames(const ExperimentInput& e, int every = 0) {
  return frames_of(e, make_program(e, scales_of_motion()), scales_of_motion(), e.normal_load, every);
}

TEST(Frames_behaviour, of_a_pressed_contact_run_on_with_the_load_and_while_it_falls) {
  const Frames pressed = frames(experiment(Motion::normal));
  EXPECT_EQ(pressed.time_is, FrameTime::load);
  EXPECT_TRUE(std::is_sorted(pressed.time.begin(), pressed.time.end()));
  EXPECT_NEAR(pressed.time[19], 100, 1e-9);
  EXPECT_NEAR(pressed.time.back(), 200, 0.2);  // a thousandth of the load is kept
  const auto steps = shown_steps(pressed);
  EXPECT_GE(steps.size(), 10u);
  EXPECT_LE(steps.size(), 12u);
  EXPECT_EQ(std::count(steps.begin(), steps.end(), 20), 1);  // the largest load
  EXPECT_EQ(steps.back(), 40);
}

TEST(Frames_behaviour, of_a_contact_that_moves_run_on_with_its_path) {
  ExperimentInput e = experiment(Motion::sliding);
  e.distance = 300e-9, e.reverse = true;
  const Frames slid = frames(e);
  EXPECT_EQ(slid.time_is, FrameTime::path);
  EXPECT_TRUE(std::is_sorted(slid.time.begin(), slid.time.end()));
  EXPECT_NEAR(slid.time[19], 0, 1e-9);
  EXPECT_NEAR(slid.path_length.back(), 600e-9, 1e-12);
  EXPECT_NEAR(slid.time.back(), 601, 0.01);  // unloading is the last nanometre
  e = experiment(Motion::rolling);
  e.distance = 300e-9, e.reverse = false;
  EXPECT_NEAR(frames(e).path_length.back(), 300e-9, 1e-12);
  e = experiment(Motion::torsion);
  e.angle = 0.1, e.reverse = false;
  EXPECT_NEAR(frames(e).path_length.back(), 0.1 * 200e-9, 1e-12);
}

TEST(Frames_behaviour, of_a_case_with_times_run_on_with_them_and_every_so_many_steps_where_asked) {
  ExperimentInput e = experiment(Motion::normal);
  e.load_time = 2, e.hold_steps = 5, e.hold_time = 10;
  const Frames held = frames(e, 7);
  EXPECT_EQ(held.time_is, FrameTime::seconds);
  EXPECT_NEAR(held.time.back(), 14, 1e-9);
  EXPECT_EQ(shown_steps(held), (std::vector<int>{7, 14, 20, 21, 28, 35, 42, 45}));
}

}  // namespace
