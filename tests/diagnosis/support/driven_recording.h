// Recordings of one driven channel, to see what follows from it.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/recording/samples.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity::test {

using Column = std::vector<double>;

/// A trace with one driven channel.
inline Recording driven(Motion mode, const Column& path) {
  Recording recording;
  recording.mode = mode;
  recording.particle = borosilicate(), recording.substrate = silicon();
  RecordingTable table;
  table.file = "t.csv";
  const bool normal = mode == Motion::normal;
  table.control = {normal ? "normal_displacement" : "lateral_displacement"};
  table.response = normal ? "normal_force" : "lateral_force";
  table.columns[table.control[0]] = path;
  table.columns[table.response] = Column(path.size(), 1e-6);
  recording.tables = {table};
  return recording;
}

/// From turn to turn in equal steps.
inline Column zigzag(const Column& turns, int steps) {
  Column path{turns.front()};
  for (std::size_t k = 1; k < turns.size(); ++k)
    for (int i = 1; i <= steps; ++i) path.push_back(turns[k - 1] + (turns[k] - turns[k - 1]) * i / steps);
  return path;
}

/// The name of the segment of a sample.
inline std::string segment_of(const Samples& samples, std::size_t i) {
  return samples.segment_names[static_cast<std::size_t>(samples.list[i].segment)];
}

}  // namespace asperity::test
