// asperity compare as a person calls it.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "core/atomic_file.h"
#include "engines/run_program.h"
#include "tests/app/called_program.h"
#include "tests/dem_compare/compare/solved_folders.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::SolvedFolder;
using test::TemporaryFolder;
using test::write_solved;

using test::Outcome;

Outcome compare(const std::string& arguments) { return test::call("compare " + arguments); }

#define EXPECT_CONTAINS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

const std::string with_parameters =
    " --parameters " + std::string(ASPERITY_SOURCE_DIR) + "/runs/paper/parameters_silicon.json";

TEST(CompareCommand_behaviour, keeps_the_comparison_with_hertz_and_adds_the_columns) {
  const TemporaryFolder folder;
  const auto solved = write_solved(folder.path / "case", SolvedFolder{});
  const Outcome outcome = compare(solved.string() + with_parameters);
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_CONTAINS(outcome.output, "comparison with Hertz");
  EXPECT_CONTAINS(
      outcome.output,
      "overstates the lateral stiffness up to sliding of the finite elements by 20 ± 4 % at 100 uN");
  EXPECT_CONTAINS(outcome.output, "## Where each simplification is good enough");
  for (const char* name : {"comparison.json", "comparison.csv", "comparison.md", "side_by_side.csv"})
    EXPECT_TRUE(std::filesystem::exists(solved / name)) << name;
  const auto json = nlohmann::json::parse(read_file(solved / "comparison.json"));
  EXPECT_EQ(json["format"], "asperity-comparison/2");
  EXPECT_FALSE(json["groups"].empty());
  EXPECT_FALSE(json["side_by_side"]["rows"].empty());
}

TEST(CompareCommand_other_code, sets_lammps_beside_the_laws) {
  if (find_program("lmp").empty()) GTEST_SKIP() << "LAMMPS is not installed: apt-get install lammps";
  const TemporaryFolder folder;
  const auto solved = write_solved(folder.path / "case", SolvedFolder{});
  const Outcome outcome = compare(solved.string() + " --engine lammps --json");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  const auto json = nlohmann::json::parse(outcome.output);
  for (const auto& row : json["side_by_side"]["rows"])
    EXPECT_NEAR(row["ratios"]["engine_over_law"].get<double>(), 1, 0.01) << row.dump();
  EXPECT_TRUE(std::filesystem::exists(solved / "engine"));
}

TEST(CompareCommand_behaviour, keeps_the_other_columns_where_the_engine_is_missing_and_ends_with_status_1) {
  const TemporaryFolder folder;
  const auto solved = write_solved(folder.path / "case", SolvedFolder{});
  const Outcome outcome =
      compare(solved.string() + with_parameters + " --engine lammps --program no-such-lmp");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_CONTAINS(outcome.output, "asperity: LAMMPS is missing: there is no program 'no-such-lmp'");
  const auto json = nlohmann::json::parse(read_file(solved / "comparison.json"));
  int published = 0;
  for (const auto& row : json["side_by_side"]["rows"]) published += row["published"]["value"].is_number();
  EXPECT_GT(published, 5);
  EXPECT_CONTAINS(json["side_by_side"]["engine_failure"].get<std::string>(), "apt-get install lammps");
}

TEST(CompareCommand_behaviour, refuses_wrong_input_with_status_2) {
  const TemporaryFolder folder;
  const std::string solved = write_solved(folder.path / "case", SolvedFolder{}).string();
  EXPECT_EQ(compare(solved + " --engine lamps").status, 2);
  EXPECT_EQ(compare(solved + " --parameters nothing.json").status, 2);
  EXPECT_EQ(compare(solved + " --tolerance -1").status, 2);
  EXPECT_EQ(compare(folder.path.string()).status, 2);
  EXPECT_EQ(
      compare(solved + " --indenter " + ASPERITY_SOURCE_DIR + "/runs/paper/parameters_diamond.json").status,
      2);
}

}  // namespace
}  // namespace asperity
