#include "dem_compare/cases/half_space_surfaces.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/atomic_file.h"
#include "core/double_sampling.h"
#include "core/error.h"
#include "dem_compare/cases/path_averages.h"
#include "dem_compare/numbers/statistics.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Solved cases of one cell of a study's matrix, with what half-spaces say of the same.
struct Cell {
  fs::path previews;
  std::string values;  ///< of the study's axes
  std::vector<std::string> solved;
  std::vector<double> elements, half_spaces, relative_sds;
  double load, spacing;  ///< of the first solved case
};

bool is_preview(const json& previewed) {
  const auto has = [&](const char* name, bool (json::*is)() const noexcept) {
    return previewed.contains(name) && (previewed[name].*is)();
  };
  return previewed.is_object() && has("name", &json::is_string) && has("inputs_sha256", &json::is_string) &&
         has("values", &json::is_object) && has("realisation", &json::is_number_integer) &&
         has("half_spaces", &json::is_object);
}

/// NaN where the case does not state it.
double number_of(const json& previewed, const std::string& name) {
  const json& numbers = previewed["half_spaces"];
  if (!numbers.contains(name)) return std::nan("");
  const json& number = numbers[name];
  return number.contains("value") && number["value"].is_number() ? number["value"].get<double>()
                                                                 : std::nan("");
}

/// What is the same for one surface at all loads.
std::string key_without_load(const json& previewed) {
  json values = previewed["values"];
  values.erase("Normal load");
  return values.dump() + " " + previewed["realisation"].dump();
}

/// Hertz' law with an offset through the smallest and the largest load of each surface, into the preview of
/// the largest: E* but for a factor that all share, [N/m^(3/2)].
void add_moduli(json& cases) {
  std::map<std::string, std::pair<json*, json*>> ends;  // smallest and largest load
  for (json& previewed : cases) {
    const double force = number_of(previewed, "normal_force");
    if (!(force > 0)) continue;
    auto& [low, high] = ends.insert({key_without_load(previewed), {&previewed, &previewed}}).first->second;
    if (force < number_of(*low, "normal_force")) low = &previewed;
    if (force > number_of(*high, "normal_force")) high = &previewed;
  }
  for (const auto& [key, end] : ends) {
    const auto force = [](const json& previewed) {
      return std::pow(number_of(previewed, "normal_force"), 2.0 / 3);
    };
    const double pressed = number_of(*end.second, "approach") - number_of(*end.first, "approach"),
                 slope = (force(*end.second) - force(*end.first)) / pressed;
    if (pressed > 0) (*end.second)["half_spaces"][modulus_by_half_spaces] = {{"value", std::pow(slope, 1.5)}};
  }
}

json cases_in(const fs::path& file) {
  json all = json::parse(read_file(file), nullptr, false);
  if (!all.is_object() || !all.contains("format") || all["format"] != "asperity-previews/1" ||
      !all.contains("cases") || !all["cases"].is_array() ||
      !std::all_of(all["cases"].begin(), all["cases"].end(), is_preview))
    throw InputError(file.string() +
                     " holds no previews of a study; 'asperity study --preview' writes it anew");
  add_moduli(all["cases"]);
  return all["cases"];
}

void require_same_inputs(const json& previewed, const SolvedCase& solved, const fs::path& file) {
  const std::string solved_inputs = solved.result->document.value("inputs_sha256", ""),
                    here = previewed["inputs_sha256"];
  if (!solved_inputs.empty() && solved_inputs != here)
    throw InputError(file.string() + ": its case " + solved.folder.filename().string() +
                     " is of other inputs than the solved one; 'asperity study --preview' previews it anew");
}

/// Cells with a preview of a solved case.
std::vector<Cell> cells_of(const std::vector<SolvedNumber>& numbers, const std::string& name,
                           std::map<fs::path, json>& previews) {
  std::vector<Cell> cells;
  for (const SolvedNumber& number : numbers) {
    const SolvedCase& solved = *number.solved;
    const fs::path file = solved.folder.parent_path() / "previews.json";
    if (!fs::is_regular_file(file)) continue;
    if (!previews.count(file)) previews[file] = cases_in(file);
    for (const json& previewed : previews[file]) {
      if (previewed["name"] != solved.folder.filename().string()) continue;
      const double by_half_spaces = number_of(previewed, name);
      if (!(by_half_spaces > 0)) break;
      require_same_inputs(previewed, solved, file);
      const std::string values = previewed["values"].dump();
      auto cell = std::find_if(cells.begin(), cells.end(), [&](const Cell& other) {
        return other.previews == file && other.values == values;
      });
      if (cell == cells.end())
        cell = cells.insert(cell, {file, values, {}, {}, {}, {}, number.load, solved.interface_spacing()});
      cell->solved.push_back(solved.folder.filename().string());
      cell->elements.push_back(number.value);
      cell->half_spaces.push_back(by_half_spaces);
      if (std::isfinite(number.sd)) cell->relative_sds.push_back(number.sd / number.value);
    }
  }
  return cells;
}

}  // namespace

std::vector<CaseNumber> by_half_spaces(const std::vector<SolvedNumber>& solved, const std::string& name) {
  std::map<fs::path, json> previews;
  std::vector<CaseNumber> numbers;
  for (const Cell& cell : cells_of(solved, name, previews)) {
    if (cell.elements.size() < 2) continue;
    const MethodRatio both = method_ratio(cell.half_spaces, cell.elements);
    const auto degrees = static_cast<double>(cell.elements.size() - 1);
    const double of_ratio = student_factor(degrees) * both.sd / scatter_of(cell.elements).mean,
                 of_cases = cell.relative_sds.empty() ? 0 : scatter_of(cell.relative_sds).mean;
    for (const json& previewed : previews[cell.previews]) {
      const double value = both.ratio * number_of(previewed, name);
      const bool is_solved =
          std::find(cell.solved.begin(), cell.solved.end(), previewed["name"]) != cell.solved.end();
      if (is_solved || !(value > 0) || previewed["values"].dump() != cell.values) continue;
      numbers.push_back({cell.load, "surface " + std::to_string(previewed["realisation"].get<int>()),
                         cell.spacing, value, std::hypot(of_ratio, of_cases) * value, of_ratio * value,
                         true});
    }
  }
  return numbers;
}

}  // namespace asperity
