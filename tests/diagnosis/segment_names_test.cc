// Segments by name, and what is read off the motion or off forces where names say nothing.
#include "diagnosis/recording/segment_names.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/diagnosis/support/driven_recording.h"

namespace asperity {
namespace {

using test::Column;
using test::driven;
using test::segment_of;
using test::zigzag;

TEST(SegmentNames_behaviour, follow_the_motion_where_names_of_segments_mean_nothing) {
  Column path = zigzag({-1e-8, 5e-8}, 60);
  path.insert(path.end(), 30, 5e-8);
  for (const double x : zigzag({5e-8, -1e-8}, 60)) path.push_back(x);
  Recording recording = driven(Motion::normal, path);
  const auto name_them = [&](const char* up, const char* rest, const char* down) {
    auto& names = recording.tables[0].segment;
    names.assign(61, up), names.insert(names.end(), 30, rest), names.insert(names.end(), 61, down);
  };
  for (const auto& [up, rest, down] :
       {std::tuple{"", "", ""}, std::tuple{"Load", "HOLD", "unload"},
        std::tuple{"approach", "dwell", "retract"}, std::tuple{"1", "2", "3"},
        std::tuple{"load", "load", "unload"}, std::tuple{"load", "pause", ""}}) {
    name_them(up, rest, down);
    const Samples samples = samples_of(recording);
    EXPECT_EQ(segment_of(samples, 30), "load") << up;
    EXPECT_EQ(segment_of(samples, 75), "hold") << rest;
    EXPECT_EQ(samples.list[75].hold, 1) << rest;
    EXPECT_EQ(segment_of(samples, 130), "unload") << down;
  }
  const auto remark = [&] {
    const auto remarks = remarks_on_segments(recording);
    return remarks.empty() ? "" : remarks.at(0);
  };
  EXPECT_EQ(remark().rfind("segments are named 'pause', which is none of load", 0), 0u) << remark();
  name_them("Load", "hold", "UNLOAD");
  EXPECT_EQ(remark(), "");
  for (std::size_t i = 0; i < 9; ++i) recording.tables[0].segment[i] = "s" + std::to_string(i);
  EXPECT_NE(remark().find("'s0', 's1', 's2', 's3', 's4' and others"), std::string::npos) << remark();
}

TEST(SegmentNames_behaviour, of_a_hold_are_those_that_rest_or_those_named_where_any_is) {
  Column path = zigzag({0, 1e-7}, 200);
  path.insert(path.end(), 30, 1e-7);
  for (const double x : zigzag({1e-7, 0}, 200)) path.push_back(x);
  Recording recording = driven(Motion::normal, path);
  const Samples inferred = samples_of(recording);
  EXPECT_EQ(segment_of(inferred, 199), "load");  // within a hundredth of the range, as the hold is
  EXPECT_EQ(segment_of(inferred, 202), "hold");
  EXPECT_EQ(segment_of(inferred, 230), "hold");
  EXPECT_EQ(segment_of(inferred, 232), "unload");
  auto& names = recording.tables[0].segment;
  names.assign(211, "load"), names.insert(names.end(), 10, "hold"), names.insert(names.end(), 211, "unload");
  const Samples named = samples_of(recording);
  for (std::size_t i = 0; i < path.size(); ++i) EXPECT_EQ(segment_of(named, i), names[i]) << i;
}

TEST(SegmentNames_behaviour, rest_off_contact_in_a_segment_named_load_without_a_hold) {
  Column force(60, 0.0);  // driven, though the probe moves
  for (int i = 1; i <= 90; ++i) force.push_back(1e-6 * i);
  Recording recording = driven(Motion::normal, force);
  EXPECT_EQ(segment_of(samples_of(recording), 30), "hold");
  recording.tables[0].segment.assign(force.size(), "load");
  EXPECT_EQ(segment_of(samples_of(recording), 30), "load");
}

TEST(SegmentNames_behaviour, of_a_noisy_hold_are_those_that_rest) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 2e-11);  // a fifth of the way between samples
  Column path = zigzag({0, 2e-8}, 200);
  path.insert(path.end(), 60, 2e-8);
  for (const double x : zigzag({2e-8, 0}, 200)) path.push_back(x);
  for (double& x : path) x += noise(random);
  const Samples samples = samples_of(driven(Motion::normal, path));
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (std::min(std::abs(static_cast<double>(i) - 200.5), std::abs(static_cast<double>(i) - 260.5)) <= 2)
      continue;
    EXPECT_EQ(segment_of(samples, i), i <= 200 ? "load" : i <= 260 ? "hold" : "unload") << i;
  }
}

TEST(SegmentNames_behaviour, of_a_series_without_names_go_the_way_that_friction_says) {
  Recording recording = driven(Motion::sliding, {0, 0, 0, 0, 0, 0});
  auto& table = recording.tables[0];
  table.kind = TableKind::series;
  table.control = {"normal_force"};
  table.columns["normal_force"] = {3e-3, 3e-3, 3e-5, 3e-5, 1e-3, 0};
  table.columns["lateral_force"] = {9e-4, -9e-4, 9e-6, -9e-6, NAN, -1e-7};
  const auto directions = [&] {
    std::vector<int> all;
    for (const auto& s : samples_of(recording).list) all.push_back(s.direction);
    return all;
  };
  EXPECT_EQ(directions(), (std::vector<int>{1, -1, 1, -1, 1, 1}));
  EXPECT_EQ(remarks_on_segments(recording).at(0),
            "2 of 6 rows of 't.csv' have a lateral force below zero and no name of a direction: they were "
            "taken for "
            "motion backward");
  // Beside the usual ratio of 0.3, 0.29 and 0.31 of it.
  table.columns["lateral_force"][2] = -0.3 * 0.29 * 3e-5;
  EXPECT_EQ(directions()[2], 1);
  table.columns["lateral_force"][2] = -0.3 * 0.31 * 3e-5;
  EXPECT_EQ(directions()[2], -1);
  table.segment = {"forward", "", "", "backward", "", ""};  // who names some means them
  EXPECT_EQ(directions(), (std::vector<int>{1, 1, 1, -1, 1, 1}));
  EXPECT_TRUE(remarks_on_segments(recording).empty());
}

}  // namespace
}  // namespace asperity
