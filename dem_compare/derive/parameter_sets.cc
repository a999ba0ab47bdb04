#include "dem_compare/derive/parameter_sets.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "core/error.h"
#include "dem_compare/case_collection.h"
#include "dem_compare/surface_text.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

/// Inputs that a parameter set belongs to, and what a case file means where it does not say them.
struct Input {
  const char* entry;
  Dimension dimension;
  const char* otherwise;
};

const std::vector<Input>& number_inputs() {
  static const std::vector<Input> inputs{{"Particle/Radius", Dimension::length, ""},
                                         {"Particle/Young modulus", Dimension::pressure, ""},
                                         {"Particle/Poisson ratio", Dimension::none, ""},
                                         {"Particle/Yield stress", Dimension::pressure, "inf"},
                                         {"Particle/Hardening modulus", Dimension::pressure, "0"},
                                         {"Particle/Voce saturation", Dimension::pressure, "0"},
                                         {"Particle/Voce rate", Dimension::none, "0"},
                                         {"Substrate/Young modulus", Dimension::pressure, ""},
                                         {"Substrate/Poisson ratio", Dimension::none, ""},
                                         {"Substrate/Yield stress", Dimension::pressure, "inf"},
                                         {"Substrate/Hardening modulus", Dimension::pressure, "0"},
                                         {"Substrate/Voce saturation", Dimension::pressure, "0"},
                                         {"Substrate/Voce rate", Dimension::none, "0"},
                                         {"Interface/Friction coefficient", Dimension::none, "0"},
                                         {"Interface/Shear strength", Dimension::pressure, "0"},
                                         {"Interface/Work of adhesion", Dimension::surface_energy, "0"}};
  return inputs;
}

/// Name of an entry of the interface among the inputs of result.json.
std::string result_text(const SolvedCase& solved, const std::string& entry) {
  if (!solved.finished() || !solved.result.contains("inputs")) return "";
  const auto& inputs = solved.result["inputs"];
  for (const auto& [path, name] : {std::pair{"Interface/Friction coefficient", "friction_coefficient"},
                                   std::pair{"Interface/Shear strength", "shear_strength"},
                                   std::pair{"Interface/Work of adhesion", "work_of_adhesion"}})
    if (entry == path && inputs.contains(name)) return inputs[name].dump();
  return "";
}

std::string without_blanks(std::string text) {
  text.erase(std::remove_if(text.begin(), text.end(), [](unsigned char c) { return std::isspace(c); }),
             text.end());
  return text;
}

std::vector<std::pair<std::string, std::string>> inputs_without_seeds(const SolvedCase& solved) {
  std::vector<std::pair<std::string, std::string>> inputs;
  for (const auto& input : number_inputs()) {
    std::string text = solved.entries.text(input.entry, result_text(solved, input.entry));
    if (text.empty()) text = input.otherwise;
    try {
      constexpr int digits = 6;
      inputs.emplace_back(input.entry,
                          format_quantity(parse_quantity(text, input.dimension), input.dimension, digits));
    } catch (const InputError& error) {
      throw InputError(solved.folder.string() + ": " + input.entry + ": " + error.what());
    }
  }
  for (const char* body : {"Particle", "Substrate"}) {
    const std::string section = body;
    inputs.emplace_back(section + "/Hardening", solved.entries.text(section + "/Hardening", "isotropic"));
    inputs.emplace_back(section + "/Topography", surface_without_seed(without_blanks(solved.entries.text(section + "/Topography", "smooth"))));
  }
  return inputs;
}

class Collector {
 public:
  void add(const fs::path& folder) {
    if (is_study_folder(folder)) {
      CaseCollection study = collect_cases({folder});
      for (const auto& missing : study.missing)
        found_.remarks.push_back((folder / missing.name).string() + ": not solved (" + missing.state +
                                 "); left out");
      for (auto& group : study.groups)
        for (auto& solved : group.cases) add_case(std::move(solved));
    } else if (is_case_folder(folder)) {
      add_case(read_solved_case(folder));
    } else {
      add_folders_within(folder);
    }
  }

  ParameterSets finish() {
    if (found_.sets.empty()) {
      std::string reasons;
      for (const auto& sentence : found_.remarks) reasons += (reasons.empty() ? "" : "; ") + sentence;
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
    for (std::size_t i = 0; i < one.inputs.size(); ++i)
      if (!is_friction(one.inputs[i].first) && one.inputs[i] != other.inputs[i]) return false;
    return true;
  }
  static bool is_frictionless_loading(const ParameterSet& set) {
    for (const auto& [entry, value] : set.inputs)
      if (is_friction(entry) && value.find_first_of("123456789") != std::string::npos) return false;
    return std::all_of(set.cases.begin(), set.cases.end(),
                       [](const SolvedCase& solved) { return experiment_of(solved) == "normal"; });
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
      throw InputError(
          folder.string() +
          ": holds neither a solved case (history.csv), nor a study (study.json), nor folders of "
          "such; name folders that 'asperity solve' or 'asperity study' wrote");
    std::sort(inside.begin(), inside.end());
    for (const auto& path : inside) add(path);
  }

  void add_case(SolvedCase solved) {
    const std::string name = solved.folder.string();
    if (!known_.insert(fs::canonical(solved.folder).string()).second) {
      found_.remarks.push_back(name + ": named twice; counted once");
      return;
    }
    if (!solved.finished()) {
      found_.remarks.push_back(name + ": not finished (result.json is missing or not complete); left out");
      return;
    }
    if (solved.history.size() == 0) {
      found_.remarks.push_back(name + ": its history.csv has no rows; left out");
      return;
    }
    auto inputs = inputs_without_seeds(solved);
    for (auto& set : found_.sets)
      if (set.inputs == inputs) {
        set.cases.push_back(std::move(solved));
        return;
      }
    found_.sets.push_back({std::move(inputs), {}});
    found_.sets.back().cases.push_back(std::move(solved));
  }

  ParameterSets found_;
  std::set<std::string> known_;
};

}  // namespace

ParameterSets collect_parameter_sets(const std::vector<fs::path>& folders) {
  Collector collector;
  for (const auto& folder : folders) collector.add(folder);
  return collector.finish();
}

std::string differences(const std::vector<ParameterSet>& sets) {
  std::string text;
  for (std::size_t i = 0; i < sets.front().inputs.size(); ++i) {
    std::vector<std::string> values;
    for (const auto& set : sets)
      if (std::find(values.begin(), values.end(), set.inputs[i].second) == values.end())
        values.push_back(set.inputs[i].second);
    if (values.size() < 2) continue;
    text += (text.empty() ? "" : "; ") + sets.front().inputs[i].first + ": ";
    for (std::size_t k = 0; k < values.size(); ++k) text += (k ? ", " : "") + values[k];
  }
  return text;
}

std::string experiment_of(const SolvedCase& solved) {
  return solved.finished() && solved.result.contains("experiment") && solved.result["experiment"].is_string()
             ? solved.result["experiment"].get<std::string>()
             : solved.entries.text("Experiment/Type", "normal");
}

std::string realisation_of(const SolvedCase& solved) {
  return without_blanks(solved.entries.text("Particle/Topography", "smooth") + " on " +
                        solved.entries.text("Substrate/Topography", "smooth"));
}

}  // namespace asperity
