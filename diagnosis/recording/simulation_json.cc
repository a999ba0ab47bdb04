#include "diagnosis/recording/simulation_json.h"

#include <algorithm>
#include <filesystem>

#include "core/printed.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

/// A file or folder that lies with the recording: a recording from elsewhere names nothing outside.
std::string beside(const Json& json, const char* key, const std::string& file) {
  std::string name = text_of(json, key, "", file);
  const fs::path path(name);
  if (json.contains(key) &&
      (name.empty() || path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end()))
    refuse(file, "'simulation/" + std::string(key) +
                     "' is not a path below the recording's folder; copy it "
                     "there, or name it on the command line (--" +
                     key + ")");
  return name;
}

/// Values of entries of a case.
std::map<std::string, std::string> case_entries_of(const Json& parameters, const std::string& file) {
  std::map<std::string, std::string> entries;
  if (!parameters.is_object()) refuse(file, "'parameters' is not an object { }");
  for (const auto& item : parameters.items()) {
    const std::string& name = item.key();
    Json value = item.value();
    if (name.find('/') == std::string::npos)
      refuse(file, "'" + name + "' is no entry of a case, such as \"Interface/Friction coefficient\"");
    if (value.is_object()) {
      check_keys(value, {"value", "calibrate"}, name, file);
      if (value.contains("calibrate") && value["calibrate"] != false)
        refuse(file, "'" + name +
                         "' is to be calibrated, and entries of a case are taken as given so far; "
                         "give its value, and what differs is searched for among the effects");
      if (!value.contains("value")) refuse(file, "parameter '" + name + "' lacks its 'value'");
      value = Json(value["value"]);
    }
    if (!value.is_string() && !value.is_number())
      refuse(file, "'" + name + "' is not a number or a text with a unit");
    entries[name] = value.is_string() ? value.get<std::string>() : printed("%.10g", value.get<double>());
  }
  return entries;
}

SimulationChoice simulation_by_case(const Json& json, const std::string& file) {
  check_keys(json, {"case", "study", "parameters"}, "simulation by finite elements", file);
  SimulationChoice choice;
  choice.case_file = beside(json, "case", file);
  choice.study = beside(json, "study", file);
  if (json.contains("parameters")) choice.case_entries = case_entries_of(json["parameters"], file);
  return choice;
}

}  // namespace

SimulationChoice simulation_of(const Json& json, const std::string& file) {
  if (json.is_object() && (json.contains("case") || json.contains("study")))
    return simulation_by_case(json, file);
  check_keys(json, {"normal", "sliding", "rolling", "torsion", "parameters"}, "simulation", file);
  SimulationChoice choice;
  choice.normal = text_of(json, "normal", choice.normal, file);
  choice.sliding = text_of(json, "sliding", choice.sliding, file);
  choice.rolling = text_of(json, "rolling", choice.rolling, file);
  choice.torsion = text_of(json, "torsion", choice.torsion, file);
  if (!json.contains("parameters")) return choice;
  for (const auto& item : json["parameters"].items()) {
    const Json& entry = item.value();
    SimulationParameter parameter;
    if (entry.is_object()) {
      check_keys(entry, {"value", "calibrate"}, item.key(), file);
      if (!entry.contains("value")) refuse(file, "parameter '" + item.key() + "' lacks its 'value'");
      parameter.value = quantity_of(entry["value"], Dimension::none, item.key(), file);
      if (entry.contains("calibrate")) {
        if (!entry["calibrate"].is_boolean())
          refuse(file, "'calibrate' of '" + item.key() + "' is neither true nor false");
        parameter.calibrate = entry["calibrate"].get<bool>();
      }
    } else {
      parameter.value = quantity_of(entry, Dimension::none, item.key(), file);
    }
    choice.parameters[item.key()] = parameter;
  }
  return choice;
}

Json simulation_json(const SimulationChoice& choice) {
  if (choice.by_finite_elements()) {
    Json json = Json::object();
    if (!choice.case_file.empty()) json["case"] = choice.case_file;
    if (!choice.study.empty()) json["study"] = choice.study;
    json["parameters"] = choice.case_entries;
    return json;
  }
  Json parameters = Json::object();
  for (const auto& [name, parameter] : choice.parameters)
    parameters[name] = {{"value", parameter.value}, {"calibrate", parameter.calibrate}};
  return {{"normal", choice.normal},
          {"sliding", choice.sliding},
          {"rolling", choice.rolling},
          {"torsion", choice.torsion},
          {"parameters", parameters}};
}

}  // namespace asperity
