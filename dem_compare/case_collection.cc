#include "dem_compare/case_collection.h"

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/json_text.h"
#include "dem_compare/surface_text.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// All that decides the physics, without the seeds of generated surfaces.
std::string physics_of(const CaseEntries& entries) {
  std::string key;
  for (const auto& [path, text] : entries.all()) {
    const std::string section = path.substr(0, path.find('/'));
    if (path == "Title" || section == "Mesh" || section == "Solver" || section == "Output") continue;
    key += path + "=" + surface_without_seed(text) + "\n";
  }
  return key;
}

void add_to_group(CaseCollection& collection, const std::string& label, const std::vector<std::string>& values,
                  SolvedCase solved) {
  NormalNumbers numbers = normal_numbers(solved.history, solved.hertz());
  for (auto& group : collection.groups) {
    const bool same_cell = values.empty() ? group.physics() == physics_of(solved.entries) &&
                                                group.first().interface_spacing() == solved.interface_spacing()
                                          : group.label == label;
    if (!same_cell) continue;
    group.cases.push_back(std::move(solved));
    group.numbers.push_back(std::move(numbers));
    return;
  }
  collection.groups.push_back({label, values, {std::move(solved)}, {std::move(numbers)}});
}

void add_cases(CaseCollection& collection, const fs::path& folder, const fs::path& file) {
  const Json study = json_if_valid(read_file(file));
  if (!study.is_object() || study.value("format", "") != "asperity-study/1")
    throw InputError(file.string() + ": is not a summary of a study ('asperity-study/1'); run 'asperity study --resume' again");
  collection.title = study.value("title", "");
  for (const auto& axis : study.at("axes"))
    collection.axes.push_back({axis.at("name").get<std::string>(), axis.at("values").get<std::vector<std::string>>()});
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
      collection.missing.push_back({name, state == "done" ? "its folder is gone" : state, entry.value("message", "")});
      continue;
    }
    SolvedCase solved = read_solved_case(case_folder);
    if (!solved.finished()) {
      collection.missing.push_back({name, "not complete", ""});
      continue;
    }
    add_to_group(collection, label.empty() ? solved.title() : label, values, std::move(solved));
  }
}

void add_study(CaseCollection& collection, const fs::path& folder) {
  const fs::path file = folder / "study.json";
  try {
    add_cases(collection, folder, file);
  } catch (const Json::exception& error) {
    throw InputError(file.string() + ": lacks what a summary of a study holds (" + error.what() +
                     "); run 'asperity study --resume' again");
  }
}

}  // namespace

std::string CaseGroup::physics() const { return physics_of(first().entries); }

bool is_study_folder(const fs::path& folder) { return fs::exists(folder / "study.json"); }

CaseCollection collect_cases(const std::vector<fs::path>& folders) {
  CaseCollection collection;
  for (const auto& folder : folders) {
    if (is_study_folder(folder)) {
      add_study(collection, folder);
    } else if (is_case_folder(folder)) {
      ++collection.planned;
      SolvedCase solved = read_solved_case(folder);
      const std::string title = solved.title();
      if (collection.title.empty()) collection.title = title;
      add_to_group(collection, title, {}, std::move(solved));
    } else {
      throw InputError(folder.string() + ": holds neither a solved case (history.csv) nor a study (study.json)");
    }
  }
  // Axes are those of one study; several folders are told apart by their labels.
  if (folders.size() > 1) collection.axes.clear();
  return collection;
}

}  // namespace asperity
