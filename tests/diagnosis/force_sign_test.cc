// Which recordings have a lateral force and displacement that are positive in opposite directions.
#include "diagnosis/recording/force_sign.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/import/import.h"
#include "tests/diagnosis/support/made_recording.h"
#include "tests/support/shared_files.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

/// Sliding at a force of `up` while the displacement rises, and of `down` on the way back [uN]; in one
/// direction alone where there is no `down`.
Recording slid(double up, std::optional<double> down, double alternating = 0) {
  Recording recording;
  recording.mode = Motion::sliding;
  recording.particle = test::borosilicate(), recording.substrate = test::silicon();
  RecordingTable table;
  table.file = "loop.csv";
  table.control = {"lateral_displacement", "normal_force"};
  table.response = "lateral_force";
  const auto row = [&](int i, double x, double force) {
    table.columns["lateral_displacement"].push_back(x * 1e-9);
    table.columns["normal_force"].push_back(1e-3);
    table.columns["lateral_force"].push_back(1e-6 * (force + (i % 2 == 0 ? alternating : -alternating)));
  };
  for (int i = 0; i < 40; ++i) row(i, i, up);
  if (down)
    for (int i = 0; i < 40; ++i) row(i, 39 - i, *down);
  recording.tables = {table};
  return recording;
}

bool is_turned(Recording recording) {
  const double before = recording.tables[0].columns["lateral_displacement"][20];
  turn_signs_to_dissipate(recording);
  const bool turned = recording.tables[0].columns["lateral_displacement"][20] == -before;
  EXPECT_EQ(recording.remarks.size(), turned ? 1U : 0U);
  return turned;
}

TEST(ForceSign_analytic, is_turned_where_a_loop_would_give_energy) {
  EXPECT_FALSE(is_turned(slid(2, -2)));
  EXPECT_TRUE(is_turned(slid(-2, 2)));
  EXPECT_TRUE(is_turned(slid(3, 7)));  // a constant force is added
  EXPECT_FALSE(is_turned(slid(7, 3)));
}

TEST(ForceSign_analytic, stays_where_scatter_hides_it) {
  // Two means of 40 samples, 40 apart, about a drift as fits best: the standard deviation of their difference
  // is sqrt(2/40 + 40^2/(2 40^3/12)) = 0.447 of the scatter s, and five of it are asked. Signs in turn have a
  // drift of -40 s/(2 40^3/12) of their own, so that 4 + 0.15 s meets 2.24 s at 1.917.
  EXPECT_TRUE(is_turned(slid(-2, 2, 1.9)));
  EXPECT_FALSE(is_turned(slid(-2, 2, 1.95)));
}

TEST(ForceSign_analytic, is_told_beside_a_drift_of_the_force_and_a_tilt) {
  const auto with = [](double friction, double drift, double tilt) {
    Recording loop = slid(friction, -friction);
    auto& force = loop.tables[0].columns["lateral_force"];
    const auto& path = loop.tables[0].column("lateral_displacement");
    for (std::size_t i = 0; i < force.size(); ++i)
      force[i] += 1e-6 * drift * static_cast<double>(i) / 80 + 1e-6 * tilt * path[i] / 39e-9;
    return loop;
  };
  for (const double drift : {-20.0, 20.0}) {  // ten times the friction over the loop
    EXPECT_FALSE(is_turned(with(2, drift, 0))) << drift;
    EXPECT_TRUE(is_turned(with(-2, drift, 0))) << drift;
    EXPECT_FALSE(is_turned(with(0, drift, 0))) << drift;
  }
  for (const double tilt : {-5.0, 5.0}) {
    EXPECT_FALSE(is_turned(with(2, 0, tilt))) << tilt;
    EXPECT_TRUE(is_turned(with(-2, 0, tilt))) << tilt;
  }
}

TEST(ForceSign_analytic, of_motion_in_one_direction_is_told_only_against_its_name) {
  Recording one = slid(-2, {});
  EXPECT_FALSE(is_turned(one));  // an offset may make it negative
  one.tables[0].segment.assign(40, "backward");
  EXPECT_TRUE(is_turned(one));
  one.tables[0].segment.assign(40, "forward");
  EXPECT_FALSE(is_turned(one));
  one = slid(2, {});
  one.tables[0].segment.assign(40, "backward");  // a stage that counts down, its force along the motion
  EXPECT_FALSE(is_turned(one));
}

TEST(ForceSign_behaviour, is_that_of_most_runs_and_the_others_are_counted) {
  Recording recording = slid(-2, 2);
  RecordingTable& table = recording.tables[0];
  table.columns["run"].assign(80, 1);
  const auto add_run = [&](int number, const Recording& run) {
    for (const auto& [name, values] : run.tables[0].columns)
      table.columns[name].insert(table.columns[name].end(), values.begin(), values.end());
    table.columns["run"].insert(table.columns["run"].end(), 80, number);
  };
  add_run(2, slid(2, -2));
  Recording undecided = recording;
  turn_signs_to_dissipate(undecided);
  EXPECT_EQ(undecided.tables[0].column("lateral_displacement")[20], 20e-9);
  ASSERT_EQ(undecided.remarks.size(), 1U);
  EXPECT_NE(undecided.remarks[0].find("in 1 of 2 runs"), std::string::npos) << undecided.remarks[0];
  add_run(3, slid(-2, 2));
  turn_signs_to_dissipate(recording);
  EXPECT_EQ(table.column("lateral_displacement")[20], -20e-9);
  ASSERT_EQ(recording.remarks.size(), 2U);
  EXPECT_NE(recording.remarks[1].find("in 1 of 3 runs"), std::string::npos) << recording.remarks[1];
}

TEST(ForceSign_analytic, is_not_told_by_chance) {
  Recording few = slid(-2, 2, 1.5);
  EXPECT_TRUE(is_turned(few));
  for (auto& [name, values] : few.tables[0].columns) values.erase(values.begin() + 6, values.end() - 6);
  const Recording as_given = few;
  turn_signs_to_dissipate(few);  // 6 and 6 samples: 2.3 standard deviations
  EXPECT_EQ(few.tables[0].columns, as_given.tables[0].columns);
}

TEST(ForceSign_behaviour, of_positions_along_a_line_is_that_of_the_segments_names) {
  const auto image = [](double forward, double backward) {
    Recording both = slid(forward, backward);
    auto& path = both.tables[0].columns["lateral_displacement"];
    for (std::size_t i = 40; i < 80; ++i) path[i] = path[i - 40];
    both.tables[0].segment.assign(40, "forward");
    both.tables[0].segment.insert(both.tables[0].segment.end(), 40, "backward");
    return both;
  };
  EXPECT_FALSE(is_turned(image(2, -2)));
  Recording turned = image(-2, 2);
  turn_signs_to_dissipate(turned);
  EXPECT_EQ(turned.tables[0].column("lateral_displacement")[20], 20e-9);
  EXPECT_EQ(turned.tables[0].column("lateral_force")[20], 2e-6);
  ASSERT_EQ(turned.remarks.size(), 1U);
  EXPECT_NE(turned.remarks[0].find("sign of the force is turned"), std::string::npos) << turned.remarks[0];
}

TEST(ForceSign_behaviour, is_turned_in_reading_and_said_in_the_recording) {
  const test::TemporaryFolder folder;
  Recording loop = slid(-2, 2);
  for (std::size_t i = 0; i < loop.tables[0].rows(); ++i)
    loop.tables[0].columns["time"].push_back(static_cast<double>(i));
  write_recording(loop, folder.path);
  const Recording read = read_recording(folder.path);
  EXPECT_EQ(read.tables[0].column("lateral_displacement")[20], -20e-9);
  EXPECT_EQ(read.tables[0].column("lateral_force")[20], -2e-6);
  ASSERT_EQ(read.remarks.size(), 1U);
  EXPECT_NE(read.remarks[0].find("loop.csv"), std::string::npos);
}

/// A friction image of a polymer blend, whose lateral channel is larger on the way back.
TEST(ForceSign_other_code, of_a_measured_friction_image_follows_from_its_loops) {
  ASPERITY_SHARED_FILE_OR_SKIP(file, "recordings/lfm_SBS-PMMA_loops_32lines.csv");
  for (const char* sign : {"", "-1 * "}) {
    ImportOptions options;
    options.mode = Motion::sliding;
    options.radius = 10e-9, options.substrate_modulus = 3e9, options.substrate_poisson = 0.4;
    options.columns = {"run = line", "lateral_displacement [um] = x_um",
                       std::string("lateral_force:forward [nN] = ") + sign + "lateral_fwd_V",
                       std::string("lateral_force:backward [nN] = ") + sign + "lateral_bwd_V",
                       "normal_force [nN] = 20"};
    Recording recording = import_recording(file, options);
    const std::vector<double> before = recording.tables[0].column("lateral_displacement");
    turn_signs_to_dissipate(recording);
    const bool turns = std::string(sign).empty();
    EXPECT_EQ(recording.remarks.size(), turns ? 1U : 0U);
    EXPECT_EQ(recording.tables[0].column("lateral_displacement")[5], (turns ? -1 : 1) * before[5]);
  }
}

}  // namespace
}  // namespace asperity
