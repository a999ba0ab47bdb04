#include "diagnosis/recording/samples.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "diagnosis/recording/control_noise.h"
#include "diagnosis/recording/median.h"
#include "diagnosis/recording/monotonic_path.h"

namespace asperity {
namespace {

/// A turn of the driven motion counts where it comes back by more than this part of its range, and by more
/// than its noise.
constexpr double turn_of_range = 0.02;
/// An interval is a hold where the driven motion stays within this part of its range for this part of the
/// run.
constexpr double hold_of_range = 0.01;
constexpr double hold_of_samples = 0.02;

double value_or(const RecordingTable& table, const std::string& channel, std::size_t row, double otherwise) {
  const auto found = table.columns.find(channel);
  if (found == table.columns.end() || std::isnan(found->second[row])) return otherwise;
  return found->second[row];
}

/// An empty cell is not known, no zero: a row without the load or speed that its table gives cannot be
/// judged.
bool says_what_it_depends_on(const RecordingTable& table, std::size_t row, bool normal) {
  for (const char* channel : {"normal_force", "speed", "radius", "rms_roughness", "rail_angle"}) {
    if (normal && std::string(channel) == "normal_force") continue;
    const auto found = table.columns.find(channel);
    if (found == table.columns.end() || !std::isnan(found->second[row])) continue;
    const auto& column = found->second;
    if (std::any_of(column.begin(), column.end(), [](double value) { return !std::isnan(value); }))
      return false;
  }
  return true;
}

/// Where the driven channel turns: indices of the extremes in between.
std::vector<std::size_t> turns(const std::vector<double>& path, double noise) {
  std::vector<std::size_t> found;
  if (path.size() < 3) return found;
  const auto [low, high] = std::minmax_element(path.begin(), path.end());
  const double back = std::max(turn_of_range * (*high - *low), noise);
  if (back <= 0) return found;
  std::size_t extreme = 0;
  int direction = 0;
  double lowest = path[0], highest = path[0];
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (direction == 0) {
      lowest = std::min(lowest, path[i]);
      highest = std::max(highest, path[i]);
      if (path[i] > lowest + back)
        direction = 1, extreme = i;
      else if (path[i] < highest - back)
        direction = -1, extreme = i;
      continue;
    }
    if ((path[i] - path[extreme]) * direction >= 0)
      extreme = i;
    else if ((path[extreme] - path[i]) * direction > back) {
      found.push_back(extreme);
      direction = -direction;
      extreme = i;
    }
  }
  return found;
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

/// Names of the segments of one run where the table has none, from the driven channel.
std::vector<std::string> inferred_segments(const std::vector<double>& given, bool normal) {
  const auto [least, most] = std::minmax_element(given.begin(), given.end());
  const auto [path, noise] = quiet(given, hold_of_range * (*most - *least));
  const std::string up = normal ? "load" : "forward", down = normal ? "unload" : "backward";
  std::vector<std::string> names(path.size());
  std::vector<std::size_t> ends = turns(path, noise);
  ends.push_back(path.size());
  std::size_t from = 0;
  for (const std::size_t end : ends) {
    const bool rises = path[std::min(end, path.size() - 1)] > path[from];
    for (std::size_t i = from; i < end; ++i) names[i] = rises ? up : down;
    from = end;
  }
  const auto [low, high] = std::minmax_element(path.begin(), path.end());
  const double still = std::max(hold_of_range * (*high - *low), noise);
  const std::size_t longest =
      std::max<std::size_t>(8, static_cast<std::size_t>(hold_of_samples * path.size()));
  for (std::size_t i = 0; i < path.size();) {
    std::size_t j = i;
    double lowest = path[i], highest = path[i];
    while (j < path.size() && std::max(highest, path[j]) - std::min(lowest, path[j]) <= still) {
      lowest = std::min(lowest, path[j]);
      highest = std::max(highest, path[j]);
      ++j;
    }
    // As many samples as a motion over the range in the whole run would spend in the band are no hold.
    if (j - i >= longest &&
        static_cast<double>(j - i) * (*high - *low) > 4 * still * static_cast<double>(path.size())) {
      for (std::size_t k = i; k < j; ++k) names[k] = "hold";
      i = j;
    } else {
      ++i;
    }
  }
  return names;
}

/// Lateral paths without the sensor's noise where they are monotonic.
void make_paths_monotonic(Samples& samples, const SampleRun& run) {
  for (std::size_t from = run.begin, to = from; from < run.end; from = to) {
    std::vector<double> path;
    for (; to < run.end && samples.list[to].part == samples.list[from].part; ++to)
      path.push_back(samples.list[to].lateral_displacement);
    path = monotonic_path(path, path.back() >= path.front() ? 1 : -1);
    for (std::size_t i = from; i < to; ++i) samples.list[i].lateral_displacement = path[i - from];
  }
}

/// Part of each cycle's path that has passed.
template <class Driven>
void follow_cycles(Samples& samples, const SampleRun& run, const Driven& driven) {
  for (std::size_t from = run.begin, to = from; from < run.end; from = to) {
    double path = 0;
    for (; to < run.end && samples.list[to].cycle == samples.list[from].cycle; ++to)
      samples.list[to].cycle_part = path +=
          to == run.begin ? 0 : std::abs(driven(samples.list[to]) - driven(samples.list[to - 1]));
    for (std::size_t i = from; i < to; ++i) samples.list[i].cycle_part /= path > 0 ? path : 1;
  }
}

/// Times of one run, those of samples with the same time spread evenly until the next one: a clock that is
/// coarser than the samples lie apart says their order, not their distance.
std::vector<double> spread_times(const Samples& samples, const SampleRun& run) {
  std::vector<double> time;
  for (std::size_t i = run.begin; i < run.end; ++i) time.push_back(samples.list[i].time);
  double tick = 0;  // of the clock before, for the samples of the last
  for (std::size_t from = 0, to = 0; from < time.size(); from = to) {
    while (to < time.size() && time[to] == time[from]) ++to;
    if (to < time.size()) tick = time[to] - time[from];
    const double first = time[from], count = static_cast<double>(to - from);
    for (std::size_t i = from; i < to; ++i) time[i] = first + tick * static_cast<double>(i - from) / count;
  }
  return time;
}

/// Direction, path since reversal, holds, cycles and speed of one run.
void follow(Samples& samples, const SampleRun& run, bool normal, bool has_speed, bool has_cycles,
            bool has_time, bool driven_is_force) {
  const auto driven = [&](const Sample& s) {
    return !normal ? s.lateral_displacement : driven_is_force ? s.normal_force : s.normal_displacement;
  };
  Sample* list = samples.list.data();
  if (!normal) make_paths_monotonic(samples, run);
  double reversal = driven(list[run.begin]), hold_begin = 0;
  int direction = 0, hold = 0;
  double cycle = 0;
  int first_direction = 0;
  for (std::size_t i = run.begin; i < run.end; ++i) {
    Sample& s = list[i];
    const std::string& name = samples.segment_names[static_cast<std::size_t>(s.segment)];
    const bool begins = i == run.begin || s.part != list[i - 1].part;
    if (begins) {
      // The direction of a segment is that of its ends: single samples jitter.
      std::size_t end = i;
      while (end + 1 < run.end && list[end + 1].part == s.part) ++end;
      const double travel = driven(list[end]) - driven(s);
      const int now = name == "hold"                           ? (direction == 0 ? 1 : direction)
                      : name == "backward" || name == "unload" ? -1
                      : name == "forward" || name == "load"    ? 1
                                                               : (travel >= 0 ? 1 : -1);
      if (first_direction == 0)
        first_direction = now;
      else if (direction != now && now == first_direction)
        cycle += 1;
      if (now != direction) reversal = i == run.begin ? driven(s) : driven(list[i - 1]);
      direction = now;
      if (name == "hold") {
        hold_begin = s.time;
        ++hold;
      }
    }
    s.direction = direction;
    s.since_reversal = std::abs(driven(s) - reversal);
    s.hold = hold;
    s.hold_time = name == "hold" ? s.time - hold_begin : 0;
    if (!has_cycles) s.cycle = cycle;
  }
  follow_cycles(samples, run, driven);
  if (has_speed || !has_time || normal) return;
  // Speed from path and time, as a median over neighbours, of one segment.
  constexpr long reach = 3;
  const std::vector<double> time = spread_times(samples, run);
  std::vector<double> raw(run.end - run.begin, 0.0);
  for (std::size_t i = run.begin + 1; i < run.end; ++i) {
    const double step = time[i - run.begin] - time[i - 1 - run.begin];
    const double way = std::abs(list[i].lateral_displacement - list[i - 1].lateral_displacement);
    raw[i - run.begin] = step > 0 ? way / step : 0;
  }
  if (raw.size() > 1) raw[0] = raw[1];
  for (std::size_t i = run.begin; i < run.end; ++i) {
    std::vector<double> near;
    for (long k = -reach; k <= reach; ++k) {
      const long j = static_cast<long>(i) + k;
      if (j < static_cast<long>(run.begin) || j >= static_cast<long>(run.end)) continue;
      if (list[j].part == list[i].part) near.push_back(raw[static_cast<std::size_t>(j) - run.begin]);
    }
    list[i].speed = median(near);
  }
}

}  // namespace

Samples samples_of(const Recording& recording) {
  Samples samples;
  Named segments{samples.segment_names};
  const bool normal = recording.mode == Motion::normal;
  for (std::size_t t = 0; t < recording.tables.size(); ++t) {
    const RecordingTable& table = recording.tables[t];
    samples.table_names.push_back(table.file);
    samples.response_channels.push_back(table.response);
    // Rows of one run in their order, runs in the order of their first row.
    std::vector<double> order;
    std::map<double, std::vector<std::size_t>> rows_of_run;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const double number = table.kind == TableKind::trace ? value_or(table, "run", row, 0) : 0;
      if (!rows_of_run.count(number)) order.push_back(number);
      rows_of_run[number].push_back(row);
    }
    for (const double number : order) {
      const auto& rows = rows_of_run[number];
      SampleRun run;
      run.begin = samples.list.size();
      run.table = t;
      run.number = number;
      run.independent_rows = table.kind == TableKind::series;
      run.response_is_displacement = table.response == "normal_displacement";
      run.at = table.at;
      std::vector<double> path;
      for (const std::size_t row : rows) path.push_back(table.column(table.control.front())[row]);
      const std::vector<std::string> inferred = table.kind == TableKind::trace
                                                    ? inferred_segments(path, normal)
                                                    : std::vector<std::string>(rows.size(), "series");
      for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::size_t row = rows[i];
        Sample s;
        s.row = static_cast<int>(row);
        s.time = value_or(table, "time", row, static_cast<double>(i));
        s.normal_displacement = value_or(table, "normal_displacement", row, 0);
        s.normal_force = value_or(table, "normal_force", row, 0);
        s.lateral_displacement = value_or(table, "lateral_displacement", row, 0);
        s.speed = value_or(table, "speed", row, 0);
        s.radius = value_or(table, "radius", row, recording.particle.radius);
        s.rms_roughness = value_or(table, "rms_roughness", row, recording.substrate.rms_roughness);
        s.rail_angle = value_or(table, "rail_angle", row,
                                std::isfinite(recording.rail_angle) ? recording.rail_angle : 0.0);
        s.cycle = value_or(table, "cycle", row, 0);
        const bool named = !table.segment.empty() && !table.segment[row].empty();
        s.segment = segments.index(named ? table.segment[row] : inferred[i]);
        s.part = i > 0 && samples.list.back().segment == s.segment && !run.independent_rows &&
                         samples.list.back().cycle == s.cycle
                     ? samples.parts - 1
                     : samples.parts++;
        if (run.independent_rows) {
          s.part = i > 0 ? samples.list.back().part : s.part;
          s.direction = samples.segment_names[static_cast<std::size_t>(s.segment)] == "backward" ? -1 : 1;
        }
        s.response = value_or(table, table.response, row, 0);
        s.counts =
            std::isfinite(table.column(table.response)[row]) && says_what_it_depends_on(table, row, normal);
        s.sd = value_or(table, table.response + "_sd", row, 0);
        samples.list.push_back(s);
      }
      run.end = samples.list.size();
      if (!run.independent_rows)
        follow(samples, run, normal, table.has("speed"), table.has("cycle"), table.has("time"),
               run.response_is_displacement);
      samples.runs.push_back(run);
    }
  }
  for (std::size_t i = 0; i < samples.list.size(); ++i) samples.list[i].index = i;
  // Cycles are counted from zero.
  for (const auto& run : samples.runs) {
    double first = samples.list[run.begin].cycle;
    for (std::size_t i = run.begin; i < run.end; ++i) first = std::min(first, samples.list[i].cycle);
    for (std::size_t i = run.begin; i < run.end; ++i) samples.list[i].cycle -= first;
  }
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
