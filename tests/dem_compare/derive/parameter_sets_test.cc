// Solved cases gathered into sets of the same bodies, for each of which laws are derived.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>

#include "core/error.h"
#include "dem_compare/derive/derivation.h"
#include "tests/dem_compare/derive/made_case.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::make_case;
using test::TemporaryFolder;

/// A folder as `solve` leaves it.
void write_case(const std::filesystem::path& folder, const SolvedCase& solved, const std::string& radius,
                bool finished = true, double friction = 0.2) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "history.csv") << format_history(solved.history);
  std::ofstream(folder / "case.prm")
      << "subsection Particle\n  set Radius = " << radius
      << "\n  set Young modulus = 71 GPa\n  set Poisson ratio = 0.17\nend\nsubsection Substrate\n"
         "  set Young modulus = 179 GPa\n  set Poisson ratio = 0.25\n  set Topography = "
      << solved.entries.text("Substrate/Topography") << "\nend\n";
  nlohmann::ordered_json result = solved.result->document;
  result["inputs"] = {{"friction_coefficient", friction}};
  if (finished) std::ofstream(folder / "result.json") << result.dump();
}

TEST(ParameterSets_behaviour, hold_cases_that_differ_by_load_seed_and_experiment_alone) {
  std::mt19937 random(5);
  const TemporaryFolder folder;
  write_case(folder.path / "a", make_case({}, "sliding", 1e-4, 1, random), "8.5 um");
  write_case(folder.path / "b", make_case({}, "torsion", 1e-3, 2, random), "8.5 um");
  write_case(folder.path / "c", make_case({}, "sliding", 1e-4, 1, random), "5 um");
  write_case(folder.path / "d", make_case({}, "sliding", 1e-4, 1, random), "5 um", false);
  const ParameterSets found = collect_parameter_sets({folder.path, folder.path / "a"});
  ASSERT_EQ(found.sets.size(), 2u);
  EXPECT_EQ(found.sets[0].cases.size(), 2u);
  EXPECT_EQ(found.sets[1].cases.size(), 1u);
  EXPECT_EQ(differences(found.sets), "Particle/Radius: 8.5 um, 5 um");
  const auto says = [&](const std::string& part) {
    return std::any_of(found.remarks.begin(), found.remarks.end(),
                       [&](const auto& remark) { return remark.find(part) != std::string::npos; });
  };
  EXPECT_TRUE(says("d: not finished"));
  EXPECT_TRUE(says("a: named twice"));
  EXPECT_TRUE(says("does not list the entries"));  // of an earlier version
}

/// As a study writes its second realisation.
TEST(ParameterSets_behaviour, hold_realisations_whose_lengths_are_written_in_other_units) {
  std::mt19937 random(6);
  const TemporaryFolder folder;
  SolvedCase first = make_case({}, "sliding", 1e-4, 1, random), second = first;
  first.entries = CaseEntries(std::map<std::string, std::string>{
      {"Substrate/Topography", "generated(rms=0.7 nm, hurst=0.8, seed=1)"}});
  second.entries = CaseEntries(std::map<std::string, std::string>{
      {"Substrate/Topography", "generated(rms=700 pm, hurst=0.8, seed=1001)"}});
  write_case(folder.path / "a", first, "8.5 um");
  write_case(folder.path / "b", second, "8.5 um");
  const ParameterSets found = collect_parameter_sets({folder.path});
  ASSERT_EQ(found.sets.size(), 1u);
  EXPECT_EQ(found.sets[0].cases.size(), 2u);
}

TEST(ParameterSets_behaviour, with_friction_take_frictionless_cases_of_the_same_bodies_for_their_normal_law) {
  std::mt19937 random(7);
  const TemporaryFolder folder;
  write_case(folder.path / "a", make_case({}, "sliding", 1e-4, 1, random), "8.5 um");
  SolvedCase normal = make_case({}, "sliding", 1e-3, 1, random);
  normal.result->document["experiment"] = "normal";
  write_case(folder.path / "b", normal, "8.5 um", true, 0);
  write_case(folder.path / "c", normal, "5 um", true, 0);
  const ParameterSets found = collect_parameter_sets({folder.path});
  ASSERT_EQ(found.sets.size(), 2u);
  EXPECT_EQ(found.sets[0].cases.size(), 2u);
  EXPECT_EQ(found.sets[1].cases.size(), 1u);
  EXPECT_NE(found.remarks.back().find("count for the set(s) with friction"), std::string::npos);
}

TEST(ParameterSets_behaviour, refuse_a_folder_without_cases_and_cases_that_are_not_finished) {
  std::mt19937 random(6);
  const TemporaryFolder folder;
  EXPECT_NE(test::message_of<InputError>([&] {
              collect_parameter_sets({folder.path});
            }).find("neither a solved case"),
            std::string::npos);
  write_case(folder.path / "a", make_case({}, "sliding", 1e-4, 1, random), "8.5 um", false);
  const std::string message = test::message_of<InputError>([&] { collect_parameter_sets({folder.path}); });
  EXPECT_NE(message.find("no case is complete"), std::string::npos) << message;
  EXPECT_NE(message.find("--resume"), std::string::npos) << message;
}

}  // namespace
}  // namespace asperity
