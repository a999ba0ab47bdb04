#include "diagnosis/recording/segment_names.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "core/joined.h"
#include "core/printable.h"
#include "diagnosis/recording/median.h"
#include "diagnosis/recording/recording.h"

namespace asperity {

std::optional<std::string> segment_meant_by(const std::string& written) {
  std::string name = written;
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const char* known : {"load", "hold", "unload", "forward", "backward"})
    if (name == known) return name;
  return std::nullopt;
}

std::vector<bool> rows_backward(const RecordingTable& table) {
  constexpr double least = 0.3;  // of the usual ratio
  const std::size_t rows = table.rows();
  std::vector<bool> backward(rows, false);
  bool named = false;
  for (std::size_t i = 0; i < table.segment.size(); ++i) {
    const auto name = segment_meant_by(table.segment[i]);
    backward[i] = name == "backward";
    named = named || name == "backward" || name == "forward";
  }
  if (named || table.response != "lateral_force") return backward;
  const auto& force = table.column(table.response);
  std::vector<double> ratio(rows, 0.0), sizes;
  for (std::size_t i = 0; i < rows; ++i) {
    const double load = table.has("normal_force") ? table.column("normal_force")[i] : 1;
    if (std::isfinite(force[i]) && load > 0) sizes.push_back(std::abs(ratio[i] = force[i] / load));
  }
  const double usual = median(std::move(sizes));
  for (std::size_t i = 0; i < rows; ++i) backward[i] = ratio[i] < -least * usual;
  return backward;
}

std::vector<std::string> remarks_on_segments(const Recording& recording) {
  std::vector<std::string> remarks;
  std::set<std::string> others;
  for (const auto& table : recording.tables)
    if (table.kind == TableKind::trace)
      for (const auto& name : table.segment)
        if (!name.empty() && !segment_meant_by(name)) others.insert(name);
  constexpr std::size_t most_named = 5;
  std::vector<std::string> named;
  for (const auto& name : others)
    if (named.size() < most_named) named.push_back("'" + printable(name) + "'");
  if (!others.empty())
    remarks.push_back(
        "segments are named " + joined(named, ", ") + (others.size() > most_named ? " and others" : "") +
        ", which is none of load, hold, unload, forward and backward: loading, holds and returns "
        "were read off the driven motion");
  for (const auto& table : recording.tables) {
    if (table.kind != TableKind::series || recording.mode == Motion::normal) continue;
    const std::vector<bool> backward = rows_backward(table);
    const auto count = std::count(backward.begin(), backward.end(), true);
    if (count > 0 && std::none_of(table.segment.begin(), table.segment.end(), [](const std::string& name) {
          return segment_meant_by(name) == "backward";
        }))
      remarks.push_back(
          std::to_string(count) + " of " + std::to_string(backward.size()) + " rows of '" +
          printable(table.file) +
          "' have a lateral force below zero and no name of a direction: they were taken for motion "
          "backward");
  }
  return remarks;
}

}  // namespace asperity
