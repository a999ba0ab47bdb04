// Reading, refusing and writing recordings.
#include "diagnosis/recording/recording.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

std::string head(const std::string& extra = "") {
  return R"json({"format": "asperity-recording/1", "title": "loops", "mode": "sliding",
 "particle": {"material": "borosilicate", "youngs_modulus": "71 GPa", "poissons_ratio": 0.17,
     "radius": "8.5 um", "rms_roughness": "0.7 nm"},
 "substrate": {"material": "Si(100)", "youngs_modulus": "179 GPa", "poissons_ratio": 0.25},)json" +
         extra + R"json(
 "tables": [{"file": "loops.csv", "kind": "trace", "control": ["lateral_displacement", "normal_force"],
     "response": "lateral_force"}]})json";
}

std::string rows(const std::string& header, const std::string& odd_row = "", int odd_at = -1) {
  std::string text = header + "\n";
  for (int i = 0; i < 30; ++i)
    text += i == odd_at ? odd_row + "\n"
                        : std::to_string(0.1 * i) + "," + std::to_string(i) + ",100," +
                              std::to_string(0.5 * i) + ",forward\n";
  return text;
}

const std::string header = "time [s],lateral_displacement [nm],normal_force [uN],lateral_force [uN],segment";

std::string refusal(const std::string& json, const std::string& csv) {
  const test::TemporaryFolder folder;
  folder.write("recording.json", json);
  folder.write("loops.csv", csv);
  return test::message_of<InputError>([&] { read_recording(folder.path); });
}

#define EXPECT_IN(part, whole) EXPECT_NE((whole).find(part), std::string::npos) << (whole)

TEST(Recording_behaviour, is_read_in_SI_units_with_missing_cells_as_nan) {
  const test::TemporaryFolder folder;
  folder.write("recording.json", head(
                                     R"("noise": {"lateral_force": "0.2 uN"},
              "simulation": {"parameters": {"sliding_friction": {"value": 0.23, "calibrate": true}}},)"));
  folder.write("loops.csv", "# a remark\n" + rows(header, "0.45,4.5,100,,hold", 5));
  const Recording recording = read_recording(folder.path);
  EXPECT_EQ(recording.mode, Motion::sliding);
  EXPECT_DOUBLE_EQ(recording.particle.radius, 8.5e-6);
  EXPECT_DOUBLE_EQ(recording.substrate.youngs_modulus, 179e9);
  EXPECT_DOUBLE_EQ(recording.noise.at("lateral_force"), 0.2e-6);
  EXPECT_TRUE(recording.simulation.parameters.at("sliding_friction").calibrate);
  const RecordingTable& table = recording.tables.front();
  ASSERT_EQ(table.rows(), 30u);
  EXPECT_DOUBLE_EQ(table.column("lateral_displacement")[7], 7e-9);
  EXPECT_DOUBLE_EQ(table.column("lateral_force")[4], 2e-6);
  EXPECT_TRUE(std::isnan(table.column("lateral_force")[5]));
  EXPECT_EQ(table.segment[5], "hold");
}

TEST(Recording_behaviour, comes_back_from_its_file_as_it_was) {
  const test::TemporaryFolder folder;
  folder.write("recording.json", head(R"("noise": {"lateral_force": "0.2 uN"},)"));
  folder.write("loops.csv", rows(header, "0.45,4.5,100,,hold", 5));
  const Recording first = read_recording(folder.path);
  write_recording(first, folder.path / "again");
  const Recording second = read_recording(folder.path / "again");
  EXPECT_EQ(second.title, first.title);
  EXPECT_EQ(second.simulation_is_given, first.simulation_is_given);
  EXPECT_EQ(second.noise, first.noise);
  EXPECT_EQ(second.tables[0].control, first.tables[0].control);
  EXPECT_EQ(second.tables[0].segment, first.tables[0].segment);
  for (const auto& [channel, values] : first.tables[0].columns)
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (std::isnan(values[i]))
        EXPECT_TRUE(std::isnan(second.tables[0].column(channel)[i]));
      else
        EXPECT_NEAR(second.tables[0].column(channel)[i], values[i], 1e-9 * std::abs(values[i]));
    }
}

TEST(Recording_behaviour, refuses_a_text_where_a_number_belongs_naming_the_line) {
  const std::string message = refusal(head(), rows(header, "0.45,4.5,much,2,forward", 5));
  EXPECT_IN("loops.csv:7", message);
  EXPECT_IN("'much'", message);
}

TEST(Recording_behaviour, refuses_nan_and_infinity) {
  EXPECT_IN("not finite", refusal(head(), rows(header, "0.45,4.5,nan,2,forward", 5)));
  EXPECT_IN("not finite", refusal(head(), rows(header, "0.45,4.5,inf,2,forward", 5)));
}

TEST(Recording_behaviour, refuses_time_that_falls) {
  const std::string message = refusal(head(), rows(header, "0.3,4.5,100,2,forward", 5));
  EXPECT_IN("time falls from row 5 to row 6", message);
}

TEST(Recording_behaviour, takes_time_that_starts_again_in_another_run) {
  const test::TemporaryFolder folder;
  folder.write("recording.json", head());
  std::string text = "run," + header + "\n";
  for (int run = 1; run <= 2; ++run)
    for (int i = 0; i < 12; ++i)
      text += std::to_string(run) + "," + std::to_string(i) + "," + std::to_string(i) + ",100,1,forward\n";
  folder.write("loops.csv", text);
  EXPECT_EQ(read_recording(folder.path).tables[0].rows(), 24u);
}

TEST(Recording_behaviour, refuses_a_unit_that_does_not_fit) {
  const std::string message = refusal(
      head(), rows("time [s],lateral_displacement [nm],normal_force [nm],lateral_force [uN],segment"));
  EXPECT_IN("normal_force [nm]", message);
  EXPECT_IN("uN", message);
}

TEST(Recording_behaviour, refuses_a_misspelt_column_with_the_nearest_name) {
  EXPECT_IN("did you mean 'normal_force'",
            refusal(head(),
                    rows("time [s],lateral_displacement [nm],normal_foce [uN],lateral_force [uN],segment")));
}

TEST(Recording_behaviour, refuses_a_missing_response) {
  const std::string message = refusal(
      head(), rows("time [s],lateral_displacement [nm],normal_force [uN],normal_displacement [nm],segment"));
  EXPECT_IN("no column 'lateral_force'", message);
}

TEST(Recording_behaviour, refuses_too_few_samples) {
  EXPECT_IN("3 samples", refusal(head(), header + "\n0,0,1,1,forward\n1,1,1,1,forward\n2,2,1,1,forward\n"));
}

TEST(Recording_behaviour, refuses_a_control_with_gaps) {
  EXPECT_IN("drives the simulation", refusal(head(), rows(header, "0.45,,100,2,forward", 5)));
}

TEST(Recording_behaviour, refuses_rows_of_another_length_and_files_of_another_format) {
  EXPECT_IN("loops.csv:7", refusal(head(), rows(header, "0.45,4.5,100", 5)));
  EXPECT_IN("asperity-recording/1", refusal(R"({"format": "other"})", rows(header)));
  EXPECT_IN("not JSON", refusal("{", rows(header)));
}

TEST(Recording_behaviour, refuses_a_file_of_a_gigabyte_without_reading_it) {
  const test::TemporaryFolder folder;
  folder.write("recording.json", head());
  std::filesystem::resize_file(folder.write("loops.csv", header + "\n"),
                               std::uintmax_t(1) << 30);  // sparse: no space is taken
  EXPECT_IN("1024 MB", test::message_of<InputError>([&] { read_recording(folder.path); }));
}

TEST(Recording_behaviour, refuses_an_unknown_law_and_a_body_without_modulus) {
  EXPECT_IN("there is no law 'magic'", refusal(head(R"("simulation": {"sliding": "magic"},)"), rows(header)));
  std::string json = head();
  json.replace(json.find("\"youngs_modulus\": \"71 GPa\", "), 28, "");
  EXPECT_IN("'particle' needs its 'youngs_modulus'", refusal(json, rows(header)));
}

TEST(Recording_behaviour, names_a_case_or_solved_cases_as_its_simulation) {
  const test::TemporaryFolder folder;
  folder.write("recording.json", head(R"("simulation": {"case": "mesh/case.prm", "study": "solved",
                 "parameters": {"Interface/Friction coefficient": {"value": 0.3},
                                "Particle/Yield stress": "1 GPa", "Mesh/Layers": 4}},)"));
  folder.write("loops.csv", rows(header));
  const Recording recording = read_recording(folder.path);
  EXPECT_EQ(recording.simulation.case_file, "mesh/case.prm");
  EXPECT_EQ(recording.simulation.study, "solved");
  EXPECT_EQ(recording.simulation.case_entries.at("Interface/Friction coefficient"), "0.3");
  EXPECT_EQ(recording.simulation.case_entries.at("Particle/Yield stress"), "1 GPa");
  EXPECT_EQ(recording.simulation.case_entries.at("Mesh/Layers"), "4");
  write_recording(recording, folder.path / "written");
  const Recording again = read_recording(folder.path / "written");
  EXPECT_EQ(again.simulation.case_file, recording.simulation.case_file);
  EXPECT_EQ(again.simulation.study, recording.simulation.study);
  EXPECT_EQ(again.simulation.case_entries, recording.simulation.case_entries);
}

TEST(Recording_behaviour, refuses_a_simulation_outside_its_folder_and_entries_that_are_none) {
  const auto said = [](const std::string& simulation) {
    return refusal(head(R"("simulation": {)" + simulation + "},"), rows(header));
  };
  EXPECT_IN("name it on the command line (--case)", said(R"("case": "/etc/case.prm")"));
  EXPECT_IN("name it on the command line (--study)", said(R"("study": "runs/../../other")"));
  EXPECT_IN("not a path below", said(R"("case": "")"));
  EXPECT_IN("there is no 'normal'", said(R"("case": "case.prm", "normal": "hertz")"));
  EXPECT_IN("no entry of a case", said(R"("case": "case.prm", "parameters": {"sliding_friction": 0.3})"));
  EXPECT_IN("taken as given so far",
            said(R"("case": "case.prm", "parameters": {"Interface/Friction coefficient": )"
                 R"({"value": 0.3, "calibrate": true}})"));
  EXPECT_IN("lacks its 'value'", said(R"("case": "case.prm", "parameters": {"Particle/Radius": {}})"));
}

}  // namespace
}  // namespace asperity
