#include "diagnosis/conceal/truth.h"

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/json_text.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;
constexpr const char* truth_format = "asperity-truth/1";
constexpr const char* file_name = "truth.json";

}  // namespace

std::string family_named(const std::string& name) { return name == "outsider" ? out_of_catalogue : name; }

void write_truth(const Truth& truth, const std::filesystem::path& folder) {
  Json json;
  json["format"] = truth_format;
  json["family"] = truth.family;
  json["effects"] = Json::array();
  for (const auto& effect : truth.effects) {
    Json parameters = Json::object();
    for (const auto& [name, parameter] : effect.parameters)
      parameters[name] = {{"value", parameter.value}, {"is_the_catalogues", parameter.is_the_catalogues}};
    json["effects"].push_back({{"id", effect.id},
                               {"in_catalogue", effect.in_catalogue},
                               {"model", effect.model},
                               {"parameters", parameters}});
  }
  json["cannot_be_told_from"] = truth.cannot_be_told_from;
  json["noise"] = truth.noise;
  json["noise_model"] = truth.noise_model;
  json["seed"] = truth.seed;
  json["coefficients"] = Json::object();
  for (const auto& [name, value] : truth.coefficients) json["coefficients"][name] = value;
  json["contributions"] = Json::array();
  for (const auto& contribution : truth.contributions)
    json["contributions"].push_back({{"table", contribution.table}, {"in_noise", contribution.in_noise}});
  write_file_atomically(folder / file_name, json.dump(1) + "\n");
}

Truth read_truth(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / file_name;
  Truth truth;
  try {
    const Json json = parse_json(read_file(file), file.string());
    if (json.at("format") != truth_format)
      throw InputError(file.string() + ": 'format' is not '" + truth_format + "'");
    truth.family = family_named(json.at("family"));
    for (const auto& entry : json.at("effects")) {
      TrueEffect effect;
      effect.id = entry.at("id");
      effect.in_catalogue = entry.at("in_catalogue");
      effect.model = entry.at("model");
      for (const auto& item : entry.at("parameters").items())
        effect.parameters[item.key()] = {item.value().at("value"), item.value().at("is_the_catalogues")};
      truth.effects.push_back(effect);
    }
    truth.cannot_be_told_from = json.at("cannot_be_told_from").get<std::vector<std::string>>();
    truth.noise = json.at("noise");
    truth.noise_model = json.at("noise_model");
    truth.seed = json.at("seed");
    for (const auto& item : json.at("coefficients").items()) truth.coefficients[item.key()] = item.value();
    for (const auto& entry : json.at("contributions"))
      truth.contributions.push_back({entry.at("table"), entry.at("in_noise").get<std::vector<double>>()});
  } catch (const nlohmann::json::exception& error) {
    throw InputError(file.string() + ": " + error.what());
  }
  return truth;
}

}  // namespace asperity
