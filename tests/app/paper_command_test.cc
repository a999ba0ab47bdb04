// asperity paper as a person calls it.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "core/csv.h"
#include "tests/app/called_program.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::call;
using test::Outcome;
using test::TemporaryFolder;

TEST(PaperCommand_behaviour, prints_tables_and_writes_numbers_and_curves) {
  const TemporaryFolder folder;
  const Outcome outcome = call("paper --output " + folder.path.string());
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.output.find("Table 2: contact properties"), std::string::npos);
  const CsvTable curve = read_csv(folder.path / "fig_rail.csv");
  EXPECT_EQ(curve.numbers("measured").size(), 3u);
  EXPECT_EQ(read_csv(folder.path / "numbers_2.csv").column("deviation_in_sigma"), 6u);
  EXPECT_TRUE(std::filesystem::exists(folder.path / "paper.json"));
}

TEST(PaperCommand_behaviour, prints_json) {
  const Outcome outcome = call("paper --json");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(nlohmann::json::parse(outcome.output)["format"], "asperity-paper/1");
}

TEST(PaperCommand_behaviour, fits_a_series_of_ones_own) {
  const TemporaryFolder folder;
  const auto file = folder.write(
      "series.csv", "normal_force [uN],lateral_force [uN]\n100,0.5304\n1000,1.2414\n3000,2.8214\n");
  const Outcome outcome = call("paper --json --series " + file.string());
  const auto numbers = nlohmann::json::parse(outcome.output)["sections"][0]["numbers"];
  EXPECT_NEAR(numbers[0]["computed"]["value"].get<double>(), 7.9e-4, 1e-7);
  EXPECT_NEAR(numbers[1]["computed"]["value"].get<double>(), 571.4e-6, 1e-7);
  const auto wrong = folder.write("wrong.csv", "normal_force [uN],force [uN]\n100,1\n");
  EXPECT_EQ(call("paper --series " + wrong.string()).status, 2);
}

TEST(PaperCommand_behaviour, refuses_a_folder_without_the_published_numbers) {
  const Outcome outcome = call("paper --data /nowhere");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.output.find("bodies.csv"), std::string::npos) << outcome.output;
}

}  // namespace
}  // namespace asperity
