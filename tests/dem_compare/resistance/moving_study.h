// A study folder of moving cases made from known powers.
#pragma once

#include <string>
#include <vector>

#include "dem_compare/cases/case_collection.h"
#include "tests/dem_compare/resistance/moving_folder.h"

namespace asperity::test {

struct StudyEntry {
  std::string surface;  ///< label of the variant
  MovingFolder made;
};

/// Axes: Type, Normal load, Variant; the realisation is the seed.
inline std::filesystem::path write_moving_study(const std::filesystem::path& root,
                                                const std::vector<StudyEntry>& entries) {
  const auto load_of = [](const MovingFolder& made) {
    std::ostringstream text;
    text << made.load * 1e6 << " uN";
    return text.str();
  };
  std::vector<std::string> labels[3];
  nlohmann::ordered_json cases = nlohmann::ordered_json::array();
  int number = 0;
  for (const auto& [surface, made] : entries) {
    const std::string values[3] = {made.experiment, load_of(made), surface};
    for (int i = 0; i < 3; ++i)
      if (std::find(labels[i].begin(), labels[i].end(), values[i]) == labels[i].end())
        labels[i].push_back(values[i]);
    const std::string name = "case" + std::to_string(++number);
    write_moving(root / name, made);
    cases.push_back({{"name", name},
                     {"folder", name},
                     {"values", {{"Type", values[0]}, {"Normal load", values[1]}, {"Variant", surface}}},
                     {"realisation", made.seed},
                     {"state", "done"}});
  }
  nlohmann::ordered_json study{{"format", "asperity-study/1"}, {"title", "Moving"}, {"realisations", 1}};
  const char* names[3] = {"Type", "Normal load", "Variant"};
  study["axes"] = nlohmann::ordered_json::array();
  for (int i = 0; i < 3; ++i) study["axes"].push_back({{"name", names[i]}, {"values", labels[i]}});
  study["cases"] = cases;
  write_file_atomically(root / "study.json", study.dump());
  return root;
}

}  // namespace asperity::test
