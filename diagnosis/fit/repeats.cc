#include "diagnosis/fit/repeats.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <map>
#include <numeric>

namespace asperity {
namespace {

using RunsAlike = std::vector<const SampleRun*>;

double control_of(const Sample& s, const std::string& channel) {
  return channel == "normal_displacement"    ? s.normal_displacement
         : channel == "normal_force"         ? s.normal_force
         : channel == "lateral_displacement" ? s.lateral_displacement
         : channel == "speed"                ? s.speed
                                             : 0.0;
}

/// Range of each channel of the control over some runs.
std::map<std::string, double> control_ranges(const std::vector<std::string>& channels, const Samples& samples,
                                             const RunsAlike& runs) {
  std::map<std::string, double> range;
  for (const auto& channel : channels) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const auto* run : runs)
      for (std::size_t i = run->begin; i < run->end; ++i) {
        low = std::min(low, control_of(samples.list[i], channel));
        high = std::max(high, control_of(samples.list[i], channel));
      }
    range[channel] = std::max(high - low, std::abs(high));
  }
  return range;
}

double duration_of(const Samples& samples, const SampleRun& run) {
  return samples.list[run.end - 1].time - samples.list[run.begin].time;
}

/// Sample by sample, within the range of each channel, and in the same time: what bodies give way with time
/// is no noise.
bool are_driven_alike(const Samples& samples, const SampleRun& one, const SampleRun& other,
                      const std::map<std::string, double>& range) {
  constexpr double same = 2e-3;       // of the range
  constexpr double same_speed = 0.1;  // relative
  if (one.end - one.begin != other.end - other.begin) return false;
  const double duration = duration_of(samples, one);
  if (std::abs(duration_of(samples, other) - duration) > same_speed * std::abs(duration)) return false;
  for (std::size_t i = 0; i < other.end - other.begin; ++i) {
    const Sample &a = samples.list[other.begin + i], &b = samples.list[one.begin + i];
    for (const auto& [channel, of_channel] : range)
      if (std::abs(a.speed - b.speed) > same_speed * b.speed ||
          std::abs(control_of(a, channel) - control_of(b, channel)) > same * of_channel)
        return false;
  }
  return true;
}

std::vector<RunsAlike> groups_of_repeats(const Samples& samples, const RunsAlike& runs,
                                         const std::map<std::string, double>& range) {
  std::vector<RunsAlike> groups;
  for (const auto* run : runs) {
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const RunsAlike& alike) {
      return are_driven_alike(samples, *alike.front(), *run, range);
    });
    if (group == groups.end())
      groups.push_back({run});
    else
      group->push_back(run);
  }
  return groups;
}

/// Sums of squares about the mean of what repeats have at one sample, by degrees of freedom.
using SquaresByFreedom = std::map<int, std::vector<double>>;

SquaresByFreedom squares_about_means(const Samples& samples, const std::vector<RunsAlike>& groups) {
  SquaresByFreedom squares;
  for (const auto& group : groups)
    for (std::size_t i = 0; i < group.front()->end - group.front()->begin; ++i) {
      std::vector<double> values;
      for (const auto* run : group)
        if (samples.list[run->begin + i].counts) values.push_back(samples.list[run->begin + i].response);
      if (values.size() < 2) continue;
      const double mean =
          std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
      double square = 0;
      for (const double value : values) square += std::pow(value - mean, 2);
      squares[static_cast<int>(values.size()) - 1].push_back(square);
    }
  return squares;
}

/// Without the highest fiftieth: outliers. What is left of Gaussian noise is less than all of it by a known
/// factor: x times the density of chi-square with n degrees is n times that with n + 2.
double trimmed_deviation(const SquaresByFreedom& squares) {
  double sum = 0, freedom = 0;
  for (const auto& [degrees, found] : squares) {
    std::vector<double> list = found;
    std::sort(list.begin(), list.end());
    const std::size_t cut = list.size() / 50, left = list.size() - cut;
    const double share = static_cast<double>(left) / static_cast<double>(list.size());
    double part = 1;
    if (cut > 0) {
      const double highest = quantile(boost::math::chi_squared(degrees), share);
      part = cdf(boost::math::chi_squared(degrees + 2), highest) / share;
    }
    sum += std::accumulate(list.begin(), list.begin() + static_cast<long>(left), 0.0) / part;
    freedom += static_cast<double>(left) * degrees;
  }
  return std::sqrt(sum / freedom);
}

}  // namespace

double scatter_of_repeats(const Recording& recording, const Samples& samples, std::size_t table) {
  constexpr std::size_t enough = 20;
  RunsAlike runs;
  for (const auto& run : samples.runs)
    if (run.table == table && !run.independent_rows) runs.push_back(&run);
  if (runs.size() < 2) return 0;
  const auto range = control_ranges(recording.tables[table].control, samples, runs);
  const SquaresByFreedom squares = squares_about_means(samples, groups_of_repeats(samples, runs, range));
  std::size_t count = 0;
  for (const auto& [degrees, list] : squares) count += list.size();
  return count < enough ? 0 : trimmed_deviation(squares);
}

}  // namespace asperity
