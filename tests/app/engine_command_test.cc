// asperity engine and engine-input as a person calls them.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "core/atomic_file.h"
#include "dem_compare/engines/run_program.h"
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
  const Outcome outcome = call("engine " + silicon + " --engine lammps --experiment glued --amplitude '50 nm' --json --output " +
                               (folder.path / "glued").string());
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  for (const char* name : {"in.asperity", "trace.csv", "engine.json", "engine.log"})
    EXPECT_TRUE(std::filesystem::exists(folder.path / "glued" / name)) << name;
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(json["format"], "asperity-engine-run/1");
  for (const auto& measurement : json["measurements"])
    EXPECT_NEAR(measurement["ratio"].get<double>(), 1, 0.01) << measurement["name"];
}

TEST(EngineCommand, that_finds_no_engine_ends_with_status_1_and_what_to_install) {
  const TemporaryFolder folder;
  const Outcome outcome = call("engine " + silicon + " --engine yade --program no-such-yade --experiment glued --output " + folder.path.string());
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.output, "asperity: YADE is missing: there is no program 'no-such-yade'; install it with 'apt-get install yade' or "
                            "'./quickstart --engines', or name it with --program\n");
}

TEST(EngineCommand, refuses_wrong_input_with_status_2) {
  EXPECT_EQ(call("engine " + silicon + " --engine lamps --experiment glued --output x").status, 2);
  EXPECT_EQ(call("engine " + silicon + " --engine lammps --experiment glued --amplitude '1 nm' --output x").status, 2);
  EXPECT_EQ(call("engine " + silicon + " --engine lammps --experiment rail --rail-angle '95 deg' --output x").status, 2);
  EXPECT_EQ(call("engine-input nothing.json --engine lammps").status, 2);
  const TemporaryFolder folder;
  const auto file = folder.write("p.json", "{\"format\": \"asperity-parameters/1\"}");
  EXPECT_EQ(call("engine-input " + file.string() + " --engine lammps").output, "asperity: " + file.string() + ": 'particle' is missing\n");
}

TEST(EngineCommand, writes_an_input_for_every_engine) {
  const TemporaryFolder folder;
  for (const std::string engine : {"lammps", "yade", "liggghts", "mercurydpm", "kratos", "musen"}) {
    const auto file = folder.path / engine;
    EXPECT_EQ(call("engine-input " + silicon + " --engine " + engine + " --output " + file.string()).status, 0);
    EXPECT_CONTAINS(read_file(file), "Written by asperity for");
    EXPECT_CONTAINS(read_file(file), "cannot express");
  }
}

}  // namespace
}  // namespace asperity
