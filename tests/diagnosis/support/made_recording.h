// Paths and recordings made by hand: the paper's sphere on silicon.
#pragma once

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "diagnosis/recording/experiment.h"

namespace asperity::test {

inline constexpr double nm = 1e-9, uN = 1e-6;

inline RecordedBody borosilicate() {
  return {"borosilicate", 71e9, 0.17, 8.5e-6, 0.7e-9, RecordedBody::unknown};
}
inline RecordedBody silicon() {
  return {"Si(100)", 179e9, 0.25, RecordedBody::unknown, 0.3e-9, RecordedBody::unknown};
}
inline RecordedBody diamond() {
  return {"diamond", 1140e9, 0.07, RecordedBody::unknown, 4e-9, RecordedBody::unknown};
}

inline Experiment experiment(Motion mode) {
  Experiment e;
  e.mode = mode;
  e.particle = {71e9, 0.17};
  e.substrate = {179e9, 0.25};
  e.indenter = {1140e9, 0.07};
  e.radius = e.smallest_radius = e.largest_radius = 8.5e-6;
  e.largest_force = 3e-3;
  e.typical_force = 1e-3;
  e.smallest_force = 1e-4;
  e.largest_displacement = e.hertz().approach(e.largest_force);
  e.largest_response = 1e-3;
  e.stroke = 1e-7;
  e.duration = 100;
  e.slowest = 1e-6;
  e.fastest = 1e-5;
  e.cycles = 10;
  e.smoothest = 0.3e-9;
  e.roughest = 3e-9;
  return e;
}

inline void close_run(Samples& samples, bool independent) {
  SampleRun run;
  run.end = samples.list.size();
  run.independent_rows = independent;
  samples.runs = {run};
  samples.segment_names = {"only"};
  for (std::size_t i = 0; i < samples.list.size(); ++i) samples.list[i].index = i;
}

/// From `low` to `high` in `n` samples and back in as many, a sample a second.
inline Samples approach_and_back(double low, double high, int n) {
  Samples samples;
  for (int i = 0; i < 2 * n; ++i) {
    Sample s;
    const int step = i < n ? i : 2 * n - 1 - i;
    s.normal_displacement = low + (high - low) * step / (n - 1);
    s.time = i;
    s.direction = i < n ? 1 : -1;
    s.radius = 8.5e-6;
    samples.list.push_back(s);
  }
  close_run(samples, false);
  return samples;
}

/// Straight paths between turning points at one load, `n` samples each.
inline Samples lateral_path(double load, const std::vector<double>& turns, int n) {
  Samples samples;
  for (std::size_t leg = 0; leg + 1 < turns.size(); ++leg)
    for (int i = 0; i < n; ++i) {
      Sample s;
      s.lateral_displacement = turns[leg] + (turns[leg + 1] - turns[leg]) * i / (n - 1);
      s.normal_force = load;
      s.speed = 1e-5;
      s.time = static_cast<double>(samples.list.size());
      s.direction = turns[leg + 1] > turns[leg] ? 1 : -1;
      s.radius = 8.5e-6;
      samples.list.push_back(s);
    }
  close_run(samples, false);
  return samples;
}

inline Samples row(const Experiment& e, double load) {
  Samples samples;
  Sample s;
  s.normal_force = load;
  s.radius = e.radius;
  s.speed = 1e-5;
  samples.list.push_back(s);
  close_run(samples, true);
  return samples;
}

}  // namespace asperity::test
