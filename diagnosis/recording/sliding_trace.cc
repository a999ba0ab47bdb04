#include "diagnosis/recording/sliding_trace.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace asperity {
namespace {

constexpr double periods_of_window = 3;   // fewer tell a phase badly, and events drift over more
constexpr std::size_t fewest_points = 6;  // of a segment that has a phase

}  // namespace

SlidingTrace::SlidingTrace(const Samples& samples) {
  for (const auto& run : samples.runs) {
    for (std::size_t from = run.begin, to = from; from < run.end; from = to) {
      Part part;
      double longest = 0;
      for (; to < run.end && samples.list[to].part == samples.list[from].part; ++to) {
        const Sample& s = samples.list[to];
        count_ = std::max(count_, s.index + 1);
        longest = std::max(longest, s.since_reversal);
        if (!run.independent_rows && s.counts)
          part.push_back({s.index, s.since_reversal, s.response * s.direction, false});
      }
      double sum = 0, sliding = 0;
      for (Point& point : part) {
        point.slides = point.path >= settled * longest;
        if (point.slides) sum += point.force, ++sliding;
      }
      if (sliding < fewest_points) continue;
      for (Point& point : part) point.force -= sum / sliding;
      parts_.push_back(std::move(part));
    }
  }
}

std::vector<double> SlidingTrace::phases(double period) const {
  std::vector<double> phases(count_, 0.0);
  const double half = 0.5 * periods_of_window * period;
  for (const Part& part : parts_) {
    std::vector<std::complex<double>> sums{0};  // over the points before
    for (const Point& point : part)
      sums.push_back(sums.back() +
                     (point.slides ? point.force * std::polar(1.0, -2 * M_PI * point.path / period) : 0.0));
    const auto slides = [](const Point& point) { return point.slides; };
    const double first = std::find_if(part.begin(), part.end(), slides)->path, last = part.back().path;
    std::size_t low = 0, high = 0;
    for (const Point& point : part) {
      // The window keeps its width at the ends of the segment.
      const double middle = std::max(first + half, std::min(point.path, last - half));
      while (low < part.size() && part[low].path < middle - half) ++low;
      while (high < part.size() && part[high].path <= middle + half) ++high;
      // -sin(theta)/pi is the first harmonic of frac - 1/2, which a wave of phase theta + pi/2 stands for.
      const double wave = std::arg(sums[high] - sums[low]);
      const double passed = point.path / period + wave / (2 * M_PI) - 0.25;
      phases[point.index] = passed - std::floor(passed);
    }
  }
  return phases;
}

double SlidingTrace::largest_suddenness(double period, double drop) const {
  constexpr double lag_of_period = 0.2, longest_lag = 0.45;
  double cubes = 0, squares = 0, expected = 0, count = 0, independent = 0;
  for (const Part& part : parts_) {
    const auto from = static_cast<std::size_t>(
        std::find_if(part.begin(), part.end(), [](const Point& point) { return point.slides; }) -
        part.begin());
    const double spacing = (part.back().path - part[from].path) / static_cast<double>(part.size() - 1 - from);
    const auto lag = static_cast<std::size_t>(std::max(1.0, std::round(lag_of_period * period / spacing)));
    const double q = static_cast<double>(lag) * spacing / period;
    if (!(spacing > 0) || !(q < longest_lag) || from + 2 * lag >= part.size()) continue;
    const auto differences = static_cast<double>(part.size() - lag - from);
    double slope = 0;
    for (std::size_t i = from + lag; i < part.size(); ++i)
      slope += (part[i].force - part[i - lag].force) / differences;
    for (std::size_t i = from + lag; i < part.size(); ++i) {
      const double cube = std::pow(part[i].force - part[i - lag].force - slope, 3);
      cubes += cube;
      squares += cube * cube;
    }
    expected -= differences * std::pow(drop, 3) * q * (1 - q) * (1 - 2 * q);
    count += differences;
    independent += differences / static_cast<double>(lag);
  }
  if (!(independent > 1) || !(expected < 0)) return 1;
  const double variance = std::max(0.0, squares / count - std::pow(cubes / count, 2));
  return cubes / expected + 2 * count / std::abs(expected) * std::sqrt(variance / independent);
}

double SlidingTrace::windows(double period) const {
  double count = 0;
  for (const Part& part : parts_)
    count += std::max(1.0, (1 - settled) * part.back().path / (periods_of_window * period));
  return count;
}

}  // namespace asperity
