#include "diagnosis/import/segments.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/recording/control_noise.h"

namespace asperity {
namespace {

// Of the range, where noise is less.
constexpr double turn_of_range = 0.01, still_of_range = 0.01;
constexpr double slower = 2;  // a hold spends so many times as many samples in its band as a steady motion

/// Medians of five: single samples do not turn the motion round.
std::vector<double> smoothed(const std::vector<double>& signal) {
  std::vector<double> smooth = signal;
  for (std::size_t i = 2; i + 2 < signal.size(); ++i) {
    std::vector<double> five(signal.begin() + static_cast<long>(i) - 2,
                             signal.begin() + static_cast<long>(i) + 3);
    std::nth_element(five.begin(), five.begin() + 2, five.end());
    smooth[i] = five[2];
  }
  return smooth;
}

}  // namespace

FoundSegments find_segments(const std::vector<double>& given) {
  if (given.empty()) return {};
  const auto [least_given, most_given] = std::minmax_element(given.begin(), given.end());
  const auto [signal, noise] = quiet(smoothed(given), still_of_range * (*most_given - *least_given));
  const std::size_t n = signal.size();
  FoundSegments found;
  found.segment.assign(n, "load");
  found.cycle.assign(n, 0);
  if (n < 3) return found;
  const auto [low, high] = std::minmax_element(signal.begin(), signal.end());
  const double range = *high - *low;
  const double turn = std::max(turn_of_range * range, noise), still = std::max(still_of_range * range, noise);
  // Holds first: from each sample as far as the signal stays within the band.
  std::vector<bool> holds(n, false);
  const double in_band = range > 0 ? still / range * static_cast<double>(n) : 0;
  const auto shortest = std::max<std::size_t>(3, static_cast<std::size_t>(slower * in_band));
  for (std::size_t i = 0; i < n;) {
    double least = signal[i], most = signal[i];
    std::size_t end = i;
    while (end + 1 < n && std::max(most, signal[end + 1]) - std::min(least, signal[end + 1]) < still) {
      ++end;
      least = std::min(least, signal[end]);
      most = std::max(most, signal[end]);
    }
    if (end - i + 1 >= shortest) {
      std::fill(holds.begin() + static_cast<long>(i), holds.begin() + static_cast<long>(end) + 1, true);
      i = end + 1;
    } else {
      ++i;
    }
  }
  // Directions between turning points.
  std::size_t from = 0, extreme = 0;
  int direction = 0;
  const auto name = [&](std::size_t first, std::size_t last, int sign) {
    for (std::size_t i = first; i < last; ++i) found.segment[i] = sign >= 0 ? "load" : "unload";
  };
  for (std::size_t i = 1; i < n; ++i) {
    if (direction == 0) {
      if (std::abs(signal[i] - signal[0]) > turn) direction = signal[i] > signal[0] ? 1 : -1, extreme = i;
    } else if ((signal[i] - signal[extreme]) * direction >= 0) {
      extreme = i;
    } else if ((signal[extreme] - signal[i]) * direction > turn) {
      name(from, extreme + 1, direction);
      from = extreme + 1;
      direction = -direction;
      extreme = i;
    }
  }
  name(from, n, direction);
  double cycle = 0;
  for (std::size_t i = 1; i < n; ++i) {
    if (found.segment[i] == "load" && found.segment[i - 1] == "unload") ++cycle;
    found.cycle[i] = cycle;
  }
  for (std::size_t i = 0; i < n; ++i)
    if (holds[i]) found.segment[i] = "hold";
  return found;
}

}  // namespace asperity
