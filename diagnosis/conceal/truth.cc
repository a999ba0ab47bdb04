#include "diagnosis/conceal/truth.h"

#include <nlohmann/json.hpp>

#include "core/atomic_file.h"

namespace asperity {

std::string family_named(const std::string& name) { return name == "outsider" ? out_of_catalogue : name; }

void write_truth(const Truth& truth, const std::filesystem::path& folder) {
  using Json = nlohmann::ordered_json;
  Json json;
  json["format"] = "asperity-truth/1";
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
  write_file_atomically(folder / "truth.json", json.dump(1) + "\n");
}

}  // namespace asperity
