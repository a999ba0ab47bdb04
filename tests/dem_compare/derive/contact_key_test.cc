// "The same contact" and "the same experiment": what derive, compare and the study of resistances go by.
#include "results/contact_key.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "dem_compare/derive/derivation.h"
#include "dem_compare/resistance/moving_study.h"
#include "tests/dem_compare/resistance/moving_folder.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A torsion case with adhesion, and one more entry of the interface.
fs::path write_adhesive(const fs::path& folder, double resistance, int seed, const std::string& more) {
  test::MovingFolder made;
  made.experiment = "torsion", made.friction = resistance, made.seed = seed;
  made.work_of_adhesion = "50 mJ/m^2";
  for (const char* entry : {"set Adhesion law = exponential", "set Adhesion range = 1 nm"})
    if (more.find(std::string(entry).substr(0, 17)) == std::string::npos)
      made.work_of_adhesion += std::string("\n ") + entry;
  made.work_of_adhesion += "\n " + more;
  return test::write_moving(folder, made);
}

std::vector<std::string> derived(const std::vector<fs::path>& folders) {
  std::vector<std::string> all;
  for (const auto& set : collect_parameter_sets(folders).sets)
    all.push_back(to_json(derive_parameters(reduced_set(set)).parameters).dump());
  return all;
}

class OneEntryApart_behaviour : public testing::TestWithParam<const char*> {};

TEST_P(OneEntryApart_behaviour, two_cases_are_two_contacts_whatever_their_order) {
  const test::TemporaryFolder root;
  const fs::path a = write_adhesive(root.path / "a", 1e-13, 1, ""),
                 b = write_adhesive(root.path / "b", 3e-13, 2, GetParam());
  const auto sets = collect_parameter_sets({a, b});
  ASSERT_EQ(sets.sets.size(), 2u);
  EXPECT_EQ(differing_entries(sets.sets[0].inputs, sets.sets[1].inputs).size(), 1u);
  const auto one = derived({a, b}), other = derived({b, a});
  ASSERT_EQ(one.size(), 2u);
  EXPECT_EQ(one, other);
  EXPECT_EQ(collect_parameter_sets({b, a}).remarks, sets.remarks);
  const CaseCollection collection = collect_cases({a, b});
  EXPECT_EQ(collection.groups.size(), 2u);
  EXPECT_EQ(collect_moving(collection).contacts.size(), 2u);
  EXPECT_EQ(collect_cases({b, a}).groups.front().label, collection.groups.front().label);
}

INSTANTIATE_TEST_SUITE_P(ContactKey, OneEntryApart_behaviour,
                         testing::Values("set Work of adhesion on separation = 100 mJ/m^2",
                                         "set Adhesion law = van_der_waals", "set Adhesion range = 2 nm",
                                         "set Shear strength = 1 GPa"));

TEST(ContactKey_behaviour, of_realisations_is_the_same_and_their_order_changes_nothing) {
  const test::TemporaryFolder root;
  const fs::path a = write_adhesive(root.path / "a", 1e-13, 1,
                                    "set Work of adhesion on separation = 0.1 J/m^2"),
                 b = write_adhesive(root.path / "b", 1.1e-13, 2,
                                    "set Work of adhesion on separation = 100 mJ/m^2");
  const auto one = derived({a, b, root.path}), other = derived({root.path, b, a});
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one, other);
  EXPECT_EQ(collect_cases({a, b}).groups.size(), 1u);
}

/// As later versions list entries that this one does not know.
void list_entries(const fs::path& folder, const std::string& film) {
  Json result = Json::parse(read_file(folder / "result.json"));
  Json& entries = result["inputs"]["entries"];
  const SolvedCase solved = read_solved_case(folder);
  for (const auto& [path, text] : solved.entries.all())
    if (path.rfind("Mesh", 0) != 0) entries[path] = text;
  entries["Interface/Film thickness"] = film;
  write_file_atomically(folder / "result.json", result.dump());
}

TEST(ContactKey_behaviour, holds_an_entry_that_only_result_json_knows) {
  const test::TemporaryFolder root;
  const fs::path a = write_adhesive(root.path / "a", 1e-13, 1, ""),
                 b = write_adhesive(root.path / "b", 3e-13, 2, "");
  list_entries(a, "1 nm"), list_entries(b, "1000 pm");
  EXPECT_EQ(collect_parameter_sets({a, b}).sets.size(), 1u);
  EXPECT_TRUE(collect_parameter_sets({a, b}).remarks.empty());
  list_entries(b, "2 nm");
  const auto sets = collect_parameter_sets({a, b});
  ASSERT_EQ(sets.sets.size(), 2u);
  EXPECT_EQ(differences(sets.sets), "Interface/Film thickness: 1 nm, 2 nm");
}

TEST(ContactKey_behaviour, is_of_what_was_solved_where_the_case_file_was_changed_since) {
  const test::TemporaryFolder root;
  const fs::path a = write_adhesive(root.path / "a", 1e-13, 1, "");
  list_entries(a, "0 m");
  const ContactInputs before = contact_inputs(read_solved_case(a));
  std::string text = read_file(a / "case.prm");
  text.replace(text.find("50 mJ"), 5, "90 mJ");
  write_file_atomically(a / "case.prm", text);
  EXPECT_EQ(contact_inputs(read_solved_case(a)), before);
}

TEST(ContactKey_behaviour, of_a_result_of_an_earlier_version_is_taken_from_what_it_holds_and_said_to_be) {
  const test::TemporaryFolder root;
  const fs::path a = write_adhesive(root.path / "a", 1e-13, 1, "");
  const auto sets = collect_parameter_sets({a});
  ASSERT_EQ(sets.remarks.size(), 1u);
  EXPECT_NE(sets.remarks[0].find("does not list the entries"), std::string::npos) << sets.remarks[0];
  Json result = Json::parse(read_file(a / "result.json"));
  result["inputs"] = {{"work_of_adhesion", 0.07},
                      {"opening_work", 0.2},
                      {"radius", 8.5e-6},
                      {"particle", {{"youngs_modulus", 71e9}, {"poissons_ratio", 0.17}}},
                      {"substrate", {{"youngs_modulus", 179e9}, {"poissons_ratio", 0.25}}}};
  write_file_atomically(a / "result.json", result.dump());
  fs::remove(a / "case.prm");
  const ContactInputs inputs = contact_inputs(read_solved_case(a));
  EXPECT_EQ(inputs.at("Interface/Work of adhesion on separation"), "200 mJ/m^2");
  EXPECT_EQ(inputs.at("Particle/Yield stress"), "inf");
  EXPECT_TRUE(adheres(inputs));
}

TEST(ContactKey_behaviour, knows_what_attracts) {
  EXPECT_FALSE(adheres({}));
  EXPECT_FALSE(adheres({{"Interface/Relative humidity", "0"}, {"Interface/Patch potential", "0 V"}}));
  for (const auto& [entry, text] :
       {std::pair{"Interface/Work of adhesion", "50 mJ/m^2"}, std::pair{"Interface/Attraction force", "1 uN"},
        std::pair{"Interface/Relative humidity", "0.4"}, std::pair{"Interface/Patch potential", "0.2 V"}})
    EXPECT_TRUE(adheres({{entry, text}})) << entry;
}

/// Two studies may have a cell of the same name.
TEST(CaseCollection_behaviour, tells_contacts_of_several_studies_apart_that_bear_one_name) {
  const test::TemporaryFolder root;
  for (const auto& [name, law] : {std::pair{"one", "set Work of adhesion on separation = 60 mJ/m^2"},
                                  std::pair{"two", "set Work of adhesion on separation = 90 mJ/m^2"}}) {
    write_adhesive(root.path / name / "case", 1e-13, 1, law);
    write_file_atomically(root.path / name / "study.json",
                          R"({"format": "asperity-study/1", "title": "S", "axes": [{"name": "Surface",
      "values": ["rough"]}], "cases": [{"name": "case", "folder": "case", "values": {"Surface": "rough"},
          "state": "done"}]})");
  }
  const CaseCollection both = collect_cases({root.path / "one", root.path / "two"});
  ASSERT_EQ(both.groups.size(), 2u);
  EXPECT_NE(both.groups[0].label, both.groups[1].label);
}

/// A study of one cell has no axis that names it.
TEST(CaseCollection_behaviour, of_a_study_without_axes_takes_the_cases_by_their_title) {
  const test::TemporaryFolder root;
  write_adhesive(root.path / "study" / "case", 1e-13, 1, "");
  write_file_atomically(root.path / "study" / "study.json",
                        R"({"format": "asperity-study/1", "title": "S", "axes": [],
      "cases": [{"name": "case", "folder": "case", "values": {}, "state": "done"}]})");
  const CaseCollection collection = collect_cases({root.path / "study"});
  ASSERT_EQ(collection.groups.size(), 1u);
  EXPECT_EQ(collection.groups[0].label, collection.groups[0].first().title());
}

TEST(CaseCollection_behaviour, does_not_take_a_case_that_was_solved_twice_for_two_realisations) {
  const test::TemporaryFolder root;
  const fs::path a = write_adhesive(root.path / "a", 1e-13, 1, ""),
                 b = write_adhesive(root.path / "b", 1e-13, 1, "");
  const CaseCollection collection = collect_cases({a, b, a});
  ASSERT_EQ(collection.groups.size(), 1u);
  EXPECT_EQ(collection.groups[0].cases.size(), 1u);
  ASSERT_EQ(collection.missing.size(), 1u);
  EXPECT_EQ(collection.missing[0].state, "solved twice");
}

}  // namespace
}  // namespace asperity
