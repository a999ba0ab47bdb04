#include "diagnosis/simulated_file.h"

#include <algorithm>
#include <vector>

#include "core/csv.h"
#include "diagnosis/recording/recording_table_file.h"

namespace asperity {
namespace {

void add_once(std::vector<std::string>& list, const std::string& name) {
  if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(name);
}

}  // namespace

std::string simulated_csv(const Recording& recording, const Diagnosis& diagnosis, SimulatedState state) {
  std::vector<std::string> channels, responses;
  bool has_segments = false;
  for (const RecordingTable& table : recording.tables) {
    for (const auto& channel : channels_in_order(table)) add_once(channels, channel);
    add_once(responses, table.response);
    has_segments = has_segments || !table.segment.empty();
  }
  std::string text = "table";
  for (const auto& channel : channels) text += "," + heading_of(channel);
  if (has_segments) text += ",segment";
  for (const auto& response : responses) text += ",simulated_" + heading_of(response);
  text += '\n';
  for (std::size_t t = 0; t < recording.tables.size(); ++t) {
    const RecordingTable& table = recording.tables[t];
    const SimulatedRows& simulated = diagnosis.simulated.at(t);
    const auto& values = state == SimulatedState::before ? simulated.before : simulated.after;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      text += csv_cell(table.file);
      for (const auto& channel : channels)
        text += "," + (table.has(channel) ? cell_of(table.columns.at(channel)[row]) : "");
      if (has_segments) text += "," + (table.segment.empty() ? "" : table.segment[row]);
      for (const auto& response : responses)
        text += "," + (response == table.response ? cell_of(values.at(row)) : "");
      text += '\n';
    }
  }
  return text;
}

}  // namespace asperity
