#include "diagnosis/fit/noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "diagnosis/fit/repeats.h"
#include "diagnosis/recording/median.h"

namespace asperity {
namespace {

/// Of the square of a unit normal variable: its median, and the mean of its lowest 60 % (0.1288/0.6).
constexpr double median_of_square = 0.454936, trimmed_mean_of_square = 0.2146, kept = 0.6;

/// Rows of a series that were recorded under the same settings in the same direction: scatter about their
/// mean, pooled; 0 with fewer than eight rows beyond the first of each.
double scatter_of_repeated_rows(const Samples& samples, const std::vector<double>& residual,
                                std::size_t table) {
  std::map<std::array<double, 9>, std::vector<double>> repeated;
  for (const auto& run : samples.runs)
    if (run.table == table && run.independent_rows)
      for (std::size_t i = run.begin; i < run.end; ++i) {
        const Sample& s = samples.list[i];
        if (s.counts)
          repeated[{s.normal_force, s.normal_displacement, s.rms_roughness, s.speed, s.radius, s.rail_angle,
                    s.humidity, s.cycle, static_cast<double>(s.direction)}]
              .push_back(residual[i]);
      }
  constexpr std::size_t enough = 8;
  double squares = 0;
  std::size_t beyond_first = 0;
  for (const auto& [settings, values] : repeated) {
    const double mean =
        std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    for (const double value : values) squares += (value - mean) * (value - mean);
    beyond_first += values.size() - 1;
  }
  return beyond_first < enough ? 0 : std::sqrt(squares / static_cast<double>(beyond_first));
}

/// Rows of a series in the order of their load: scatter about the line between neighbours.
double scatter_of_series(const Samples& samples, const std::vector<double>& residual, std::size_t table) {
  std::vector<std::pair<double, double>> points;
  for (const auto& run : samples.runs)
    if (run.table == table)
      for (std::size_t i = run.begin; i < run.end; ++i)
        if (samples.list[i].counts) points.push_back({samples.list[i].normal_force, residual[i]});
  constexpr std::size_t enough = 10;
  if (points.size() < enough) return 0;
  std::sort(points.begin(), points.end());
  std::vector<double> squares;
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    squares.push_back(std::pow(points[i - 1].second - 2 * points[i].second + points[i + 1].second, 2) / 6);
  return std::sqrt(median(squares) / median_of_square);
}

}  // namespace

std::vector<std::vector<double>> blocks_of(const Samples& samples, const std::vector<double>& values,
                                           std::size_t table) {
  std::vector<std::vector<double>> list;
  for (const auto& run : samples.runs) {
    if (run.table != table || run.independent_rows) continue;
    for (std::size_t i = run.begin; i < run.end; ++i) {
      const Sample& s = samples.list[i];
      if (i == run.begin || s.part != samples.list[i - 1].part || !samples.list[i - 1].counts)
        list.emplace_back();
      if (s.counts) list.back().push_back(values[i]);
    }
  }
  return list;
}

ShortScaleNoise short_scale_noise(const std::vector<std::vector<double>>& blocks) {
  const std::size_t lags[] = {1, 2, 3};
  double variance[3] = {};
  std::size_t count = 0;
  for (int l = 0; l < 3; ++l) {
    const std::size_t k = lags[l];
    std::vector<double> squares;
    for (const auto& r : blocks)
      for (std::size_t i = k; i + k < r.size(); ++i)
        squares.push_back(std::pow(r[i - k] - 2 * r[i] + r[i + k], 2));
    if (l == 0) count = squares.size();
    if (squares.empty()) continue;
    const auto end =
        squares.begin() + std::max<long>(1, std::lround(kept * static_cast<double>(squares.size())));
    std::nth_element(squares.begin(), end - 1, squares.end());
    variance[l] = std::accumulate(squares.begin(), end, 0.0) / static_cast<double>(end - squares.begin()) /
                  trimmed_mean_of_square;
  }
  if (!(variance[0] > 0)) return {0, 0, count};
  const auto shape = [](double rho, double k) {
    const double q = std::pow(rho, k);
    return 6 - 8 * q + 2 * q * q;
  };
  // The rho whose three variances lie nearest in ratio; smooth mismatch makes those at longer distances too
  // large only.
  const auto misfit = [&](double rho) {
    double sum = 0;
    const double first = std::log(variance[0] / shape(rho, 1));
    for (int l = 1; l < 3; ++l)
      if (variance[l] > 0)
        sum += std::pow(std::log(variance[l] / shape(rho, static_cast<double>(lags[l]))) - first, 2) /
               static_cast<double>(l);
    return sum;
  };
  double best = 0;
  for (double rho = 0; rho <= largest_memory; rho += 0.005)
    if (misfit(rho) < misfit(best)) best = rho;
  // The variances scatter by 2/n^(1/2), relative: what does not stand out from that is no correlation.
  const double scatter = 4 / static_cast<double>(std::max<std::size_t>(1, count));
  if (misfit(0) - misfit(best) < 3 * scatter) best = 0;
  return {std::sqrt(variance[0] / shape(best, 1)), best, count};
}

Noise estimate_noise(const Recording& recording, const Samples& samples,
                     const std::vector<double>& residual) {
  Noise noise;
  noise.sd.assign(samples.list.size(), 0.0);
  noise.shared.assign(samples.runs.size(), {});
  for (std::size_t t = 0; t < recording.tables.size(); ++t) {
    const RecordingTable& table = recording.tables[t];
    const bool by_row = table.has(table.response + "_sd");
    const auto given = recording.noise.find(table.response);
    const ShortScaleNoise fast = short_scale_noise(blocks_of(samples, residual, t));
    double sd = 0;
    std::string from;
    constexpr std::size_t enough = 30;
    if (by_row)
      from = "given by row";
    else if (given != recording.noise.end())
      sd = given->second, from = "given";
    else if ((sd = scatter_of_repeats(recording, samples, t)) > 0 ||
             (sd = scatter_of_repeated_rows(samples, residual, t)) > 0)
      from = "repeats";
    else if (table.kind == TableKind::trace && fast.count >= enough)
      sd = fast.sd, from = "high frequencies";
    else if ((sd = scatter_of_series(samples, residual, t)) > 0)
      from = "neighbouring rows";
    if (from.empty() || (!by_row && !(sd > 0))) {
      double sum = 0, count = 0;
      for (const auto& run : samples.runs)
        if (run.table == t)
          for (std::size_t i = run.begin; i < run.end; ++i)
            if (samples.list[i].counts) sum += residual[i] * residual[i], ++count;
      sd = std::sqrt(sum / std::max(1.0, count - 1));
      from = "residuals";
      noise.is_absolute = false;
    }
    noise.from.push_back(from);
    const double floor = 1e-9 * std::max(1e-300, sd);
    double median_given = sd;
    if (by_row) {
      std::vector<double> values;
      for (const double value : table.column(table.response + "_sd"))
        if (value > 0) values.push_back(value);
      median_given = median(values);
    }
    for (std::size_t r = 0; r < samples.runs.size(); ++r) {
      if (samples.runs[r].table != t) continue;
      for (std::size_t i = samples.runs[r].begin; i < samples.runs[r].end; ++i)
        noise.sd[i] = std::max(floor, by_row && samples.list[i].sd > 0 ? samples.list[i].sd
                                      : by_row                         ? median_given
                                                                       : sd);
      if (!samples.runs[r].independent_rows && fast.count >= enough) noise.shared[r] = {1, fast.correlation};
    }
  }
  return noise;
}

void mark_beginnings(Samples& samples, const Noise& noise) {
  constexpr double clear = 3;      // standard deviations
  constexpr double sliding = 0.9;  // of the force later in the segment
  for (auto& run : samples.runs) {
    if (run.independent_rows) continue;
    const Sample& first = samples.list[run.begin];
    run.first_response =
        first.counts && std::abs(first.response) > clear * noise.sd[first.index] ? first.response : 0;
    std::size_t end = run.begin;
    while (end < run.end && samples.list[end].direction == first.direction) ++end;
    if (end == run.end) continue;
    std::vector<double> later;
    for (std::size_t i = run.begin + (end - run.begin) / 2; i < end; ++i)
      if (samples.list[i].counts) later.push_back(samples.list[i].response * first.direction);
    const double reached = sliding * median(later);
    for (std::size_t i = run.begin; i < end && samples.list[i].response * first.direction < reached; ++i)
      samples.list[i].counts = false;
  }
}

bool refine_noise(const Samples& samples, const std::vector<double>& residual, Noise& noise, double off) {
  constexpr std::size_t fewest = 100;
  bool changed = false;
  for (std::size_t t = 0; t < noise.from.size(); ++t) {
    if (noise.from[t] == "residuals" || noise.from[t] == "given by row") continue;
    std::size_t count = 0;
    bool trace = false;
    for (const auto& run : samples.runs)
      if (run.table == t) {
        trace = !run.independent_rows;
        for (std::size_t i = run.begin; i < run.end; ++i) count += samples.list[i].counts;
      }
    if (!trace || count < fewest) continue;
    const MeasuredNoise measured = measured_noise(samples, residual, noise.sd, t);
    // What a fit leaves is no less than the noise: an estimate above it took the signal for noise.
    const bool is_estimate = noise.from[t] == "high frequencies";
    if (measured.sd > off || (!is_estimate && measured.sd < 1 / off)) continue;
    changed = true;
    for (std::size_t r = 0; r < samples.runs.size(); ++r) {
      const SampleRun& run = samples.runs[r];
      if (run.table != t) continue;
      noise.shared[r] = measured.shared;
      if (noise.from[t] != "high frequencies") continue;
      for (std::size_t i = run.begin; i < run.end; ++i) noise.sd[samples.list[i].index] *= measured.sd;
    }
  }
  return changed;
}

std::vector<double> whitened(const Samples& samples, const std::vector<double>& residual,
                             const Noise& noise) {
  return NoiseFilter(samples, noise.sd, noise.shared).whitened(residual);
}

double shared_variance(const Samples& samples, const std::vector<double>& residual, const Noise& noise) {
  constexpr std::size_t reach = 30;
  if (std::any_of(samples.runs.begin(), samples.runs.end(),
                  [](const SampleRun& r) { return r.independent_rows; }))
    return 1;
  std::vector<double> white = whitened(samples, residual, noise);
  constexpr double far = 3;  // single large ones say nothing of what neighbours share
  double square = 0;
  for (double& value : white) {
    value = std::clamp(value, -far, far);
    square += value * value;
  }
  if (white.size() <= reach || !(square > 0)) return 1;
  double factor = 1;
  for (std::size_t k = 1; k <= reach; ++k) {
    double product = 0;
    for (std::size_t i = k; i < white.size(); ++i) product += white[i] * white[i - k];
    factor += 2 * (1 - static_cast<double>(k) / (reach + 1)) * product / square;
  }
  return std::max(1.0, factor);
}

bool neighbours_share_no_more(const Samples& samples, const std::vector<double>& residual, const Noise& noise,
                              std::size_t count) {
  const double chance = 20 / std::sqrt(static_cast<double>(std::max<std::size_t>(1, count)));
  return shared_variance(samples, residual, noise) < 1 + chance;
}

}  // namespace asperity
