#include "app/study_preview.h"

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <limits>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <thread>
#include <utility>

#include "app/inputs_hash.h"
#include "core/atomic_file.h"
#include "core/csv.h"
#include "core/double_sampling.h"
#include "core/error.h"
#include "core/output_folder.h"
#include "results/case_result.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
constexpr std::size_t every_so_many = 20;  ///< cases a line of progress

/// Whether each number is one, with a unit; one that is not known is null.
bool holds_numbers(const Json& numbers) {
  return numbers.is_object() && std::all_of(numbers.begin(), numbers.end(), [](const Json& number) {
           return number.is_object() && number.contains("value") && number.contains("unit") &&
                  (number["value"].is_number() || number["value"].is_null()) && number["unit"].is_string();
         });
}

/// The preview of these inputs that an earlier run has left; nothing where there is none, or a damaged one.
std::optional<Json> earlier_preview(const fs::path& file, const std::string& inputs) {
  if (!fs::is_regular_file(file)) return std::nullopt;
  const Json found = Json::parse(read_file(file), nullptr, false);
  if (!found.is_object() || !found.contains("elastic") || !holds_numbers(found["elastic"]) ||
      !found.contains("inputs_sha256") || found["inputs_sha256"] != inputs)
    return std::nullopt;
  return found;
}

Json previewed(const StudyCase& item, const StudyPreviewOptions& options, const std::string& inputs) {
  Json preview = Json::parse(options.preview(item));
  preview["inputs_sha256"] = inputs;
  return preview;
}

/// Calls work(0) to work(count - 1), so many at the same time on a thread each. Throws what the first call
/// that throws does, once all threads have ended.
void side_by_side(std::size_t count, std::size_t at_a_time, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex guard;
  const auto run = [&] {
    omp_set_num_threads(1);
    for (std::size_t i = next++; i < count; i = next++) try {
        work(i);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(guard);
        if (!failure) failure = std::current_exception();
        next = count;
      }
  };
  std::vector<std::thread> threads;
  for (std::size_t n = 0; n < std::min(at_a_time, count); ++n) threads.emplace_back(run);
  for (auto& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
}

/// Of each case, those that are not chosen without one.
std::vector<std::optional<Json>> previews_of(const Study& study, const StudyPreviewOptions& options) {
  std::vector<std::optional<Json>> previews(study.cases.size());
  std::mutex guard;
  std::size_t done = 0;
  const std::size_t at_a_time = options.parallel > 0 ? static_cast<std::size_t>(options.parallel)
                                                     : std::max(1u, std::thread::hardware_concurrency());
  side_by_side(study.cases.size(), at_a_time, [&](std::size_t i) {
    const StudyCase& item = study.cases[i];
    const fs::path file = options.output / "previews" / (item.name + ".json");
    const std::string inputs = inputs_sha256(item.settings, study.file);
    previews[i] = earlier_preview(file, inputs);
    if (previews[i] || !options.chosen(item.name)) return;
    try {
      previews[i] = previewed(item, options, inputs);
    } catch (const InputError& error) {
      throw InputError(std::string(error.what()) + " (case " + item.name + ")");
    }
    write_file_atomically(file, previews[i]->dump(1) + "\n");
    const std::lock_guard<std::mutex> lock(guard);
    if (options.say && ++done % every_so_many == 0)
      options.say(std::to_string(done) + " cases previewed, of " + std::to_string(study.cases.size()) +
                  " with those of earlier runs");
  });
  return previews;
}

/// One number of one cell of the matrix, over its realisations.
struct Quantity {
  std::string unit;
  std::vector<double> all, half_spaces, elements;

  Json json() const {
    double mean = 0, squares = 0;
    const auto count = static_cast<double>(all.size());
    for (const double value : all) mean += value / count;
    for (const double value : all) squares += (value - mean) * (value - mean);
    Json object{{"value", mean}, {"unit", unit}, {"count", all.size()}};
    if (all.size() > 1) object["realisation_sd"] = std::sqrt(squares / (count - 1));
    if (elements.size() < 2 || std::accumulate(half_spaces.begin(), half_spaces.end(), 0.0) == 0)
      return object;
    const SampledMean both = mean_by_double_sampling(all, half_spaces, elements);
    object["with_finite_elements"] = {
        {"value", both.value}, {"sd_of_mean", both.sd}, {"count", elements.size()}};
    return object;
  }
};

using Quantities = std::vector<std::pair<std::string, Quantity>>;

Quantity& named(Quantities& quantities, const std::string& name) {
  for (auto& [known, quantity] : quantities)
    if (known == name) return quantity;
  return quantities.emplace_back(name, Quantity{}).second;
}

Json values_of(const Study& study, const StudyCase& item) {
  Json object = Json::object();
  for (std::size_t i = 0; i < study.axes.size(); ++i) object[study.axes[i].name] = item.labels[i];
  return object;
}

/// The result in a case's folder, if it is of these inputs; one of others is counted.
std::optional<CaseResult> solved_case(const fs::path& folder, const std::string& inputs, int& others) {
  if (!fs::is_regular_file(folder / "result.json")) return std::nullopt;
  auto solved = read_case_result(folder / "result.json");
  const auto said = solved ? solved->document.find("inputs_sha256") : Json::iterator();
  if (!solved || said == solved->document.end() || *said == inputs) return solved;
  ++others;
  return std::nullopt;
}

/// Of all cases; what solved ones say goes beside it. others: solved cases of other inputs, which do not
/// count.
Json summary_of(const Study& study, const std::vector<std::optional<Json>>& previews, const fs::path& output,
                int& others) {
  std::vector<std::pair<std::size_t, Quantities>> groups;  // first case of each
  std::map<std::vector<std::string>, std::size_t> group_of;
  Json cases = Json::array();
  for (std::size_t i = 0; i < study.cases.size(); ++i) {
    const StudyCase& item = study.cases[i];
    if (!previews[i]) continue;
    const auto [found, is_new] = group_of.emplace(item.labels, groups.size());
    if (is_new) groups.push_back({i, {}});
    const Json& numbers = (*previews[i])["elastic"];
    cases.push_back({{"name", item.name},
                     {"values", values_of(study, item)},
                     {"realisation", item.realisation},
                     {"inputs_sha256", (*previews[i])["inputs_sha256"]},
                     {"half_spaces", numbers}});
    const auto solved = solved_case(output / item.name, (*previews[i])["inputs_sha256"], others);
    for (const auto& [name, number] : numbers.items()) {
      if (!number["value"].is_number()) continue;
      Quantity& quantity = named(groups[found->second].second, name);
      quantity.unit = number["unit"];
      quantity.all.push_back(number["value"]);
      if (!solved || !solved->has(name) || std::isnan(solved->effective_number(name).value)) continue;
      quantity.half_spaces.push_back(number["value"]);
      quantity.elements.push_back(solved->effective_number(name).value);
    }
  }
  Json list = Json::array();
  for (const auto& [first, quantities] : groups) {
    Json numbers = Json::object();
    for (const auto& [name, quantity] : quantities) numbers[name] = quantity.json();
    list.push_back({{"values", values_of(study, study.cases[first])},
                    {"realisations", quantities.empty() ? 0 : quantities.front().second.all.size()},
                    {"half_spaces", numbers}});
  }
  return {{"format", "asperity-previews/1"},
          {"title", study.title},
          {"file", study.file.filename().string()},
          {"cases", cases},
          {"groups", list}};
}

/// A row for each cell of the matrix.
std::string csv_of(const Study& study, const Json& groups) {
  std::vector<std::pair<std::string, std::string>> columns;  // number and unit
  for (const auto& group : groups)
    for (const auto& [name, number] : group["half_spaces"].items()) {
      const std::pair<std::string, std::string> column{name, number["unit"]};
      if (std::find(columns.begin(), columns.end(), column) == columns.end()) columns.push_back(column);
    }
  std::string text;
  for (const auto& axis : study.axes) text += csv_cell(axis.name) + ",";
  text += "realisations";
  for (const auto& [name, unit] : columns)
    for (const char* what : {"", "_realisation_sd", "_with_finite_elements", "_with_finite_elements_sd"})
      text += "," + name + what + (unit.empty() ? "" : " [" + unit + "]");
  text += "\n";
  for (const auto& group : groups) {
    for (const auto& axis : study.axes) text += csv_cell(group["values"][axis.name].get<std::string>()) + ",";
    text += std::to_string(group["realisations"].get<std::size_t>());
    for (const auto& [name, unit] : columns) {
      const Json number = group["half_spaces"].value(name, Json::object());
      const Json both = number.value("with_finite_elements", Json::object());
      for (const auto& [of, key] : {std::pair{&number, "value"}, std::pair{&number, "realisation_sd"},
                                    std::pair{&both, "value"}, std::pair{&both, "sd_of_mean"}})
        text += "," + csv_cell(of->value(key, std::numeric_limits<double>::quiet_NaN()));
    }
    text += "\n";
  }
  return text;
}

}  // namespace

void preview_study(const Study& study, const StudyPreviewOptions& options) {
  make_folder(options.output);
  make_folder(options.output / "previews");
  const auto previews = previews_of(study, options);
  int others = 0;
  const Json summary = summary_of(study, previews, options.output, others);
  if (others > 0 && options.say)
    options.say(std::to_string(others) + " solved cases in " + options.output.string() +
                " are of other inputs than their previews, and do not count");
  write_file_atomically(options.output / "previews.json", summary.dump(1) + "\n");
  write_file_atomically(options.output / "previews.csv", csv_of(study, summary["groups"]));
  if (options.say)
    options.say(std::to_string(summary["cases"].size()) + " of " + std::to_string(study.cases.size()) +
                " cases previewed by half-spaces; means over surfaces: " +
                (options.output / "previews.csv").string());
}

}  // namespace asperity
