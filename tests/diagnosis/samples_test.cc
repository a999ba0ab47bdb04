// What follows from the control alone: segments, directions, holds, cycles, speeds; and which samples are
// kept when thinned.
#include "diagnosis/recording/samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "diagnosis/import/segments.h"
#include "diagnosis/recording/experiment.h"
#include "diagnosis/recording/probe_jumps.h"
#include "diagnosis/recording/time_from_path.h"
#include "tests/diagnosis/support/driven_recording.h"

namespace asperity {
namespace {

using test::Column;
using test::driven;
using test::segment_of;
using test::zigzag;

TEST(Samples_analytic, of_a_loop_know_their_direction_and_path_since_the_turn) {
  const Samples samples = samples_of(driven(Motion::sliding, zigzag({0, 1e-7, -1e-7, 1e-7, -1e-7}, 40)));
  ASSERT_EQ(samples.list.size(), 161u);
  ASSERT_EQ(samples.runs.size(), 1u);
  for (const auto& [i, direction, since, segment] :
       {std::tuple{20u, 1, 0.5e-7, "forward"}, std::tuple{60u, -1, 1e-7, "backward"},
        std::tuple{100u, 1, 1e-7, "forward"}, std::tuple{150u, -1, 1.5e-7, "backward"}}) {
    EXPECT_EQ(samples.list[i].direction, direction) << i;
    EXPECT_NEAR(samples.list[i].since_reversal, since, 0.06e-7) << i;  // within a step
    EXPECT_EQ(segment_of(samples, i), segment) << i;
  }
  // A cycle begins where the first direction comes back.
  EXPECT_EQ(samples.list[60].cycle, 0);
  EXPECT_EQ(samples.list[100].cycle, 1);
  EXPECT_EQ(samples.list[160].cycle, 1);
  EXPECT_NEAR(samples.list[60].cycles_passed, 2.0 / 3, 0.02);  // 2e-7 of 3e-7
  EXPECT_NEAR(samples.list[160].cycles_passed, 2, 1e-12);
}

TEST(Samples_analytic, count_the_cycles_of_a_run_that_begins_and_ends_within_one_by_its_path) {
  const Samples samples =
      samples_of(driven(Motion::sliding, zigzag({0, 1e-7, -1e-7, 1e-7, -1e-7, 1e-7, -1e-7, 0}, 40)));
  // By segments three quarters, two whole ones and a half; in a cycle 4e-7 of path.
  for (const auto& [i, cycles] : {std::pair{0u, 0.0},
                                  {40u, 0.25},
                                  {80u, 0.75},
                                  {120u, 1.25},
                                  {160u, 1.75},
                                  {200u, 2.25},
                                  {240u, 2.75},
                                  {280u, 3.0}})
    EXPECT_NEAR(samples.list[i].cycles_passed, cycles, 0.01) << i;
}

TEST(Samples_analytic, of_a_lateral_trace_without_time_take_path_over_speed) {
  const Column path = zigzag({0, 1e-7, -1e-7, 1e-7}, 40);
  Recording recording = driven(Motion::sliding, path);
  auto& columns = recording.tables[0].columns;
  columns.erase("time");
  EXPECT_FALSE(experiment_of(recording, samples_of(recording)).has_time);
  ASSERT_EQ(remarks_on_time(recording).size(), 1u);
  EXPECT_NE(remarks_on_time(recording)[0].find("no effect that passes with time"), std::string::npos);
  for (std::size_t i = 0; i < path.size(); ++i) columns["speed"].push_back(i < 80 ? 1e-6 : 4e-6);
  const Samples samples = samples_of(recording);
  EXPECT_TRUE(experiment_of(recording, samples).has_time);
  EXPECT_NEAR(samples.list[40].time, 0.1, 0.002);
  EXPECT_NEAR(samples.list[79].time, 0.3, 0.006);
  EXPECT_NEAR(samples.list[120].time, 0.35, 0.006);
  EXPECT_NE(remarks_on_time(recording)[0].find("path over speed"), std::string::npos);
  Recording mixed = recording;  // one table knows its times, the other does not
  mixed.tables.push_back(recording.tables[0]);
  mixed.tables[1].columns.erase("speed");
  EXPECT_FALSE(experiment_of(mixed, samples_of(mixed)).has_time);
  columns["speed"][60] = 0;  // it rests, one does not know how long
  EXPECT_FALSE(experiment_of(recording, samples_of(recording)).has_time);
}

TEST(Samples_analytic, of_an_approach_with_a_hold_are_parted_there) {
  Column path = zigzag({-1e-8, 5e-8}, 60);
  path.insert(path.end(), 30, 5e-8);
  for (const double x : zigzag({5e-8, -1e-8}, 60)) path.push_back(x);
  Recording recording = driven(Motion::normal, path);
  auto& time = recording.tables[0].columns["time"];
  for (std::size_t i = 0; i < path.size(); ++i) time.push_back(0.5 * static_cast<double>(i));
  const Samples samples = samples_of(recording);
  EXPECT_EQ(segment_of(samples, 30), "load");
  EXPECT_EQ(segment_of(samples, 75), "hold");
  EXPECT_EQ(segment_of(samples, 130), "unload");
  EXPECT_EQ(samples.list[30].direction, 1);
  EXPECT_EQ(samples.list[75].direction, 1);
  EXPECT_EQ(samples.list[130].direction, -1);
  EXPECT_EQ(samples.list[30].hold, 0);
  EXPECT_EQ(samples.list[75].hold, 1);
  EXPECT_EQ(samples.list[30].hold_time, 0);
  EXPECT_NEAR(samples.list[80].hold_time - samples.list[70].hold_time, 5, 1e-12);
  EXPECT_NEAR(samples.list[75].hold_time, 7.5, 0.51);
  EXPECT_EQ(samples.list[130].hold_time, 0);
  EXPECT_EQ(samples.list[75].speed, 0);  // of approach there is none
}

TEST(Samples_analytic, have_the_speed_of_their_path_and_time_unless_it_was_recorded) {
  Recording recording = driven(Motion::sliding, zigzag({0, 1e-7, 0}, 50));
  const std::size_t rows = recording.tables[0].rows();
  EXPECT_EQ(samples_of(recording).list[20].speed, 0);  // without time there is none
  auto& time = recording.tables[0].columns["time"];
  for (std::size_t i = 0; i < rows; ++i)
    time.push_back(i < 50 ? 1e-3 * static_cast<double>(i) : 0.05 + 1e-4 * static_cast<double>(i - 50));
  const Samples measured = samples_of(recording);
  EXPECT_NEAR(measured.list[0].speed, 2e-6, 1e-12);
  EXPECT_NEAR(measured.list[20].speed, 2e-6, 1e-12);
  EXPECT_NEAR(measured.list[80].speed, 2e-5, 1e-11);
  EXPECT_NEAR(measured.list[rows - 1].speed, 2e-5, 1e-11);
  recording.tables[0].columns["speed"] = Column(rows, 3e-6);
  EXPECT_EQ(samples_of(recording).list[20].speed, 3e-6);
  Recording normal = driven(Motion::normal, zigzag({0, 1e-7, 0}, 50));
  normal.tables[0].columns["time"] = time;
  EXPECT_EQ(samples_of(normal).list[20].speed, 0);
}

TEST(Samples_analytic, have_the_same_speed_by_a_clock_that_stands_still_between_ticks) {
  Recording recording = driven(Motion::sliding, zigzag({0, 1e-7, 0}, 50));
  const std::size_t rows = recording.tables[0].rows();
  auto& time = recording.tables[0].columns["time"];
  for (std::size_t i = 0; i < rows; ++i) time.push_back(0.005 * std::floor(static_cast<double>(i) / 5));
  const Samples measured = samples_of(recording);
  for (const std::size_t i : {0u, 20u, 80u, 96u}) EXPECT_NEAR(measured.list[i].speed, 2e-6, 1e-12) << i;
  time.assign(rows, 1.0);
  EXPECT_EQ(samples_of(recording).list[20].speed, 0);
}

TEST(Samples_analytic, have_the_rate_of_their_approach_in_spite_of_noise) {
  constexpr double noise = 0.2e-9, step = 2e-10, interval = 1e-3;  // as large as a step of the path
  Column path = zigzag({0, 400 * step, 0}, 400);
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (double& x : path) x += noise * normal(random);
  Recording recording = driven(Motion::normal, path);
  const Samples without_time = samples_of(recording);
  EXPECT_EQ(without_time.list[200].approach, 0);
  auto& time = recording.tables[0].columns["time"];
  for (std::size_t i = 0; i < path.size(); ++i) time.push_back(interval * static_cast<double>(i));
  const Samples samples = samples_of(recording);
  for (const std::size_t i : {30u, 200u, 370u}) {
    EXPECT_NEAR(samples.list[i].approach, step / interval, 0.15 * step / interval) << i;
    EXPECT_NEAR(samples.list[i + 400].approach, -step / interval, 0.15 * step / interval) << i;
  }
  EXPECT_NEAR(experiment_of(recording, samples).fastest_approach, step / interval, 0.15 * step / interval);
}

TEST(Samples_analytic, are_off_contact_beyond_a_fiftieth_of_the_depth) {
  const auto off_contact = [](double from) {
    const Recording recording = driven(Motion::normal, zigzag({from, 1.1e-7, from}, 100));
    return experiment_of(recording, samples_of(recording)).samples_off_contact;
  };
  EXPECT_EQ(off_contact(0), 0u);
  EXPECT_EQ(off_contact(-2e-9), 0u);  // noise of the displacement goes as far
  // Steps of 2.1 nm, the first 47 of which end below -2.2 nm, on each way.
  EXPECT_EQ(off_contact(-1e-7), 2 * 47u);
}

TEST(Samples_analytic, in_which_the_probe_jumps_do_not_count) {
  constexpr double step = 1e-9;
  const auto with_faster = [&](int faster, double times) {
    Column path{0};
    for (int i = 1; i <= 1000; ++i)
      path.push_back(path.back() - (i > 500 && i <= 500 + faster ? times * step : step));
    Recording recording = driven(Motion::normal, path);
    auto& time = recording.tables[0].columns["time"];
    for (std::size_t i = 0; i < path.size(); ++i) time.push_back(1e-3 * static_cast<double>(i));
    return samples_of(recording);
  };
  Samples jumps = with_faster(12, 10), steady = with_faster(12, 1.5), driven_faster = with_faster(100, 10);
  const std::size_t marked = mark_probe_jumps(jumps);
  EXPECT_GE(marked, 12u);
  EXPECT_LE(marked, 14u);  // and those beside them
  EXPECT_FALSE(jumps.list[506].counts);
  EXPECT_TRUE(jumps.list[490].counts && jumps.list[520].counts);
  EXPECT_EQ(mark_probe_jumps(steady), 0u);
  EXPECT_EQ(mark_probe_jumps(driven_faster), 0u);
}

TEST(Samples_behaviour, without_the_load_or_speed_that_their_table_gives_do_not_count) {
  Recording recording = driven(Motion::sliding, zigzag({0, 1e-7, 0}, 50));
  auto& columns = recording.tables[0].columns;
  for (const char* channel : {"normal_force", "speed", "radius", "rms_roughness", "rail_angle"}) {
    columns[channel].assign(101, 1e-4);
    columns[channel][7] = NAN;
    EXPECT_FALSE(samples_of(recording).list[7].counts) << channel;
    EXPECT_TRUE(samples_of(recording).list[8].counts) << channel;
    columns[channel].assign(101, NAN);  // a column without a value says nothing
    EXPECT_TRUE(samples_of(recording).list[7].counts) << channel;
    columns.erase(channel);
  }
}

TEST(Samples_behaviour, of_a_noisy_motion_turn_where_the_motion_does) {
  std::mt19937 random(5);
  for (const double noise : {1e-9, 3e-9}) {  // 10 standard deviations: 10 and 30 % of the range
    std::normal_distribution<double> normal(0, noise);
    Column path = zigzag({0, 1e-7, -1e-7, 1e-7}, 4000);
    path.insert(path.end(), 4000, 1e-7);
    for (double& x : path) x += normal(random);
    const Samples samples = samples_of(driven(Motion::sliding, path));
    EXPECT_EQ(samples.parts, 4) << noise;
    EXPECT_EQ(segment_of(samples, 14000), "hold") << noise;
    const FoundSegments found = find_segments(path);
    int changes = 0;
    for (std::size_t i = 1; i < path.size(); ++i) changes += found.segment[i] != found.segment[i - 1];
    EXPECT_LE(changes, 6) << noise;
  }
}

TEST(Samples_behaviour, do_not_take_jitter_below_a_fiftieth_of_the_range_for_a_turn) {
  Column path = zigzag({0, 1e-7, 0}, 100);
  for (std::size_t i = 0; i < path.size(); i += 2) path[i] += 0.9e-9;
  const Samples quiet = samples_of(driven(Motion::normal, path));
  EXPECT_EQ(quiet.parts, 2);
  path = zigzag({0, 0.5e-7, 0.46e-7, 1e-7, 0}, 100);
  EXPECT_EQ(samples_of(driven(Motion::normal, path)).parts, 4);
}

TEST(Samples_behaviour, go_the_way_their_segment_is_named_for_or_else_that_of_its_ends) {
  Recording recording = driven(Motion::sliding, zigzag({0, 1e-7, 0}, 50));
  auto& names = recording.tables[0].segment;
  const auto directions = [&](const char* first, const char* second) {
    names.assign(51, first);
    names.insert(names.end(), 50, second);
    const Samples samples = samples_of(recording);
    return std::pair{samples.list[20].direction, samples.list[80].direction};
  };
  EXPECT_EQ(directions("out", "home"), (std::pair{1, -1}));
  EXPECT_EQ(directions("unload", "load"), (std::pair{-1, 1}));
  EXPECT_EQ(directions("unload", "hold"), (std::pair{-1, -1}));  // a hold keeps what led to it
  EXPECT_EQ(directions("hold", "home"), (std::pair{1, -1}));
  EXPECT_EQ(directions("forward", "backward"), (std::pair{1, -1}));
  EXPECT_EQ(directions("backward", "forward"), (std::pair{1, -1}));  // a stage that counts down
  auto& path = recording.tables[0].columns["lateral_displacement"];
  for (std::size_t i = 51; i < path.size(); ++i) path[i] = 1e-7 - 0.01e-7 * static_cast<double>(i % 2);
  EXPECT_EQ(directions("backward", "forward"), (std::pair{1, -1}));  // the second jitters where it is
  for (std::size_t i = 51; i < path.size(); ++i) path[i] = path[i - 51];
  EXPECT_EQ(directions("forward", "backward"), (std::pair{1, -1}));  // positions along a line
  for (double& x : path) x = -x;
  EXPECT_EQ(directions("forward", "backward"), (std::pair{1, -1}));
}

TEST(Samples_behaviour, of_several_runs_each_begin_anew_and_count_cycles_from_zero) {
  Recording recording = driven(Motion::sliding, Column(40, 0.0));
  auto& table = recording.tables[0];
  for (int i = 0; i < 40; ++i) {
    table.columns["lateral_displacement"][static_cast<std::size_t>(i)] = 1e-9 * (i / 2);
    table.columns["run"].push_back(i % 2 ? 9 : 4);  // rows of both runs in turn
    table.columns["cycle"].push_back(i % 2 ? 3 : 1);
  }
  table.columns["lateral_force"][6] = NAN;
  const Samples samples = samples_of(recording);
  ASSERT_EQ(samples.runs.size(), 2u);
  EXPECT_EQ(samples.runs[0].number, 4);
  EXPECT_EQ(samples.runs[1].number, 9);
  EXPECT_EQ(samples.runs[1].begin, 20u);
  EXPECT_EQ(samples.runs[1].end, 40u);
  EXPECT_EQ(samples.list[3].row, 6);
  EXPECT_FALSE(samples.list[3].counts);
  EXPECT_TRUE(samples.list[23].counts);
  EXPECT_EQ(samples.list[23].row, 7);
  EXPECT_EQ(samples.list[23].cycle, 0);
  EXPECT_EQ(samples.list[23].index, 23u);
}

TEST(Samples_behaviour, of_a_series_are_rows_on_their_own_that_may_name_their_direction) {
  Recording recording = driven(Motion::rolling, {0, 0, 0});
  auto& table = recording.tables[0];
  table.kind = TableKind::series;
  table.control = {"normal_force"};
  table.columns["normal_force"] = {3e-3, 1e-3, 2e-3};
  table.columns["radius"] = {4e-6, NAN, 8e-6};
  table.columns["lateral_force_sd"] = {1e-7, 2e-7, NAN};
  table.segment = {"forward", "backward", ""};
  recording.rail_angle = 0.3;
  const Samples samples = samples_of(recording);
  EXPECT_TRUE(samples.runs[0].independent_rows);
  EXPECT_EQ(samples.list[2].part, samples.list[0].part);
  EXPECT_EQ(samples.list[0].direction, 1);
  EXPECT_EQ(samples.list[1].direction, -1);
  EXPECT_EQ(samples.list[2].direction, 1);
  EXPECT_EQ(segment_of(samples, 2), "series");
  EXPECT_EQ(samples.list[0].radius, 4e-6);
  EXPECT_EQ(samples.list[1].radius, 8.5e-6);
  EXPECT_EQ(samples.list[1].sd, 2e-7);
  EXPECT_EQ(samples.list[2].sd, 0);
  EXPECT_EQ(samples.list[0].rail_angle, 0.3);
  EXPECT_EQ(samples.list[0].rms_roughness, 0.3e-9);
}

TEST(Samples_behaviour, thinned_keep_ends_and_four_times_as_many_after_a_turn) {
  const Samples all = samples_of(driven(Motion::sliding, zigzag({0, 1e-7, 0}, 1000)));
  const Samples few = thinned(all, 200);
  EXPECT_NEAR(static_cast<double>(few.list.size()), 200, 12);
  EXPECT_EQ(few.runs[0].end, few.list.size());
  EXPECT_EQ(few.list.front().index, 0u);
  EXPECT_EQ(few.list.back().index, 2000u);
  std::size_t begin = 0, rest = 0;  // of the second half
  for (const auto& s : few.list) {
    if (s.direction > 0) continue;
    ++(s.since_reversal < 0.15e-7 ? begin : rest);
  }
  // 0.15 of the path with four times the density of the other 0.85.
  EXPECT_NEAR(static_cast<double>(begin) / static_cast<double>(rest), 4 * 0.15 / 0.85, 0.1);
  EXPECT_EQ(thinned(all, 2001).list.size(), 2001u);
}

TEST(Samples_behaviour, thinned_stay_in_their_runs) {
  Recording recording = driven(Motion::sliding, zigzag({0, 1e-7, 0, 1e-7, 0}, 250));
  for (int i = 0; i <= 1000; ++i) recording.tables[0].columns["run"].push_back(i > 500);
  const Samples few = thinned(samples_of(recording), 100);
  ASSERT_EQ(few.runs.size(), 2u);
  EXPECT_EQ(few.runs[0].end, few.runs[1].begin);
  for (std::size_t r = 0; r < 2; ++r)
    for (std::size_t i = few.runs[r].begin; i < few.runs[r].end; ++i)
      EXPECT_EQ(few.list[i].index > 500, r == 1);
}

TEST(Experiment_analytic, knows_the_sizes_of_a_trace) {
  Recording recording = driven(Motion::sliding, zigzag({0, 1e-7, -1e-7, 1e-7}, 100));
  auto& table = recording.tables[0];
  table.columns["normal_force"] = Column(table.rows(), 2e-3);
  table.columns["lateral_force"][7] = -5e-4;
  table.columns["lateral_force"][9] = 4e-4;
  for (std::size_t i = 0; i < table.rows(); ++i)
    table.columns["time"].push_back(5 + 0.01 * static_cast<double>(i));
  recording.particle.yield_stress = 2e9, recording.substrate.yield_stress = 1e9;
  const Samples samples = samples_of(recording);
  const Experiment e = experiment_of(recording, samples);
  EXPECT_NEAR(e.stroke, 2e-7, 1e-12);
  EXPECT_NEAR(e.duration, 3, 1e-9);
  EXPECT_EQ(e.largest_force, 2e-3);
  EXPECT_EQ(e.smallest_force, 2e-3);
  EXPECT_EQ(e.typical_force, 2e-3);
  EXPECT_EQ(e.largest_response, 5e-4);
  EXPECT_EQ(e.yield_hint, 1e9);
  EXPECT_EQ(e.cycles, 2);
  EXPECT_TRUE(e.has_trace && e.has_time && e.has_both_directions);
  EXPECT_FALSE(e.has_series || e.has_unloading || e.has_off_contact);
  EXPECT_NEAR(e.largest_displacement, e.hertz().approach(2e-3), 1e-20);
  EXPECT_NEAR(e.slowest, 1e-7, 1e-10);
  EXPECT_NEAR(e.fastest, 2e-7, 1e-10);
}

TEST(Experiment_analytic, knows_the_sizes_of_an_approach) {
  Recording recording = driven(Motion::normal, zigzag({-1e-8, 5e-8, -1e-8}, 100));
  auto& force = recording.tables[0].columns["normal_force"];
  for (std::size_t i = 0; i < force.size(); ++i)
    force[i] = i == 100 ? 3e-4 : i == 150 ? -4e-5 : i < 20 ? 0 : 1e-4;
  Experiment e = experiment_of(recording, samples_of(recording));
  EXPECT_EQ(e.largest_force, 3e-4);
  EXPECT_EQ(e.smallest_force, 1e-4);
  EXPECT_EQ(e.typical_force, 1e-4);
  EXPECT_EQ(e.largest_response, 3e-4);
  EXPECT_NEAR(e.largest_displacement, 5e-8, 1e-20);
  EXPECT_TRUE(e.has_unloading && e.has_off_contact);
  EXPECT_EQ(e.hold_duration, 0);
  EXPECT_EQ(e.yield_hint, 0);
  // One direction alone.
  recording = driven(Motion::normal, zigzag({0, 5e-8}, 100));
  e = experiment_of(recording, samples_of(recording));
  EXPECT_FALSE(e.has_unloading || e.has_both_directions || e.has_off_contact);
}

TEST(FoundSegments_analytic, do_not_depend_on_the_zero_nor_the_unit_of_the_signal) {
  std::vector<double> signal = zigzag({0, 1}, 100);
  signal.insert(signal.end(), 40, 1.0);
  for (const double x : zigzag({1, 0}, 100)) signal.push_back(x);
  for (const double x : zigzag({0, 1, 0}, 100)) signal.push_back(x);
  for (const auto& [zero, unit] : {std::pair{0.0, 1.0}, std::pair{5.0, 1.0}, std::pair{-5.0, 1e-9}}) {
    std::vector<double> given;
    for (const double x : signal) given.push_back(unit * (x + zero));
    const FoundSegments found = find_segments(given);
    EXPECT_EQ(found.segment[50], "load") << zero;
    EXPECT_EQ(found.segment[120], "hold") << zero;
    EXPECT_EQ(found.segment[190], "unload") << zero;
    EXPECT_EQ(found.segment[300], "load") << zero;
    EXPECT_EQ(found.segment[400], "unload") << zero;
    EXPECT_EQ(found.cycle[190], 0) << zero;
    EXPECT_EQ(found.cycle[300], 1) << zero;
    EXPECT_EQ(found.cycle[400], 1) << zero;
  }
}

}  // namespace
}  // namespace asperity
