#include "diagnosis/recording/inferred_segments.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnosis/recording/control_noise.h"
#include "diagnosis/recording/median.h"

namespace asperity {
namespace {

/// A turn of the driven motion counts where it comes back by more than this part of its range, and by more
/// than its noise.
constexpr double turn_of_range = 0.02;
/// An interval is a hold where the driven motion stays within this part of its range for this part of the
/// run.
constexpr double hold_of_range = 0.01;
constexpr double hold_of_samples = 0.02;
/// What is no motion, of its range.
constexpr double least_motion = 1e-4;

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

/// Where the motion rests in an interval that also holds its last way to there and its first from there:
/// between the first and the last sample that is as near to the middle value as most are, or as `resolved`
/// [of the path].
std::pair<std::size_t, std::size_t> rest_within(const std::vector<double>& path, std::size_t from,
                                                std::size_t to, double resolved) {
  constexpr double as_most = 4;  // times the median distance
  const std::vector<double> values(path.begin() + static_cast<std::ptrdiff_t>(from),
                                   path.begin() + static_cast<std::ptrdiff_t>(to));
  const double middle = median(values);
  std::vector<double> distance;
  for (const double value : values) distance.push_back(std::abs(value - middle));
  const double near = std::max(resolved, as_most * median(distance));
  std::size_t first = 0, end = distance.size();
  while (first + 1 < end && distance[first] > near) ++first;
  while (end > first + 1 && distance[end - 1] > near) --end;
  return {from + first, from + end};
}

/// Names the intervals in which the driven motion rests.
void name_holds(std::vector<std::string>& names, const std::vector<double>& path, double noise) {
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
      const auto [first, last] = rest_within(path, i, j, std::max(noise, least_motion * (*high - *low)));
      for (std::size_t k = first; k < last; ++k) names[k] = "hold";
      i = j;
    } else {
      ++i;
    }
  }
}

}  // namespace

std::vector<std::string> inferred_segments(const std::vector<double>& given, bool normal) {
  const auto [least, most] = std::minmax_element(given.begin(), given.end());
  const auto [path, noise] = quiet(given, hold_of_range * (*most - *least));
  const std::string up = normal ? "load" : "forward", down = normal ? "unload" : "backward";
  std::vector<std::string> names(path.size());
  std::vector<std::size_t> ends;
  for (const std::size_t extreme : turns(path, noise)) ends.push_back(extreme + 1);
  ends.push_back(path.size());
  std::size_t from = 0;
  for (const std::size_t end : ends) {
    const bool rises = path[end - 1] > path[from];
    for (std::size_t i = from; i < end; ++i) names[i] = rises ? up : down;
    from = end;
  }
  name_holds(names, path, noise);
  return names;
}

}  // namespace asperity
