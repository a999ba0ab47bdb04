#include "diagnosis/recording/samples.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "diagnosis/recording/driven_motion.h"
#include "diagnosis/recording/inferred_segments.h"
#include "diagnosis/recording/segment_names.h"
#include "diagnosis/recording/time_from_path.h"

namespace asperity {
namespace {

double value_or(const RecordingTable& table, const std::string& channel, std::size_t row, double otherwise) {
  const auto found = table.columns.find(channel);
  if (found == table.columns.end() || std::isnan(found->second[row])) return otherwise;
  return found->second[row];
}

/// An empty cell is not known, no zero: a row without the load or speed that its table gives cannot be
/// judged.
bool says_what_it_depends_on(const RecordingTable& table, std::size_t row, bool normal) {
  for (const char* channel : {"normal_force", "speed", "radius", "rms_roughness", "rail_angle", "humidity"}) {
    if (normal && std::string(channel) == "normal_force") continue;
    const auto found = table.columns.find(channel);
    if (found == table.columns.end() || !std::isnan(found->second[row])) continue;
    const auto& column = found->second;
    if (std::any_of(column.begin(), column.end(), [](double value) { return !std::isnan(value); }))
      return false;
  }
  return true;
}

struct Named {
  std::vector<std::string>& names;
  int index(const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<int>(found - names.begin());
    names.push_back(name);
    return static_cast<int>(names.size()) - 1;
  }
};

/// Rows of one run in their order, runs in the order of their first row.
std::vector<std::pair<double, std::vector<std::size_t>>> rows_by_run(const RecordingTable& table) {
  std::vector<std::pair<double, std::vector<std::size_t>>> runs;
  std::map<double, std::size_t> place;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double number = table.kind == TableKind::trace ? value_or(table, "run", row, 0) : 0;
    const auto [found, is_new] = place.try_emplace(number, runs.size());
    if (is_new) runs.push_back({number, {}});
    runs[found->second].second.push_back(row);
  }
  return runs;
}

/// What the cells of a row say, without segment; `number`: of the row in its run.
Sample sample_of(const Recording& recording, const RecordingTable& table, std::size_t row,
                 std::size_t number) {
  Sample s;
  s.row = static_cast<int>(row);
  s.time = value_or(table, "time", row, static_cast<double>(number));
  s.normal_displacement = value_or(table, "normal_displacement", row, 0);
  s.normal_force = value_or(table, "normal_force", row, 0);
  s.lateral_displacement = value_or(table, "lateral_displacement", row, 0);
  s.speed = value_or(table, "speed", row, 0);
  s.radius = value_or(table, "radius", row, recording.particle.radius);
  s.rms_roughness = value_or(table, "rms_roughness", row, recording.substrate.rms_roughness);
  s.rail_angle =
      value_or(table, "rail_angle", row, std::isfinite(recording.rail_angle) ? recording.rail_angle : 0.0);
  s.humidity = value_or(table, "humidity", row, 0);
  s.cycle = value_or(table, "cycle", row, 0);
  s.response = value_or(table, table.response, row, 0);
  s.counts = std::isfinite(table.column(table.response)[row]) &&
             says_what_it_depends_on(table, row, recording.mode == Motion::normal);
  s.sd = value_or(table, table.response + "_sd", row, 0);
  return s;
}

/// Appends the samples of one run, cut into segments.
void add_run(Samples& samples, SampleRun run, const Recording& recording,
             const std::vector<std::size_t>& rows) {
  const RecordingTable& table = recording.tables[run.table];
  const bool normal = recording.mode == Motion::normal;
  Named segments{samples.segment_names};
  run.begin = samples.list.size();
  run.independent_rows = table.kind == TableKind::series;
  run.response_is_displacement = table.response == "normal_displacement";
  run.at = table.at;
  std::vector<double> path;
  for (const std::size_t row : rows) path.push_back(table.column(table.control.front())[row]);
  const std::vector<std::string> inferred = table.kind == TableKind::trace
                                                ? inferred_segments(path, normal)
                                                : std::vector<std::string>(rows.size(), "series");
  // Where holds are named their names say how long they are. Off contact a driven force rests though the
  // probe moves.
  const bool names_holds =
      std::any_of(table.segment.begin(), table.segment.end(),
                  [](const std::string& name) { return segment_meant_by(name) == "hold"; });
  const auto [low, high] = std::minmax_element(path.begin(), path.end());
  constexpr double part_of_range = 0.05;
  const double under_load = *low + part_of_range * (*high - *low);
  const std::vector<bool> backward = run.independent_rows ? rows_backward(table) : std::vector<bool>{};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Sample s = sample_of(recording, table, rows[i], i);
    const auto named = table.segment.empty() ? std::nullopt : segment_meant_by(table.segment[rows[i]]);
    const bool rests_unnamed = normal && !names_holds && inferred[i] == "hold" && path[i] > under_load;
    s.segment = segments.index(named && !rests_unnamed ? *named : inferred[i]);
    s.part = i > 0 && samples.list.back().segment == s.segment && !run.independent_rows &&
                     samples.list.back().cycle == s.cycle
                 ? samples.parts - 1
                 : samples.parts++;
    if (run.independent_rows) {
      s.part = i > 0 ? samples.list.back().part : s.part;
      s.direction = backward[rows[i]] ? -1 : 1;
    }
    samples.list.push_back(s);
  }
  run.end = samples.list.size();
  if (!run.independent_rows)
    follow_motion(samples, run,
                  {normal, run.response_is_displacement, table.has("speed"), table.has("cycle"),
                   table.has("time"), !table.has("time") && time_is_known(recording, table)});
  samples.runs.push_back(run);
}

/// Cycles are counted from zero.
void count_cycles_from_zero(Samples& samples, const SampleRun& run) {
  double first = samples.list[run.begin].cycle;
  for (std::size_t i = run.begin; i < run.end; ++i) first = std::min(first, samples.list[i].cycle);
  for (std::size_t i = run.begin; i < run.end; ++i) samples.list[i].cycle -= first;
}

}  // namespace

Samples samples_of(const Recording& recording) {
  Samples samples;
  for (std::size_t t = 0; t < recording.tables.size(); ++t) {
    const RecordingTable& table = recording.tables[t];
    samples.table_names.push_back(table.file);
    samples.response_channels.push_back(table.response);
    for (const auto& [number, rows] : rows_by_run(table)) {
      SampleRun run;
      run.table = t;
      run.number = number;
      add_run(samples, run, recording, rows);
    }
  }
  for (std::size_t i = 0; i < samples.list.size(); ++i) samples.list[i].index = i;
  for (const auto& run : samples.runs) count_cycles_from_zero(samples, run);
  return samples;
}

Samples thinned(const Samples& all, std::size_t most) {
  if (all.list.size() <= most) return all;
  // After a turn the response changes most; the first part of a segment keeps four times as many samples.
  constexpr double dense_part = 0.15, dense_factor = 4;
  const double share_kept = static_cast<double>(most) / static_cast<double>(all.list.size()) /
                            (1 + dense_part * (dense_factor - 1));
  Samples few = all;
  few.list.clear();
  for (auto& run : few.runs) {
    const std::size_t begin = run.begin, end = run.end;
    run.begin = few.list.size();
    for (std::size_t from = begin, to = begin; from < end; from = to) {
      while (to < end && all.list[to].part == all.list[from].part) ++to;
      double credit = 1;
      for (std::size_t i = from; i < to; ++i) {
        const bool dense = static_cast<double>(i - from) < dense_part * static_cast<double>(to - from);
        credit += share_kept * (dense ? dense_factor : 1);
        if (credit < 1 && i != from && i + 1 != to) continue;
        few.list.push_back(all.list[i]);
        credit = std::max(0.0, credit - 1);
      }
    }
    run.end = few.list.size();
  }
  return few;
}

}  // namespace asperity
