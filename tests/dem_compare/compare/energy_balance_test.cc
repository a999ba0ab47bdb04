// A case whose energy does not balance is pointed at from 1 % on, and not used from 5 % on.
#include "results/energy_balance.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "dem_compare/compare/comparison.h"
#include "dem_compare/derive/derivation.h"
#include "tests/dem_compare/resistance/moving_folder.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

fs::path write_open(const fs::path& folder, const std::string& energy, int seed = 1) {
  test::MovingFolder made;
  made.seed = seed;
  test::write_moving(folder, made);
  write_file_atomically(
      folder / "result.json",
      R"({"format": "asperity-result/1", "experiment": "sliding", "effective": {}, "balance": {"energy": )" +
          energy + "}}");
  return folder;
}

bool any_has(const std::vector<std::string>& sentences, const std::string& part) {
  for (const auto& sentence : sentences)
    if (sentence.find(part) != std::string::npos) return true;
  return false;
}

TEST(EnergyBalance_analytic, open_by_more_than_one_per_cent_is_said_by_derive_and_compare) {
  const test::TemporaryFolder root;
  const fs::path folder = write_open(root.path / "a", "-0.023");
  const ParameterSets found = collect_parameter_sets({folder});
  EXPECT_TRUE(any_has(found.remarks, "2.3 % of its energy is not accounted for, more than 1 %"));
  EXPECT_EQ(derive_parameters(reduced_set(found.sets.front())).parameters.derivation["in_doubt"].size(), 1u);
  const Comparison comparison = compare_with_hertz(collect_cases({folder}), 0.05);
  EXPECT_EQ(comparison.remarks.size(), 1u);
  EXPECT_TRUE(any_has(comparison.remarks, "2.3 % of its energy"));
  EXPECT_TRUE(collect_cases({write_open(root.path / "b", "0.0099")}).remarks.empty());
}

TEST(EnergyBalance_analytic,
     open_by_more_than_five_per_cent_is_refused_where_it_is_named_and_left_out_where_it_is_not) {
  const test::TemporaryFolder root;
  const fs::path bad = write_open(root.path / "bad", "0.16");
  write_open(root.path / "good", "0.002", 2);
  const std::string message = test::message_of<InputError>([&] { collect_parameter_sets({bad}); });
  EXPECT_NE(message.find("bad: 16 % of its energy is not accounted for, more than 5 %"), std::string::npos)
      << message;
  EXPECT_NE(message.find("Load steps"), std::string::npos) << message;
  const ParameterSets found = collect_parameter_sets({root.path});
  ASSERT_EQ(found.sets.size(), 1u);
  EXPECT_EQ(found.sets[0].cases.size(), 1u);
  EXPECT_TRUE(any_has(found.remarks, "left out"));
  const CaseCollection collection = collect_cases({bad});
  EXPECT_TRUE(collection.groups.empty());
  ASSERT_EQ(collection.missing.size(), 1u);
  EXPECT_EQ(collection.missing[0].state, "refused");
  EXPECT_EQ(collect_cases({bad}, RefusedCases::shown).groups.size(), 1u);
}

TEST(EnergyBalance_analytic, just_beyond_a_limit_is_written_so_that_it_can_be_seen) {
  const test::TemporaryFolder root;
  EXPECT_NE(open_energy_words(read_solved_case(write_open(root.path / "a", "0.010001")))
                .find("1.0001 % of its energy"),
            std::string::npos);
}

TEST(RegionEdge_behaviour, a_contact_that_outgrew_its_mesh_is_said_by_derive_and_compare) {
  const test::TemporaryFolder root;
  const fs::path folder = write_open(root.path / "a", "0.001");
  EXPECT_FALSE(any_has(collect_parameter_sets({folder}).remarks, "edge of the finely meshed region"));
  write_file_atomically(folder / "result.json",
                        R"({"format": "asperity-result/1", "experiment": "sliding", "effective": {},
                            "balance": {"energy": 0.001}, "mesh": {"contact_reaches_rim": true}})");
  const ParameterSets found = collect_parameter_sets({folder});
  EXPECT_TRUE(any_has(found.remarks, "edge of the finely meshed region"));
  EXPECT_EQ(derive_parameters(reduced_set(found.sets.front())).parameters.derivation["in_doubt"].size(), 1u);
  EXPECT_TRUE(
      any_has(compare_with_hertz(collect_cases({folder}), 0.05).remarks, "larger Mesh/Contact region"));
}

}  // namespace
}  // namespace asperity
