// Every physical entry of a case file is in the key of "the same contact", and nothing else is.
#include "results/contact_key.h"

#include <gtest/gtest.h>

#include <cctype>
#include <regex>

#include "app/case_declaration.h"
#include "app/case_file.h"
#include "tests/app/smooth_case.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

std::string path_of(const CaseEntry& entry) {
  return entry.section.empty() ? entry.name : entry.section + "/" + entry.name;
}
std::string text_of(const CaseEntry& entry) {
  return entry.default_text.empty() ? entry.example : entry.default_text;
}

/// All entries of a case; those that result.json lists too.
SolvedCase solved_with(const std::string& changed_path, const std::string& changed_text, bool is_listed) {
  std::map<std::string, std::string> texts;
  SolvedCase solved;
  solved.result.emplace();
  for (const auto& entry : case_entries()) {
    texts[path_of(entry)] = path_of(entry) == changed_path ? changed_text : text_of(entry);
    if (entry.is_physical && is_listed)
      solved.result->physical_entries[path_of(entry)] = texts[path_of(entry)];
  }
  solved.entries = CaseEntries(texts);
  return solved;
}

std::string another(const CaseEntry& entry) {
  const std::string text = text_of(entry);
  return text == "inf" || std::isdigit(static_cast<unsigned char>(text[0])) ? "0.123" : "another";
}

TEST(ContactKey_behaviour, holds_every_physical_entry_of_the_declaration) {
  const SolvedCase base = solved_with("", "", true);
  for (const auto& entry : case_entries()) {
    const std::string path = path_of(entry);
    const SolvedCase changed = solved_with(path, another(entry), true);
    const bool is_of_contact = entry.is_physical && entry.section != "Experiment";
    EXPECT_EQ(contact_inputs(changed) != contact_inputs(base), is_of_contact) << path;
    EXPECT_EQ(case_inputs(changed) != case_inputs(base), entry.is_physical || entry.section == "Experiment")
        << path;
  }
}

/// Results that do not list their entries are known by the sections of their case files.
TEST(ContactKey_behaviour, of_earlier_results_holds_every_physical_entry_too) {
  const SolvedCase base = solved_with("", "", false);
  for (const auto& entry : case_entries())
    EXPECT_EQ(contact_inputs(solved_with(path_of(entry), another(entry), false)) != contact_inputs(base),
              entry.is_physical && entry.section != "Experiment")
        << path_of(entry);
}

TEST(ContactKey_behaviour, leaves_out_title_mesh_solver_output_and_steps_alone) {
  for (const auto& entry : case_entries()) {
    const bool is_of_steps = std::regex_match(entry.name, std::regex(".+ steps|Load step error"));
    EXPECT_EQ(entry.is_physical, !(entry.section.empty() || entry.section == "Mesh" ||
                                   entry.section == "Solver" || entry.section == "Output" || is_of_steps))
        << path_of(entry);
  }
}

TEST(CaseFile_behaviour, remembers_its_physical_entries_for_result_json) {
  const test::TemporaryFolder folder;
  const CaseInput input = read_case(folder.write("case.prm", test::smooth_case()),
                                    {"Interface/Work of adhesion on separation=0.2 J/m^2", "Mesh/Layers=3"});
  std::size_t physical = 0;
  for (const auto& entry : case_entries()) {
    const bool is_said = entry.is_physical && !entry.counts_if_given;
    physical += is_said;
    EXPECT_EQ(input.physical_entries.count(path_of(entry)), is_said ? 1u : 0u) << path_of(entry);
  }
  EXPECT_EQ(input.physical_entries.size(), physical);
  EXPECT_EQ(input.physical_entries.at("Interface/Work of adhesion on separation"), "0.2 J/m^2");
  EXPECT_EQ(input.physical_entries.at("Particle/Yield stress"), "inf");
}

}  // namespace
}  // namespace asperity
