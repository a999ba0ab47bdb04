#include "diagnosis/recording/turning_point.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/recording/median.h"

namespace asperity {
namespace {

/// A line through the samples between two, both included.
struct Line {
  double speed = 0, step = 0;  ///< [m/s]; usual time from sample to sample [s]
  bool is_steady = false;      ///< both halves are equally fast
};

Line line_between(const std::vector<double>& path, const std::vector<double>& time, std::size_t first,
                  std::size_t last) {
  constexpr double steady = 0.25;  // of the speed
  const auto speed = [&](std::size_t a, std::size_t b) { return (path[b] - path[a]) / (time[b] - time[a]); };
  const std::size_t middle = (first + last) / 2;
  Line line;
  std::vector<double> steps;
  for (std::size_t i = first; i < last; ++i) steps.push_back(time[i + 1] - time[i]);
  line.step = median(std::move(steps));
  if (!(time[middle] > time[first] && time[last] > time[middle])) return line;
  line.speed = speed(first, last);
  line.is_steady = std::abs(speed(first, middle) - speed(middle, last)) <= steady * std::abs(line.speed);
  return line;
}

/// A step of the clock, or a few of which samples are missing: whole steps.
bool is_no_pause(double gap, double step) {
  constexpr double longest = 1.5, whole = 0.05, most = 4.5;  // steps
  const double steps = gap / step;
  return steps <= longest || (steps <= most && std::abs(steps - std::round(steps)) <= whole);
}

}  // namespace

std::optional<Turn> turn_of(const std::vector<double>& path, const std::vector<double>& time,
                            std::size_t begin, std::size_t turn, std::size_t end) {
  constexpr std::size_t fewest = 4, most_steps = 8, of_samples = 4;
  constexpr double at_a_sample = 0.01;  // of a step
  if (turn < begin + fewest || end < turn + fewest) return std::nullopt;
  const auto steps = [&](std::size_t samples) {
    return std::clamp<std::size_t>(samples / of_samples, 2, most_steps);
  };
  const std::size_t last = turn - 2, first = turn + 1;  // surely before and after
  const Line before = line_between(path, time, last - steps(turn - begin), last),
             after = line_between(path, time, first, first + steps(end - turn));
  const double step = (before.step + after.step) / 2;
  if (!before.is_steady || !after.is_steady || before.speed * after.speed >= 0) return std::nullopt;
  for (std::size_t i = last; i < first; ++i)
    if (!is_no_pause(time[i + 1] - time[i], step)) return std::nullopt;
  const double way = path[first] - path[last] - after.speed * (time[first] - time[last]);
  const double met = time[last] + way / (before.speed - after.speed), close = at_a_sample * step;
  Turn found;
  found.next = last + 1;
  while (found.next <= first && time[found.next] <= met + close) ++found.next;
  if (met < time[last] - close || found.next > first) return std::nullopt;
  if (met > time[found.next - 1] + close)
    found.place = TurningPoint{path[last] + before.speed * (met - time[last]), met};
  return found;
}

}  // namespace asperity
