#include "diagnosis/recording/driven_motion.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/recording/control_noise.h"
#include "diagnosis/recording/median.h"
#include "diagnosis/recording/monotonic_path.h"
#include "diagnosis/recording/time_from_path.h"

namespace asperity {
namespace {

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

/// Cycles that have passed at each sample since the run began, within one by path. The first and the last
/// may be less than a whole one: a run mostly begins in the middle of its stroke.
template <class Driven>
void follow_cycles(Samples& samples, const SampleRun& run, const Driven& driven) {
  struct Cycle {
    std::size_t begin;
    double length;  // of its path
  };
  std::vector<Cycle> cycles;
  for (std::size_t i = run.begin; i < run.end; ++i) {
    Sample& s = samples.list[i];
    if (i == run.begin || s.cycle != samples.list[i - 1].cycle) cycles.push_back({i, 0});
    if (i > run.begin) cycles.back().length += std::abs(driven(s) - driven(samples.list[i - 1]));
    s.cycles_passed = cycles.back().length;
  }
  std::vector<double> whole;
  for (std::size_t k = 1; k + 1 < cycles.size(); ++k) whole.push_back(cycles[k].length);
  const double usual = whole.empty() ? 0 : median(std::move(whole));
  const double missing = usual > 0 ? std::max(0.0, 1 - cycles.front().length / usual) : 0;  // of the first
  for (std::size_t k = 0; k < cycles.size(); ++k) {
    const bool at_an_end = k == 0 || k + 1 == cycles.size();
    const double length = at_an_end ? std::max(usual, cycles[k].length) : cycles[k].length;
    const std::size_t end = k + 1 < cycles.size() ? cycles[k + 1].begin : run.end;
    for (std::size_t i = cycles[k].begin; i < end; ++i) {
      Sample& s = samples.list[i];
      s.cycles_passed = length > 0 ? s.cycles_passed / length : 0;
      if (k > 0) s.cycles_passed += s.cycle - samples.list[run.begin].cycle - missing;
    }
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

/// Speed of lateral motion from path and time, as a median over neighbours, of one segment.
void find_speeds(Samples& samples, const SampleRun& run) {
  constexpr long reach = 3;
  Sample* list = samples.list.data();
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

/// Neighbours on each side over which a line's slope tells the rate of motion to a twentieth of its mean
/// size, as far as a fiftieth of the samples.
std::size_t reach_of_rates(const std::vector<double>& path) {
  constexpr double asked = 0.05, of_samples = 50;
  const auto last = static_cast<double>(std::max<std::size_t>(1, path.size() - 1));
  const auto [low, high] = std::minmax_element(path.begin(), path.end());
  const double noise = control_noise(path), wanted = asked * (*high - *low) / last;  // of a slope per sample
  std::size_t reach = 1;
  const auto slope_noise = [&](double r) { return noise / std::sqrt(r * (r + 1) * (2 * r + 1) / 3); };
  while (static_cast<double>(reach) < last / of_samples && slope_noise(static_cast<double>(reach)) > wanted)
    ++reach;
  return reach;
}

/// Rates of the displacement under normal load: slopes of lines through the neighbours of one segment.
void find_approach_rates(Samples& samples, const SampleRun& run) {
  const std::vector<double> time = spread_times(samples, run);
  std::vector<double> path;
  for (std::size_t i = run.begin; i < run.end; ++i) path.push_back(samples.list[i].normal_displacement);
  const std::size_t reach = reach_of_rates(path);
  for (std::size_t from = run.begin, to = from; from < run.end; from = to) {
    while (to < run.end && samples.list[to].part == samples.list[from].part) ++to;
    for (std::size_t i = from; i < to; ++i) {
      const std::size_t first = i < from + reach ? from : i - reach, end = std::min(to, i + reach + 1);
      const auto count = static_cast<double>(end - first);
      double mean_time = 0, mean = 0, sum = 0, squares = 0;
      for (std::size_t k = first - run.begin; k < end - run.begin; ++k)
        mean_time += time[k] / count, mean += path[k] / count;
      for (std::size_t k = first - run.begin; k < end - run.begin; ++k) {
        const double off = time[k] - mean_time;
        sum += off * (path[k] - mean), squares += off * off;
      }
      samples.list[i].approach = squares > 0 ? sum / squares : 0;
    }
  }
}

int sign_of_name(const std::string& segment) {
  if (segment == "forward" || segment == "load") return 1;
  return segment == "backward" || segment == "unload" ? -1 : 0;
}

/// Where a lateral motion turns from one segment to the next, mostly between samples. A sample that is named
/// for the one way and lies on the other, as where the farthest is taken for the last or for the first, goes
/// to the other.
void find_turning_points(Samples& samples, const SampleRun& run) {
  Sample* const list = samples.list.data() + run.begin;
  const std::vector<double> time = spread_times(samples, run);
  std::vector<double> path;
  std::vector<std::size_t> begins;  // of segments
  for (std::size_t i = 0; i < time.size(); ++i) {
    path.push_back(list[i].lateral_displacement);
    if (i == 0 || list[i].part != list[i - 1].part) begins.push_back(i);
  }
  begins.push_back(time.size());
  const auto put = [&](std::size_t i, const Sample& like) {
    list[i].part = like.part, list[i].segment = like.segment;
  };
  for (std::size_t k = 1; k + 1 < begins.size(); ++k) {
    const std::size_t from = begins[k];
    const auto turn = turn_of(path, time, begins[k - 1], from, begins[k + 1]);
    list[from].turn.reset();
    if (!turn) continue;
    if (turn->next < from) put(from - 1, list[from]);
    if (turn->next > from) put(from, list[from - 1]);
    list[turn->next].turn = turn->place;
  }
}

/// Samples from `from` on that are of its part.
std::size_t end_of_part(const Samples& samples, const SampleRun& run, std::size_t from) {
  std::size_t to = from;
  while (to < run.end && samples.list[to].part == samples.list[from].part) ++to;
  return to;
}

/// -1 where the displacement falls in every "forward" segment and rises in every "backward" one: a stage that
/// counts down. +1 otherwise, also where both rise: positions along a line say nothing of the direction.
template <class Driven>
int sense_of_names(const Samples& samples, const SampleRun& run, const Driven& driven) {
  constexpr double shown = 0.1;  // of the run's range: shorter segments do not tell
  double low = driven(samples.list[run.begin]), high = low;
  for (std::size_t i = run.begin; i < run.end; ++i) {
    low = std::min(low, driven(samples.list[i]));
    high = std::max(high, driven(samples.list[i]));
  }
  bool any = false;
  for (std::size_t from = run.begin, to = from; from < run.end; from = to) {
    to = end_of_part(samples, run, from);
    const std::string& name = samples.segment_names[static_cast<std::size_t>(samples.list[from].segment)];
    const double travel = driven(samples.list[to - 1]) - driven(samples.list[from]);
    if ((name != "forward" && name != "backward") || std::abs(travel) <= shown * (high - low)) continue;
    if (travel * sign_of_name(name) > 0) return 1;
    any = true;
  }
  return any ? -1 : 1;
}

/// Direction of a segment by its name, else that of its ends: single samples jitter.
int direction_of_segment(const std::string& name, double travel, int sense, int direction_before) {
  if (name == "hold") return direction_before == 0 ? 1 : direction_before;
  if (const int sign = sign_of_name(name); sign != 0) return sign * sense;
  return travel >= 0 ? 1 : -1;
}

/// Direction, path since reversal, holds and cycles; driven: of a sample, the driven motion.
template <class Driven>
void find_reversals(Samples& samples, const SampleRun& run, bool has_cycles, const Driven& driven) {
  Sample* list = samples.list.data();
  const int sense = sense_of_names(samples, run, driven);
  double reversal = driven(list[run.begin]), hold_begin = 0, cycle = 0;
  int direction = 0, first_direction = 0, hold = 0;
  for (std::size_t i = run.begin; i < run.end; ++i) {
    Sample& s = list[i];
    const std::string& name = samples.segment_names[static_cast<std::size_t>(s.segment)];
    if (i == run.begin || s.part != list[i - 1].part) {
      const std::size_t last = end_of_part(samples, run, i) - 1;
      const int now = direction_of_segment(name, driven(list[last]) - driven(s), sense, direction);
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
    if (s.turn) reversal = s.turn->displacement;
    s.direction = direction;
    s.since_reversal = std::abs(driven(s) - reversal);
    s.hold = hold;
    s.hold_time = name == "hold" ? s.time - hold_begin : 0;
    if (!has_cycles) s.cycle = cycle;
  }
}

}  // namespace

void follow_motion(Samples& samples, const SampleRun& run, const DrivenBy& by) {
  const auto driven = [&](const Sample& s) {
    return !by.normal ? s.lateral_displacement : by.force ? s.normal_force : s.normal_displacement;
  };
  if (!by.normal) {
    // First, so that no sample of the other way is smoothed into a segment.
    find_turning_points(samples, run);
    make_paths_monotonic(samples, run);
    if (by.time_from_path) take_time_from_path(samples, run);
    find_turning_points(samples, run);
  }
  find_reversals(samples, run, by.has_cycles, driven);
  follow_cycles(samples, run, driven);
  if (!by.has_speed && by.has_time && !by.normal) find_speeds(samples, run);
  if (by.normal && by.has_time && !by.force) find_approach_rates(samples, run);
}

}  // namespace asperity
