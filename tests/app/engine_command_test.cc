// asperity engine and engine-input as a person calls them.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/atomic_file.h"
#include "engines/run_program.h"
#include "tests/app/called_program.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::call;
using test::Outcome;
using test::TemporaryFolder;

#define EXPECT_CONTAINS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

const std::string silicon = std::string(ASPERITY_SOURCE_DIR) + "/runs/paper/parameters_silicon.json";

TEST(EngineCommand_other_code, runs_lammps_and_keeps_input_trace_and_numbers) {
  if (find_program("lmp").empty()) GTEST_SKIP() << "LAMMPS is not installed: apt-get install lammps";
  const TemporaryFolder folder;
  const Outcome outcome =
      call("engine " + silicon + " --engine lammps --experiment glued --amplitude '50 nm' --json --output " +
           (folder.path / "glued").string());
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  for (const char* name : {"in.asperity", "trace.csv", "engine.json", "engine.log"})
    EXPECT_TRUE(std::filesystem::exists(folder.path / "glued" / name)) << name;
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(json["format"], "asperity-engine-run/1");
  for (const auto& measurement : json["measurements"])
    EXPECT_NEAR(measurement["ratio"].get<double>(), 1, 0.01) << measurement["name"];
}

TEST(EngineCommand_behaviour, that_finds_no_engine_ends_with_status_1_and_what_to_install) {
  const TemporaryFolder folder;
  const Outcome outcome =
      call("engine " + silicon + " --engine yade --program no-such-yade --experiment glued --output " +
           folder.path.string());
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.output,
            "asperity: YADE is missing: there is no program 'no-such-yade'; install it with 'apt-get install "
            "yade' or "
            "'./quickstart --engines', or name it with --program\n");
}

TEST(EngineCommand_behaviour, refuses_wrong_input_with_status_2) {
  EXPECT_EQ(call("engine " + silicon + " --engine lamps --experiment glued --output x").status, 2);
  EXPECT_EQ(
      call("engine " + silicon + " --engine lammps --experiment glued --amplitude '1 nm' --output x").status,
      2);
  EXPECT_EQ(call("engine " + silicon + " --engine lammps --experiment rail --rail-angle '95 deg' --output x")
                .status,
            2);
  EXPECT_EQ(call("engine-input nothing.json --engine lammps").status, 2);
  const TemporaryFolder folder;
  const auto file = folder.write("p.json", "{\"format\": \"asperity-parameters/1\"}");
  EXPECT_EQ(call("engine-input " + file.string() + " --engine lammps").output,
            "asperity: " + file.string() + ": 'particle' is missing\n");
}

/// The paper's record without some of its quantities.
std::filesystem::path record_without(const TemporaryFolder& folder, const std::string& name,
                                     const std::vector<std::string>& motions) {
  auto json = nlohmann::ordered_json::parse(read_file(silicon));
  nlohmann::ordered_json kept = nlohmann::ordered_json::object();
  for (const auto& [key, value] : json["quantities"].items())
    if (std::none_of(motions.begin(), motions.end(),
                     [&, k = key](const std::string& motion) { return k.rfind(motion, 0) == 0; }))
      kept[key] = value;
  json["quantities"] = kept;
  return folder.write(name, json.dump());
}

TEST(EngineCommand_behaviour, says_which_cases_an_engine_still_needs) {
  const TemporaryFolder folder;
  const auto normal = record_without(folder, "normal.json", {"sliding_", "rolling_", "torsion_"});
  const Outcome refused = call("engine-input " + normal.string() + " --engine lammps");
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(refused.output, "asperity: " + normal.string() +
                                ": LAMMPS still needs sliding_friction (a case with Experiment/Type = "
                                "sliding); rolling_friction and "
                                "rolling_stiffness (a case with Experiment/Type = rolling); torsion_friction "
                                "and torsion_stiffness (a case with Experiment/Type = torsion); "
                                "solve these for the same contact and run 'asperity derive' over their "
                                "folders and those solved before\n");
  EXPECT_CONTAINS(
      call("engine " + normal.string() + " --engine lammps --experiment glued --output x").output,
      "a solved case of this contact with Experiment/Type = sliding tells it to 'asperity derive'");

  // What an engine can do without is left out, and said to be: on the terminal and in the file.
  const auto sliding = record_without(folder, "sliding.json", {"rolling_", "torsion_"});
  const auto input = folder.path / "in.contact";
  const Outcome written =
      call("engine-input " + sliding.string() + " --engine lammps --output " + input.string());
  EXPECT_EQ(written.status, 0);
  for (const std::string& text : {written.output, read_file(input)}) {
    EXPECT_CONTAINS(text, "rolling_friction and rolling_stiffness (a case with Experiment/Type = rolling)");
    EXPECT_CONTAINS(text, "torsion_friction and torsion_stiffness (a case with Experiment/Type = torsion)");
  }
}

TEST(EngineCommand_analytic, name_of_a_file_with_a_line_break_stays_in_the_comment) {
  const TemporaryFolder folder;
  for (const std::string name : {"p\nshell touch pwned.json", "p\r\xff &.json"}) {
    const auto file = folder.write(name, read_file(silicon));
    for (const std::string engine : {"lammps", "yade", "liggghts", "mercurydpm", "kratos", "musen"}) {
      const Outcome outcome = call("engine-input '" + file.string() + "' --engine " + engine);
      EXPECT_EQ(outcome.status, 0) << outcome.output;
      EXPECT_EQ(outcome.output.find("\nshell"), std::string::npos) << engine;
      EXPECT_EQ(outcome.output.find_first_of("\r\xff"), std::string::npos) << engine;
      EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), [&] {
        const std::string harmless = call("engine-input " + silicon + " --engine " + engine).output;
        return std::count(harmless.begin(), harmless.end(), '\n');
      }()) << engine;
    }
  }
}

TEST(EngineCommand_behaviour, unit_is_quoted_on_one_line) {
  const TemporaryFolder folder;
  auto json = nlohmann::json::parse(read_file(silicon));
  json["quantities"]["reduced_modulus"]["unit"] = "G\n\x1b[31mPa";
  const auto file = folder.write("p.json", json.dump());
  EXPECT_EQ(call("engine-input " + file.string() + " --engine lammps").output,
            "asperity: " + file.string() +
                ": 'quantities/reduced_modulus' has the unit 'G\\n\\x1b[31mPa'; it must be in SI: 'Pa'\n");
}

TEST(EngineCommand_behaviour, writes_an_input_for_every_engine) {
  const TemporaryFolder folder;
  for (const std::string engine : {"lammps", "yade", "liggghts", "mercurydpm", "kratos", "musen"}) {
    const auto file = folder.path / engine;
    EXPECT_EQ(call("engine-input " + silicon + " --engine " + engine + " --output " + file.string()).status,
              0);
    EXPECT_CONTAINS(read_file(file), "Written by asperity for");
    EXPECT_CONTAINS(read_file(file), "cannot express");
  }
}

TEST(EngineInputCommand_behaviour, writes_all_pairs_and_a_box_for_several_records) {
  const TemporaryFolder folder;
  auto record = nlohmann::ordered_json::parse(read_file(silicon));
  record["particle"]["material"] = "zirconia";
  record["particle"]["density"] = 6000;
  const std::string other = (folder.path / "zirconia.json").string();
  folder.write("zirconia.json", record.dump());
  const std::string files = silicon + " " + other;
  const Outcome printed = call("engine-input " + files + " --engine lammps --restitution 0.8");
  EXPECT_EQ(printed.status, 0) << printed.output;
  for (const char* part : {"pair_coeff 1 3 hertz", "pair_coeff 2 2 hertz", "variable on_plane_3_2 string",
                           "Time step advised", "type 3 (zirconia): no record has this pair"})
    EXPECT_CONTAINS(printed.output, part);
  const std::string box = (folder.path / "box").string();
  const Outcome boxed = call("engine-input " + files + " --engine yade --box 27 --output " + box);
  EXPECT_EQ(boxed.status, 0) << boxed.output;
  EXPECT_CONTAINS(boxed.output, "box of 27 particles");
  for (const char* name : {"contacts.py", "box.py", "particles.csv"})
    EXPECT_TRUE(std::filesystem::exists(folder.path / "box" / name)) << name;
  // What cannot be done says what to do, and writes nothing.
  for (const auto& [line, part] : std::vector<std::pair<std::string, std::string>>{
           {files + " --engine musen --box 27 --output " + box + "2", "lammps, liggghts and yade"},
           {files + " --engine lammps --box 27", "--output"},
           {files + " --engine lammps --restitution 0.01 --box 27 --output " + box + "2", "restitution"},
           {silicon + " --engine lammps --restitution 0.8", "--many-particles"},
           {files + " " + other + " --engine lammps", "give each pair once"},
           {files + " --engine lammps --radii '5 um to 1 um'", "smallest first"}}) {
    const Outcome refused = call("engine-input " + line);
    EXPECT_EQ(refused.status, 2) << line << refused.output;
    EXPECT_CONTAINS(refused.output, part);
  }
  EXPECT_FALSE(std::filesystem::exists(box + "2"));
}

}  // namespace
}  // namespace asperity
