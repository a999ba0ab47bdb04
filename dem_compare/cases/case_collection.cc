#include "dem_compare/cases/case_collection.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/json_text.h"
#include "dem_compare/cases/case_numbers.h"
#include "results/energy_balance.h"
#include "results/region_edge.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Same surfaces, seeds and meshes: solved twice, it tells nothing of how realisations differ.
const SolvedCase* repeated_in(const CaseGroup& group, const SolvedCase& solved) {
  for (const auto& other : group.cases)
    if (realisation_of(other) == realisation_of(solved)) return &other;
  return nullptr;
}

/// Cells of a study are known by their values too: an axis may vary how a case is solved.
bool is_of_group(const CaseGroup& group, const std::vector<std::string>& values, const SolvedCase& solved) {
  if (group.values != values || !differing_entries(group.physics(), case_inputs(solved)).empty())
    return false;
  return !values.empty() || same_spacing(group.first().interface_spacing(), solved.interface_spacing());
}

void add_to_groups(CaseCollection& collection, const std::string& label,
                   const std::vector<std::string>& values, SolvedCase solved, RefusedCases refused) {
  if (is_energy_flagged(solved)) {
    if (is_energy_refused(solved) && refused == RefusedCases::left_out) {
      collection.missing.push_back({solved.folder.filename().string(), "refused", open_energy_words(solved)});
      return;
    }
    collection.remarks.push_back(solved.folder.string() + ": " + open_energy_words(solved));
  }
  if (const std::string outgrown = region_edge_words(solved); !outgrown.empty())
    collection.remarks.push_back(solved.folder.string() + ": " + outgrown);
  NormalNumbers numbers = normal_numbers(solved.history, solved.hertz(), solved.attraction_force());
  for (auto& group : collection.groups) {
    if (!is_of_group(group, values, solved)) continue;
    const SolvedCase* other =
        values.empty() ? repeated_in(group, solved) : nullptr;  // a study knows its realisations
    if (other) {
      collection.missing.push_back(
          {solved.folder.filename().string(), "solved twice",
           "same contact, seeds and spacing as " + other->folder.string() + ", which counts"});
      return;
    }
    group.cases.push_back(std::move(solved));
    group.numbers.push_back(std::move(numbers));
    return;
  }
  collection.groups.push_back({label, values, {std::move(solved)}, {std::move(numbers)}});
}

void add_cases(CaseCollection& collection, const fs::path& folder, const fs::path& file,
               RefusedCases refused) {
  const Json study = json_if_valid(read_file(file));
  if (!study.is_object() || study.value("format", "") != "asperity-study/1")
    throw InputError(
        file.string() +
        ": is not a summary of a study ('asperity-study/1'); run 'asperity study --resume' again");
  collection.title = study.value("title", "");
  for (const auto& axis : study.at("axes"))
    collection.axes.push_back(
        {axis.at("name").get<std::string>(), axis.at("values").get<std::vector<std::string>>()});
  for (const auto& entry : study.at("cases")) {
    ++collection.planned;
    const std::string name = entry.at("name").get<std::string>();
    std::vector<std::string> values;
    std::string label;
    for (const auto& [axis, value] : entry.at("values").items()) {
      values.push_back(value.get<std::string>());
      label += (label.empty() ? "" : ", ") + values.back();
    }
    const fs::path case_folder = folder / entry.value("folder", name);
    const std::string state = entry.value("state", "");
    if (state != "done" || !is_case_folder(case_folder)) {
      collection.missing.push_back(
          {name, state == "done" ? "its folder is gone" : state, entry.value("message", "")});
      continue;
    }
    SolvedCase solved = read_solved_case(case_folder);
    if (!solved.finished()) {
      collection.missing.push_back({name, "not complete", ""});
      continue;
    }
    if (label.empty()) label = solved.title();
    add_to_groups(collection, label, values, std::move(solved), refused);
  }
}

void add_study(CaseCollection& collection, const fs::path& folder, RefusedCases refused) {
  const fs::path file = folder / "study.json";
  try {
    add_cases(collection, folder, file, refused);
  } catch (const Json::exception& error) {
    throw InputError(file.string() + ": lacks what a summary of a study holds (" + error.what() +
                     "); run 'asperity study --resume' again");
  }
}

}  // namespace

bool is_study_folder(const fs::path& folder) { return fs::exists(folder / "study.json"); }

namespace {

/// Each folder once, by its canonical place.
std::vector<fs::path> in_order(const std::vector<fs::path>& named) {
  std::map<std::string, fs::path> folders;
  for (const auto& folder : named) {
    const std::string place = fs::weakly_canonical(folder).string();
    const auto found = folders.find(place);
    if (found == folders.end() || folder < found->second) folders[place] = folder;
  }
  std::vector<fs::path> ordered;
  for (const auto& [place, folder] : folders) ordered.push_back(folder);
  return ordered;
}

/// Groups of different contacts that bear the same name are told apart by the folder of their first case.
void tell_labels_apart(std::vector<CaseGroup>& groups) {
  std::map<std::string, int> count;
  for (const auto& group : groups) ++count[group.label];
  for (auto& group : groups)
    if (count[group.label] > 1) {
      const fs::path folder = fs::absolute(group.first().folder).lexically_normal();
      group.label += " (" + (folder.parent_path().filename() / folder.filename()).string() + ")";
    }
}

/// Contacts as they come, each with its finest mesh first.
void put_finest_first(std::vector<CaseGroup>& groups) {
  std::vector<ContactInputs> families;
  std::vector<std::pair<std::size_t, double>> keys;
  for (const auto& group : groups) {
    const ContactInputs own = group.physics();
    const auto found = std::find(families.begin(), families.end(), own);
    const double spacing = group.first().interface_spacing();
    keys.emplace_back(found - families.begin(), std::isnan(spacing) ? INFINITY : spacing);
    if (found == families.end()) families.push_back(own);
  }
  std::vector<std::size_t> order(groups.size());
  std::iota(order.begin(), order.end(), 0);
  const auto before = [&](std::size_t a, std::size_t b) {
    return keys[a].first != keys[b].first ? keys[a].first < keys[b].first : keys[a].second < keys[b].second;
  };
  std::stable_sort(order.begin(), order.end(), before);
  std::vector<CaseGroup> sorted;
  for (const std::size_t i : order) sorted.push_back(std::move(groups[i]));
  groups = std::move(sorted);
}

}  // namespace

CaseCollection collect_cases(const std::vector<fs::path>& named, RefusedCases refused) {
  const std::vector<fs::path> folders = in_order(named);
  CaseCollection collection;
  for (const auto& folder : folders) {
    if (is_study_folder(folder)) {
      add_study(collection, folder, refused);
    } else if (is_case_folder(folder)) {
      ++collection.planned;
      SolvedCase solved = read_solved_case(folder);
      const std::string title = solved.title();
      if (collection.title.empty()) collection.title = title;
      add_to_groups(collection, title, {}, std::move(solved), refused);
    } else {
      throw InputError(folder.string() +
                       ": holds neither a solved case (history.csv) nor a study (study.json)");
    }
  }
  // Axes are those of one study; several folders are told apart by their labels.
  if (folders.size() > 1) {
    collection.axes.clear();
    put_finest_first(collection.groups);
    tell_labels_apart(collection.groups);
  }
  return collection;
}

}  // namespace asperity
