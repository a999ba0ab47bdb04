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

double SlidingTrace::log_likelihood(double period, const Shape& shape) const {
  const std::vector<double> phase = phases(period);
  double forces = 0, both = 0, shapes = 0, count = 0;
  for (const Part& part : parts_) {
    double sum = 0, sliding = 0;
    for (const Point& point : part)
      if (point.slides) sum += shape(phase[point.index]), ++sliding;
    for (const Point& point : part) {
      if (!point.slides) continue;
      const double s = shape(phase[point.index]) - sum / sliding;
      forces += point.force * point.force;
      both += point.force * s;
      shapes += s * s;
    }
    count += sliding;
  }
  const double left = forces - (shapes > 0 ? both * both / shapes : 0);
  return left > 0 ? -0.5 * count * std::log(left / count) : 0;
}

double SlidingTrace::windows(double period) const {
  double count = 0;
  for (const Part& part : parts_)
    count += std::max(1.0, (1 - settled) * part.back().path / (periods_of_window * period));
  return count;
}

}  // namespace asperity
