#include "results/solved_case.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/experiment_declaration.h"
#include "core/json_text.h"
#include "core/parameter_file.h"
#include "core/renamed_entries.h"
#include "results/known_entries.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Entries = std::map<std::string, std::string>;

/// Names that `inputs` of result.json has for entries of a case file.
const std::vector<std::pair<const char*, const char*>>& result_names() {
  static const std::vector<std::pair<const char*, const char*>> names{
      {"youngs_modulus", "Young modulus"}, {"poissons_ratio", "Poisson ratio"},
      {"yield_stress", "Yield stress"},    {"hardening_modulus", "Hardening modulus"},
      {"hardening", "Hardening"},          {"voce_saturation", "Voce saturation"},
      {"voce_rate", "Voce rate"},          {"topography", "Topography"}};
  return names;
}

std::string entry_text(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// Inputs of a result as entries; a number is in SI units.
void add_result_inputs(const CaseResult& result, Entries& entries) {
  const Json inputs = result.document.value("inputs", Json::object());
  for (const auto& [body, section] :
       {std::pair{"particle", "Particle/"}, std::pair{"substrate", "Substrate/"}})
    for (const auto& [name, entry] : result_names())
      if (inputs.contains(body) && inputs[body].contains(name))
        entries[std::string(section) + entry] = entry_text(inputs[body][name]);
  if (inputs.contains("radius")) entries["Particle/Radius"] = entry_text(inputs["radius"]);
  if (inputs.contains("largest_load")) entries["Experiment/Normal load"] = entry_text(inputs["largest_load"]);
  if (inputs.contains("control")) entries["Experiment/Control"] = entry_text(inputs["control"]);
  const std::string section = "Interface/";
  for (const auto* known : {&known_quantities(), &known_words()})
    for (const auto& entry : *known) {
      const std::string path = entry.path;
      if (path.rfind(section, 0) != 0) continue;
      for (const std::string& written : {former_path(path), path}) {
        const std::string name = result_name(written.substr(section.size()));
        if (inputs.contains(name)) entries[path] = entry_text(inputs[name]);
      }
    }
  if (!result.title.empty()) entries["Title"] = result.title;
}

std::vector<std::string> names_of(const std::vector<Addition>& additions) {
  std::vector<std::string> names;
  for (const auto& addition : additions) names.push_back(addition.name);
  return names;
}

}  // namespace

std::string CaseEntries::text(const std::string& path, const std::string& otherwise) const {
  const auto found = entries_.find(path);
  return found == entries_.end() ? otherwise : found->second;
}

double CaseEntries::quantity(const std::string& path, Dimension dimension) const {
  if (!has(path)) throw InputError("the inputs of the case lack the entry " + path);
  return parse_quantity(text(path), dimension);
}

double CaseEntries::quantity(const std::string& path, Dimension dimension, double otherwise) const {
  return has(path) ? quantity(path, dimension) : otherwise;
}

TopographySpec CaseEntries::topography(const std::string& section) const {
  const std::string path = section + "/Topography";
  try {
    return has(path) ? TopographySpec(text(path)) : TopographySpec();
  } catch (const InputError& error) {
    throw InputError(path + " of the solved case: " + error.what());
  }
}

std::string SolvedCase::title() const {
  const std::string name = entries.text("Title");
  return name.empty() || name == "untitled" ? fs::absolute(folder).lexically_normal().filename().string()
                                            : name;
}

ElasticBody SolvedCase::body(const std::string& section) const {
  return {entries.quantity(section + "/Young modulus", Dimension::pressure),
          entries.quantity(section + "/Poisson ratio", Dimension::none)};
}

double SolvedCase::yield_stress(const std::string& section) const {
  return entries.quantity(section + "/Yield stress", Dimension::pressure,
                          std::numeric_limits<double>::infinity());
}

Hertz SolvedCase::hertz() const {
  return {reduced_modulus(particle(), substrate()), entries.quantity("Particle/Radius", Dimension::length)};
}

double SolvedCase::attraction_force() const {
  return entries.quantity("Interface/Attraction force", Dimension::force, 0);
}

double SolvedCase::first_yield_force() const {
  return std::min(hertz().first_yield_force(particle().poisson_ratio, yield_stress("Particle")),
                  hertz().first_yield_force(substrate().poisson_ratio, yield_stress("Substrate")));
}

bool SolvedCase::is_rough() const {
  return !entries.topography("Particle").is_smooth() || !entries.topography("Substrate").is_smooth();
}

bool SolvedCase::can_yield() const {
  return std::isfinite(yield_stress("Particle")) || std::isfinite(yield_stress("Substrate"));
}

bool SolvedCase::relaxes() const {
  for (const char* section : {"Particle", "Substrate"})
    if (entries.quantity(std::string(section) + "/Relaxing share", Dimension::none, 0) > 0) return true;
  return false;
}

double SolvedCase::interface_spacing() const {
  if (finished() && std::isfinite(result->interface_spacing)) return result->interface_spacing;
  const double asked = entries.quantity("Mesh/Interface spacing", Dimension::length, 0);
  return asked > 0 ? asked : std::numeric_limits<double>::quiet_NaN();
}

double SolvedCase::open_energy() const {
  return finished() ? std::abs(result->balance_of("energy")) : std::numeric_limits<double>::quiet_NaN();
}

Motion SolvedCase::motion() const {
  const std::string name = finished() && !result->experiment.empty()
                               ? result->experiment
                               : entries.text("Experiment/Type", "normal");
  const auto motion = is_declared_experiment(name) ? Motion::program : motion_named(name);
  if (!motion)
    throw InputError(folder.string() + ": there is no experiment '" + name +
                     "'; its result.json or case.prm was changed");
  return *motion;
}

bool is_case_folder(const fs::path& folder) { return fs::exists(folder / "history.csv"); }

SolvedCase read_solved_case(const fs::path& folder) {
  if (!is_case_folder(folder))
    throw InputError(folder.string() +
                     ": there is no history.csv; name a folder that 'asperity solve' wrote");
  SolvedCase solved;
  solved.folder = folder;
  solved.history = read_history(folder / "history.csv");
  solved.result = read_case_result(folder / "result.json");
  if (solved.finished() && !solved.result->added_columns.empty())
    solved.history = read_history(folder / "history.csv", names_of(solved.result->added_columns));
  Entries entries;
  if (solved.finished()) add_result_inputs(*solved.result, entries);
  // What people wrote reads better than SI numbers, and says more.
  if (fs::exists(folder / "case.prm"))
    for (const auto& setting : read_settings(folder / "case.prm")) entries[setting.path()] = setting.value;
  // What was solved, as it was written: case.prm beside it may have been changed since.
  if (solved.finished())
    for (const auto& [path, text] : solved.result->physical_entries) entries[path] = text;
  solved.entries = CaseEntries(std::move(entries));
  try {
    solved.hertz();
  } catch (const InputError& error) {
    throw InputError(folder.string() + ": " + error.what() + "; result.json or case.prm must say it");
  }
  return solved;
}

}  // namespace asperity
