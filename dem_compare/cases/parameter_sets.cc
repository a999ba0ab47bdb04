#include "dem_compare/cases/parameter_sets.h"

#include <algorithm>
#include <set>

#include "core/error.h"
#include "core/joined.h"
#include "dem_compare/cases/case_collection.h"
#include "results/energy_balance.h"
#include "results/region_edge.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

/// Sentences on cases end up in the order of the folders, however they were named.
struct FoundCase {
  std::string place;  ///< canonical
  SolvedCase solved;
};

class Collector {
 public:
  void add(const fs::path& folder, bool is_named = true) {
    if (is_study_folder(folder)) {
      CaseCollection study = collect_cases({folder});
      for (const auto& missing : study.missing)
        remark((folder / missing.name).string() + ": " + missing.state +
               (missing.message.empty() ? "" : " (" + missing.message + ")") + "; left out");
      for (auto& group : study.groups)
        for (auto& solved : group.cases) keep(std::move(solved));
    } else if (is_case_folder(folder)) {
      SolvedCase solved = read_solved_case(folder);
      if (is_named) refuse_open_energy(solved);
      keep(std::move(solved));
    } else {
      add_folders_within(folder);
    }
  }

  ParameterSets finish() {
    std::sort(cases_.begin(), cases_.end(),
              [](const FoundCase& a, const FoundCase& b) { return a.place < b.place; });
    const auto same = [](const FoundCase& a, const FoundCase& b) { return a.place == b.place; };
    std::vector<std::string> twice;
    for (std::size_t i = 1; i < cases_.size(); ++i)
      if (same(cases_[i - 1], cases_[i]))
        twice.push_back(cases_[i].solved.folder.string() + ": named twice; counted once");
    cases_.erase(std::unique(cases_.begin(), cases_.end(), same), cases_.end());
    for (auto& found : cases_) sort_in(std::move(found.solved));
    for (const auto& sentence : twice) remark(sentence);
    if (unlisted_ > 0)
      remark(std::to_string(unlisted_) +
             " case(s) were solved by a version whose result.json does not list the entries that make a "
             "contact; those of case.prm and of its numbers are taken");
    std::sort(remarks_.begin(), remarks_.end());
    remarks_.erase(std::unique(remarks_.begin(), remarks_.end()), remarks_.end());
    found_.remarks = remarks_;
    if (found_.sets.empty()) {
      const std::string reasons = joined(found_.remarks, "; ");
      throw InputError("no case is complete" + (reasons.empty() ? "" : ": " + reasons) +
                       "; finish them with 'asperity solve --resume' or 'asperity study --resume'");
    }
    share_frictionless_cases();
    return std::move(found_);
  }

 private:
  static bool is_friction(const std::string& entry) {
    return entry == "Interface/Friction coefficient" || entry == "Interface/Shear strength";
  }
  static bool same_but_for_friction(const ParameterSet& one, const ParameterSet& other) {
    const auto differ = differing_entries(one.inputs, other.inputs);
    return std::all_of(differ.begin(), differ.end(), is_friction);
  }
  static bool is_frictionless_loading(const ParameterSet& set) {
    for (const auto& [entry, value] : set.inputs)
      if (is_friction(entry) && value.find_first_of("123456789") != std::string::npos) return false;
    return std::all_of(set.cases.begin(), set.cases.end(),
                       [](const SolvedCase& solved) { return solved.motion() == Motion::normal; });
  }

  void share_frictionless_cases() {
    auto& sets = found_.sets;
    for (std::size_t i = 0; i < sets.size();) {
      std::size_t shared = 0;
      if (is_frictionless_loading(sets[i]))
        for (std::size_t k = 0; k < sets.size(); ++k)
          if (k != i && same_but_for_friction(sets[i], sets[k])) {
            sets[k].cases.insert(sets[k].cases.end(), sets[i].cases.begin(), sets[i].cases.end());
            ++shared;
          }
      if (shared == 0) {
        ++i;
        continue;
      }
      found_.remarks.push_back(
          std::to_string(sets[i].cases.size()) +
          " frictionless case(s) of experiment normal count for the set(s) with friction of the same bodies");
      sets.erase(sets.begin() + static_cast<long>(i));
    }
  }

  void add_folders_within(const fs::path& folder) {
    std::vector<fs::path> inside;
    if (fs::is_directory(folder))
      for (const auto& item : fs::directory_iterator(folder))
        if (is_study_folder(item.path()) || is_case_folder(item.path())) inside.push_back(item.path());
    if (inside.empty())
      throw InputError(folder.string() +
                       ": holds neither a solved case (history.csv), nor a study (study.json), nor folders "
                       "of such; name folders that 'asperity solve' or 'asperity study' wrote");
    std::sort(inside.begin(), inside.end());
    for (const auto& path : inside) add(path, false);
  }

  void remark(const std::string& sentence) { remarks_.push_back(sentence); }

  void keep(SolvedCase solved) {
    const std::string place = fs::canonical(solved.folder).string();
    cases_.push_back({place, std::move(solved)});
  }

  void sort_in(SolvedCase solved) {
    const std::string name = solved.folder.string();
    if (!solved.finished())
      return remark(name + ": not finished (result.json is missing or not complete); left out");
    if (solved.history.size() == 0) return remark(name + ": its history.csv has no rows; left out");
    if (is_energy_flagged(solved))
      remark(name + ": " + open_energy_words(solved) + (is_energy_refused(solved) ? "; left out" : ""));
    if (is_energy_refused(solved)) return;
    if (const std::string outgrown = region_edge_words(solved); !outgrown.empty())
      remark(name + ": " + outgrown);
    if (!solved.lists_physical_entries()) ++unlisted_;
    ContactInputs inputs = contact_inputs(solved);
    for (auto& set : found_.sets)
      if (set.inputs == inputs) {
        set.cases.push_back(std::move(solved));
        return;
      }
    found_.sets.push_back({std::move(inputs), {}});
    found_.sets.back().cases.push_back(std::move(solved));
  }

  ParameterSets found_;
  std::vector<FoundCase> cases_;
  std::vector<std::string> remarks_;
  int unlisted_ = 0;
};

}  // namespace

ParameterSets collect_parameter_sets(const std::vector<fs::path>& folders) {
  Collector collector;
  for (const auto& folder : folders) collector.add(folder);
  return collector.finish();
}

std::string differences(const std::vector<ParameterSet>& sets) {
  std::set<std::string> entries;
  for (const auto& set : sets)
    for (const auto& entry : differing_entries(sets.front().inputs, set.inputs)) entries.insert(entry);
  std::string text;
  for (const auto& entry : entries) {
    std::vector<std::string> values;
    for (const auto& set : sets) {
      const auto found = set.inputs.find(entry);
      const std::string value = found == set.inputs.end() ? "not said" : found->second;
      if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
    }
    text += (text.empty() ? "" : "; ") + entry + ": ";
    for (std::size_t k = 0; k < values.size(); ++k) text += (k ? ", " : "") + values[k];
  }
  return text;
}

}  // namespace asperity
