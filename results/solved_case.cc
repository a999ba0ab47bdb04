#include "results/solved_case.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/json_text.h"
#include "core/parameter_file.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Entries = std::map<std::string, std::string>;

/// Names that `inputs` of result.json has for entries of a case file.
const std::vector<std::pair<const char*, const char*>>& result_names() {
  static const std::vector<std::pair<const char*, const char*>> names{
      {"youngs_modulus", "Young modulus"},   {"poissons_ratio", "Poisson ratio"},
      {"yield_stress", "Yield stress"},      {"hardening_modulus", "Hardening modulus"},
      {"hardening", "Hardening"},            {"voce_saturation", "Voce saturation"},
      {"voce_rate", "Voce rate"},            {"topography", "Topography"}};
  return names;
}

std::string entry_text(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

/// Inputs of a result as entries; a number is in SI units.
void add_result_inputs(const Json& result, Entries& entries) {
  const Json inputs = result.value("inputs", Json::object());
  for (const auto& [body, section] : {std::pair{"particle", "Particle/"}, std::pair{"substrate", "Substrate/"}})
    for (const auto& [name, entry] : result_names())
      if (inputs.contains(body) && inputs[body].contains(name)) entries[std::string(section) + entry] = entry_text(inputs[body][name]);
  if (inputs.contains("radius")) entries["Particle/Radius"] = entry_text(inputs["radius"]);
  if (inputs.contains("largest_load")) entries["Experiment/Normal load"] = entry_text(inputs["largest_load"]);
  if (inputs.contains("control")) entries["Experiment/Control"] = entry_text(inputs["control"]);
  for (const auto& [name, entry] : {std::pair{"friction_coefficient", "Friction coefficient"}, std::pair{"shear_strength", "Shear strength"},
                                    std::pair{"work_of_adhesion", "Work of adhesion"}, std::pair{"opening_work", "Opening work"},
                                    std::pair{"adhesion_law", "Adhesion law"}, std::pair{"adhesion_range", "Adhesion range"}})
    if (inputs.contains(name)) entries[std::string("Interface/") + entry] = entry_text(inputs[name]);
  if (!result.value("title", "").empty()) entries["Title"] = result["title"].get<std::string>();
}

/// What was solved, as it was written: case.prm beside it may have been changed since.
std::vector<std::string> add_listed_entries(const Json& result, Entries& entries) {
  std::vector<std::string> listed;
  if (!result.contains("inputs") || !result["inputs"].contains("entries") || !result["inputs"]["entries"].is_object()) return listed;
  for (const auto& [path, text] : result["inputs"]["entries"].items()) {
    entries[path] = entry_text(text);
    listed.push_back(path);
  }
  return listed;
}

/// Parts of a result that are of one kind or missing.
void check_kinds(const Json& result, const fs::path& file) {
  const auto check = [&](std::initializer_list<const char*> names, bool (Json::*is_kind)() const noexcept, const char* kind) {
    for (const char* name : names)
      if (result.contains(name) && !(result[name].*is_kind)())
        throw InputError(file.string() + ": '" + name + "' is no " + kind + "; solve the case again, or remove the file");
  };
  check({"format", "title", "experiment", "commit", "inputs_sha256"}, &Json::is_string, "text");
  check({"inputs", "hertz", "mesh", "effective", "balance", "cost", "versions"}, &Json::is_object, "object");
  check({"complete"}, &Json::is_boolean, "true or false");
}

Json read_result(const fs::path& file) {
  if (!fs::exists(file)) return nullptr;
  Json result = json_if_valid(read_file(file));
  if (!result.is_object())
    throw InputError(file.string() + ": is not valid JSON; solve the case again, or remove the file");
  check_kinds(result, file);
  if (result.value("format", "") != "asperity-result/1")
    throw InputError(file.string() + ": has the format '" + result.value("format", "") +
                     "' where this program reads 'asperity-result/1'");
  return result.value("complete", true) ? result : Json(nullptr);
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

std::string SolvedCase::title() const {
  const std::string name = entries.text("Title");
  return name.empty() || name == "untitled" ? fs::absolute(folder).lexically_normal().filename().string() : name;
}

ElasticBody SolvedCase::body(const std::string& section) const {
  return {entries.quantity(section + "/Young modulus", Dimension::pressure),
          entries.quantity(section + "/Poisson ratio", Dimension::none)};
}

double SolvedCase::yield_stress(const std::string& section) const {
  return entries.quantity(section + "/Yield stress", Dimension::pressure, std::numeric_limits<double>::infinity());
}

Hertz SolvedCase::hertz() const {
  return {reduced_modulus(particle(), substrate()), entries.quantity("Particle/Radius", Dimension::length)};
}

double SolvedCase::first_yield_force() const {
  return std::min(hertz().first_yield_force(particle().poisson_ratio, yield_stress("Particle")),
                  hertz().first_yield_force(substrate().poisson_ratio, yield_stress("Substrate")));
}

bool SolvedCase::is_rough() const {
  return entries.text("Particle/Topography", "smooth") != "smooth" ||
         entries.text("Substrate/Topography", "smooth") != "smooth";
}

bool SolvedCase::can_yield() const {
  return std::isfinite(yield_stress("Particle")) || std::isfinite(yield_stress("Substrate"));
}

double SolvedCase::interface_spacing() const {
  if (finished() && result.contains("mesh") && result["mesh"].contains("interface_spacing")) {
    const Json& spacing = result["mesh"]["interface_spacing"];
    if (spacing.is_number()) return spacing.get<double>();
    if (spacing.is_object() && spacing.contains("value") && spacing["value"].is_number()) return spacing["value"].get<double>();
  }
  const double asked = entries.quantity("Mesh/Interface spacing", Dimension::length, 0);
  return asked > 0 ? asked : std::numeric_limits<double>::quiet_NaN();
}

double SolvedCase::open_energy() const {
  if (!finished() || !result.contains("balance") || !result["balance"].contains("energy")) return std::numeric_limits<double>::quiet_NaN();
  const Json& energy = result["balance"]["energy"];
  const Json& value = energy.is_object() && energy.contains("value") ? energy["value"] : energy;
  return value.is_number() ? std::abs(value.get<double>()) : std::numeric_limits<double>::quiet_NaN();
}

EffectiveNumber SolvedCase::effective(const char* name) const {
  const double none = std::numeric_limits<double>::quiet_NaN();
  if (!finished() || !result.contains("effective") || !result["effective"].contains(name)) return {none, none};
  const Json& entry = result["effective"][name];
  const auto number = [&](const char* key) { return entry.contains(key) && entry[key].is_number() ? entry[key].get<double>() : none; };
  return {number("value"), number("sd")};
}

bool is_case_folder(const fs::path& folder) { return fs::exists(folder / "history.csv"); }

SolvedCase read_solved_case(const fs::path& folder) {
  if (!is_case_folder(folder))
    throw InputError(folder.string() + ": there is no history.csv; name a folder that 'asperity solve' wrote");
  SolvedCase solved;
  solved.folder = folder;
  solved.history = read_history(folder / "history.csv");
  solved.result = read_result(folder / "result.json");
  Entries entries;
  if (solved.finished()) add_result_inputs(solved.result, entries);
  // What people wrote reads better than SI numbers, and says more.
  if (fs::exists(folder / "case.prm"))
    for (const auto& setting : read_settings(folder / "case.prm")) entries[setting.path()] = setting.value;
  if (solved.finished()) solved.physical_entries = add_listed_entries(solved.result, entries);
  solved.entries = CaseEntries(std::move(entries));
  try {
    solved.hertz();
  } catch (const InputError& error) {
    throw InputError(folder.string() + ": " + error.what() + "; result.json or case.prm must say it");
  }
  return solved;
}

}  // namespace asperity
