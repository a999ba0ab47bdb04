#include "diagnosis/recording/turning_point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/mechanics/mechanics.h"
#include "diagnosis/recording/experiment.h"
#include "diagnosis/recording/samples.h"
#include "tests/diagnosis/support/driven_recording.h"

namespace asperity {
namespace {

using test::Column;

/// There with the speed 1 to 100 and back with another one, at times half a unit apart that begin at `phase`.
struct Clocked {
  Column path, time;
  std::size_t turn = 0;

  Clocked(double phase, double speed_back) {
    for (double t = phase; t < 100; t += 0.5) path.push_back(t), time.push_back(t);
    turn = path.size();
    while (path.size() < turn + 60)
      time.push_back(time.back() + 0.5), path.push_back(100 - speed_back * (time.back() - 100));
  }
  std::optional<Turn> found(int named_late = 0) const {
    return turn_of(path, time, 0, turn + static_cast<std::size_t>(named_late), path.size());
  }
};

TEST(TurningPoint_analytic, is_where_the_motion_turned_between_two_samples) {
  for (const double phase : {0.05, 0.1, 0.25, 0.4, 0.45})
    for (const double back : {1.0, 0.5, 1.7})
      for (const int late : {-1, 0, 1}) {
        const Clocked motion(phase, back);
        const auto found = motion.found(late);
        ASSERT_TRUE(found && found->place) << phase << " " << back << " " << late;
        EXPECT_NEAR(found->place->displacement, 100, 1e-9);
        EXPECT_NEAR(found->place->time, 100, 1e-9);
        EXPECT_EQ(found->next, motion.turn);
      }
}

TEST(TurningPoint_analytic, is_known_where_a_sample_lies_at_it) {
  for (const double phase : {0.0, 0.001})  // to a hundredth of a step
    for (const int late : {0, 1}) {
      const Clocked motion(phase, 1);
      const auto found = motion.found(late);
      ASSERT_TRUE(found);
      EXPECT_FALSE(found->place);
      EXPECT_EQ(motion.path[found->next - 1], *std::max_element(motion.path.begin(), motion.path.end()));
    }
}

TEST(TurningPoint_analytic, is_found_where_samples_about_it_are_missing) {
  const Clocked whole(0.2, 1);
  for (const int missing : {1, 2, 3}) {
    Clocked few = whole;
    const auto cut = [&](Column& values) {
      const auto at = values.begin() + static_cast<long>(few.turn) - 1;
      values.erase(at, at + missing);
    };
    cut(few.path), cut(few.time);
    few.turn -= 1;
    const auto found = few.found();
    ASSERT_TRUE(found && found->place) << missing;
    EXPECT_NEAR(found->place->displacement, 100, 1e-9);
  }
}

TEST(TurningPoint_behaviour, is_none_after_a_pause_or_where_the_motion_slows_down) {
  Clocked late(0.25, 1);
  for (std::size_t i = late.turn; i < late.time.size(); ++i) late.time[i] += 0.6;
  EXPECT_FALSE(late.found());
  Clocked resting(0.25, 1);
  for (const std::size_t before : {1u, 2u, 3u, 4u})
    resting.path[resting.turn - before] = resting.path[resting.turn - 5];
  EXPECT_FALSE(resting.found());
  Column path, time;
  for (int i = 0; i < 80; ++i) time.push_back(i), path.push_back(std::sin(M_PI * (i + 0.3) / 79.6));
  EXPECT_FALSE(turn_of(path, time, 0, 40, 80));
  const Clocked motion(0.25, 1);
  const auto from = [&](std::size_t begin, std::size_t end) {
    return turn_of(motion.path, motion.time, begin, motion.turn, end).has_value();
  };
  EXPECT_FALSE(from(motion.turn - 3, motion.path.size()));
  EXPECT_FALSE(from(0, motion.turn + 3));
  EXPECT_TRUE(from(motion.turn - 4, motion.turn + 4));
  EXPECT_FALSE(turn_of(motion.path, motion.time, 0, motion.turn - 20, motion.path.size()));  // named far off
}

/// Segments: named by nobody, or the farthest sample for the way there, or for the way back.
enum class Named { nobody, there, back };
Recording loop(double rate, double phase, Named named = Named::nobody) {
  Column time, path;
  std::vector<std::string> segments;
  for (double t = phase / rate; t < 1.6; t += 1 / rate) {
    const double in_cycle = std::fmod(t, 0.8), sooner = named == Named::back ? 1 / rate : 0;
    time.push_back(t);
    path.push_back(1e-6 * (in_cycle < 0.4 ? in_cycle : 0.8 - in_cycle));
    if (named != Named::nobody)
      segments.emplace_back(std::fmod(t + sooner, 0.8) < 0.4 ? "forward" : "backward");
  }
  Recording recording = test::driven(Motion::sliding, path);
  RecordingTable& table = recording.tables[0];
  table.columns["time"] = time;
  table.columns["normal_force"] = Column(path.size(), 1e-4);
  table.columns["lateral_force"] = Column(path.size(), 0.0);
  table.control.emplace_back("normal_force");
  table.segment = segments;
  return recording;
}

TEST(Samples_analytic, count_their_path_from_a_turn_between_them) {
  for (const Named named : {Named::nobody, Named::there, Named::back})
    for (const double phase : {0.1, 0.35, 0.5, 0.8}) {
      const Samples samples = samples_of(loop(100, phase, named));
      for (const Sample& s : samples.list)
        if (s.time > 0.4 && s.time < 1.2) {
          const double turn = s.time < 0.8 ? 400e-9 : 0;
          EXPECT_NEAR(s.since_reversal, std::abs(s.lateral_displacement - turn), 1e-12) << s.time;
          EXPECT_EQ(s.direction, s.time < 0.8 ? -1 : 1) << s.time;
        }
      const auto first = std::find_if(samples.list.begin(), samples.list.end(),
                                      [](const Sample& s) { return s.time > 0.4; });
      ASSERT_TRUE(first->turn);
      EXPECT_NEAR(first->turn->displacement, 400e-9, 1e-14);
      EXPECT_NEAR(first->turn->time, 0.4, 1e-8);
    }
}

Column simulated_forces(const Recording& recording) {
  const Samples samples = samples_of(recording);
  Mechanics mechanics = baseline_mechanics(experiment_of(recording, samples), SimulationChoice{});
  mechanics.lateral.coefficient = 0.3;
  mechanics.lateral.compliance = 1e-3;  // sticks over 60 nm
  return simulate(mechanics, samples);
}

/// Truth: the same motion in steps that are a thousand times finer, so that its turns lie between samples too
/// close to matter.
TEST(Simulate_behaviour, of_a_loop_is_the_same_wherever_samples_lie_about_its_turns) {
  constexpr double fine = 1e5;
  const Column truth = simulated_forces(loop(fine, 0));
  for (const double phase : {0.1, 0.35, 0.5, 0.8})
    for (const Named named : {Named::nobody, Named::there, Named::back}) {
      const Recording coarse = loop(100, phase, named);
      const Column force = simulated_forces(coarse), &time = coarse.tables[0].columns.at("time");
      double largest = 0;
      for (std::size_t i = 0; i < force.size(); ++i)
        if (time[i] > 0.4)  // before, the start of the record counts
          largest =
              std::max(largest, std::abs(force[i] - truth[static_cast<std::size_t>(time[i] * fine + 0.5)]));
      EXPECT_LT(largest, 0.01 * 3e-5) << phase << " " << static_cast<int>(named);  // of the friction
    }
}

}  // namespace
}  // namespace asperity
