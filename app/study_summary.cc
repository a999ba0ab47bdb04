#include "app/study_summary.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/printed.h"
#include "results/case_result.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

using Results = std::vector<std::optional<CaseResult>>;

/// result.json of a case; nothing if it is missing, cut off, of another format, or says that it is not
/// complete.
std::optional<CaseResult> read_result(const fs::path& folder) {
  try {
    return fs::is_regular_file(folder / "result.json") ? read_case_result(folder / "result.json")
                                                       : std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::string word_for(CaseProgress::State state) {
  switch (state) {
    case CaseProgress::State::waiting:
      return "waiting";
    case CaseProgress::State::running:
      return "running";
    case CaseProgress::State::done:
      return "done";
    case CaseProgress::State::failed:
      return "failed";
    case CaseProgress::State::stopped:
      return "stopped";
  }
  return "";
}

std::string quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
  std::string text = "\"";
  for (const char c : cell) text += c == '"' ? '\'' : c == '\n' ? ' ' : c;
  return text + "\"";
}

/// Nothing for NaN.
std::string number(double value) { return std::isnan(value) ? "" : printed("%.9g", value); }

/// An effective quantity over the realisations of one cell of the matrix.
class Scatter {
 public:
  void add(const EffectiveNumber& number) {
    if (std::isnan(number.value)) return;
    unit_ = number.unit;
    values_.push_back(number.value);
    if (!std::isnan(number.sd)) case_sds_.push_back(number.sd);
  }

  /// Mean over realisations; `realisation_sd` their sample standard deviation, `case_sd` the mean of the
  /// cases' own.
  Json json() const {
    Json object{{"value", mean(values_)}, {"unit", unit_}, {"count", values_.size()}};
    if (values_.size() > 1) {
      double squares = 0;
      for (const double value : values_) squares += (value - mean(values_)) * (value - mean(values_));
      object["realisation_sd"] = std::sqrt(squares / static_cast<double>(values_.size() - 1));
    }
    if (!case_sds_.empty()) object["case_sd"] = mean(case_sds_);
    return object;
  }

  bool empty() const { return values_.empty(); }

 private:
  static double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
  }
  std::string unit_;
  std::vector<double> values_, case_sds_;
};

Json varied_values(const Study& study, const std::vector<std::string>& labels) {
  Json object = Json::object();
  for (std::size_t i = 0; i < study.axes.size(); ++i) object[study.axes[i].name] = labels[i];
  return object;
}

Json case_json(const Study& study, const StudyCase& cell, const CaseProgress& progress,
               const std::optional<CaseResult>& result) {
  Json object{{"name", cell.name},
              {"folder", cell.name},
              {"values", varied_values(study, cell.labels)},
              {"realisation", cell.realisation},
              {"state", word_for(progress.state)}};
  if (!progress.message.empty()) object["message"] = progress.message;
  if (result)
    for (const char* part : {"inputs_sha256", "commit", "effective", "balance", "cost"})
      if (result->document.contains(part)) object[part] = result->document[part];
  return object;
}

Json groups_json(const Study& study, const Results& results) {
  std::vector<std::pair<std::vector<std::string>, std::vector<std::size_t>>> groups;
  std::map<std::vector<std::string>, std::size_t> group_of;
  for (std::size_t i = 0; i < study.cases.size(); ++i) {
    const auto [found, is_new] = group_of.emplace(study.cases[i].labels, groups.size());
    if (is_new) groups.push_back({study.cases[i].labels, {}});
    groups[found->second].second.push_back(i);
  }
  Json list = Json::array();
  for (const auto& [labels, members] : groups) {
    std::vector<std::pair<std::string, Scatter>> quantities;
    for (const std::size_t i : members) {
      if (!results[i]) continue;
      for (const auto& [key, number] : results[i]->effective) {
        const std::string& name = key;
        auto at = quantities.begin();
        while (at != quantities.end() && at->first != name) ++at;
        if (at == quantities.end()) at = quantities.insert(at, {name, Scatter()});
        at->second.add(number);
      }
    }
    Json effective = Json::object();
    for (const auto& [name, scatter] : quantities)
      if (!scatter.empty()) effective[name] = scatter.json();
    list.push_back({{"values", varied_values(study, labels)}, {"effective", effective}});
  }
  return list;
}

std::string csv_text(const Study& study, const std::vector<CaseProgress>& progress, const Results& results) {
  // Columns: every effective quantity that any case has, with the unit it is given in.
  std::vector<std::pair<std::string, std::string>> quantities;
  for (const auto& result : results)
    if (result)
      for (const auto& [name, number] : result->effective) {
        const std::pair<std::string, std::string> column{name, number.unit};
        if (std::find(quantities.begin(), quantities.end(), column) == quantities.end())
          quantities.push_back(column);
      }
  std::string text = "case,state,realisation";
  for (const auto& axis : study.axes) text += "," + quoted(axis.name);
  for (const auto& [name, unit] : quantities) {
    const std::string in_unit = unit.empty() ? "" : " [" + unit + "]";
    text += "," + name + in_unit + "," + name + "_sd" + in_unit;
  }
  text += "\n";
  for (std::size_t i = 0; i < study.cases.size(); ++i) {
    const StudyCase& cell = study.cases[i];
    text += cell.name + "," + word_for(progress[i].state) + "," + std::to_string(cell.realisation);
    for (const auto& label : cell.labels) text += "," + quoted(label);
    for (const auto& [name, unit] : quantities) {
      const EffectiveNumber found = results[i] ? results[i]->effective_number(name) : EffectiveNumber{};
      text += "," + number(found.value) + "," + number(found.sd);
    }
    text += "\n";
  }
  return text;
}

}  // namespace

bool has_result(const fs::path& folder) { return read_result(folder).has_value(); }

void write_study_summary(const Study& study, const std::vector<CaseProgress>& progress,
                         const fs::path& output) {
  Results results;
  for (std::size_t i = 0; i < study.cases.size(); ++i)
    results.push_back(progress[i].state == CaseProgress::State::done
                          ? read_result(output / study.cases[i].name)
                          : std::nullopt);
  Json json{{"format", "asperity-study/1"},
            {"title", study.title},
            {"file", study.file.filename().string()},
            {"realisations", study.realisations}};
  json["axes"] = Json::array();
  for (const auto& axis : study.axes) json["axes"].push_back({{"name", axis.name}, {"values", axis.labels}});
  json["cases"] = Json::array();
  for (std::size_t i = 0; i < study.cases.size(); ++i)
    json["cases"].push_back(case_json(study, study.cases[i], progress[i], results[i]));
  json["groups"] = groups_json(study, results);
  // A message of a log that was cut off need not be valid UTF-8.
  write_file_atomically(output / "study.json",
                        json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
  write_file_atomically(output / "study.csv", csv_text(study, progress, results));
}

}  // namespace asperity
