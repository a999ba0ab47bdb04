#include "diagnosis/fit/noise_of_control.h"

#include <algorithm>
#include <cmath>

#include "core/printable.h"
#include "diagnosis/recording/control_noise.h"
#include "diagnosis/recording/smoothed_control.h"

namespace asperity {
namespace {

using Channel = double Sample::*;

using DrivingChannels = std::vector<std::pair<std::string, Channel>>;

/// Of a trace what drives it, of a series all that its rows vary.
DrivingChannels driving_channels(const RecordingTable& table, Motion mode) {
  DrivingChannels list;
  if (mode == Motion::normal && table.response != "normal_displacement")
    list.push_back({"normal_displacement", &Sample::normal_displacement});
  else
    list.push_back({"normal_force", &Sample::normal_force});
  if (table.kind == TableKind::trace) return list;
  const DrivingChannels others{{"speed", &Sample::speed},
                               {"radius", &Sample::radius},
                               {"rms_roughness", &Sample::rms_roughness},
                               {"rail_angle", &Sample::rail_angle},
                               {"humidity", &Sample::humidity}};
  for (const auto& other : others)
    if (table.has(other.first)) list.push_back(other);
  return list;
}

/// Standard deviations of the channel in all samples of one table: as its row gives, else as given for all,
/// else what the sample's run scatters over neighbours, of traces; 0 in other tables.
std::vector<double> noise_of_channel(const Recording& recording, const Samples& samples, std::size_t table,
                                     const std::string& name, Channel channel) {
  std::vector<double> sd(samples.list.size(), 0.0);
  const auto given = recording.noise.find(name);
  const auto by_row = recording.tables[table].columns.find(name + "_sd");
  for (const auto& run : samples.runs) {
    if (run.table != table) continue;
    std::vector<double> signal;
    for (std::size_t i = run.begin; i < run.end && !run.independent_rows; ++i)
      signal.push_back(samples.list[i].*channel);
    const double of_run = given != recording.noise.end() ? given->second : control_noise(signal);
    for (std::size_t i = run.begin; i < run.end; ++i) {
      sd[i] = of_run;
      if (by_row == recording.tables[table].columns.end()) continue;
      const double of_row = by_row->second[static_cast<std::size_t>(samples.list[i].row)];
      if (of_row > 0) sd[i] = of_row;
    }
  }
  return sd;
}

/// Change of the simulation with the channel's noise, of all samples: half of that between one standard
/// deviation more and one less.
std::vector<double> passed_on(const ModelFit& fit, const Samples& samples, Channel channel,
                              const std::vector<double>& sd) {
  constexpr double least = 0.01;  // of what presses: without it the contact is lost
  Samples more = samples, less = samples;
  for (std::size_t i = 0; i < sd.size(); ++i) {
    const double value = samples.list[i].*channel;
    more.list[i].*channel += sd[i];
    less.list[i].*channel = value > 0 ? std::max(value - sd[i], least * value) : value - sd[i];
  }
  const std::vector<double> high = fit.simulate(more), low = fit.simulate(less);
  std::vector<double> change(high.size());
  for (std::size_t i = 0; i < change.size(); ++i) change[i] = std::abs(high[i] - low[i]) / 2;
  return change;
}

/// The residual of one table over its noise with `part` of what is passed on.
ShortScaleNoise scatter_with(const Samples& samples, std::size_t table, const std::vector<double>& residual,
                             const std::vector<double>& sd, const std::vector<double>& passed, double part) {
  std::vector<double> normal(residual.size());
  for (std::size_t i = 0; i < normal.size(); ++i)
    normal[i] = residual[i] / std::hypot(sd[i], part * passed[i]);
  return short_scale_noise(blocks_of(samples, normal, table));
}

/// Whether what is passed on accounts for a residual that scatters over neighbours by more than its noise:
/// for half of its variance beyond that, and not with a small part of it, as where the response follows.
bool accounts_for_scatter(const Samples& samples, std::size_t table, const std::vector<double>& residual,
                          const std::vector<double>& sd, const std::vector<double>& passed) {
  constexpr double clear = 4;  // standard deviations
  constexpr double least = 0.5;
  constexpr std::size_t fewest = 30;
  const auto scatter = [&](double part) { return scatter_with(samples, table, residual, sd, passed, part); };
  const ShortScaleNoise without = scatter(0);
  if (without.count < fewest) return false;
  if (without.sd < 1 + clear / std::sqrt(static_cast<double>(without.count))) return false;
  const auto variance = [](double sd) { return sd * sd; };
  return scatter(least).sd > 1 && variance(scatter(1).sd) - 1 < least * (variance(without.sd) - 1);
}

/// Adds what is passed on to the noise of one table, with the correlation that is left then.
void add_to(Noise& noise, const Samples& samples, std::size_t table, const std::vector<double>& residual,
            const std::vector<double>& passed) {
  const ShortScaleNoise left = scatter_with(samples, table, residual, noise.sd, passed, 1);
  for (std::size_t r = 0; r < samples.runs.size(); ++r) {
    const SampleRun& run = samples.runs[r];
    if (run.table != table) continue;
    if (!run.independent_rows) noise.shared[r] = {1, left.correlation};
    for (std::size_t i = run.begin; i < run.end; ++i) noise.sd[i] = std::hypot(noise.sd[i], passed[i]);
  }
}

double mean_square(const Samples& samples, std::size_t table, const std::vector<double>& values) {
  double squares = 0, count = 0;
  for (const auto& run : samples.runs)
    for (std::size_t i = run.begin; i < run.end && run.table == table; ++i)
      squares += values[i] * values[i], ++count;
  return count > 0 ? squares / count : 0;
}

}  // namespace

std::vector<NoisyControl> noisy_controls(const Recording& recording, const FitProblem& problem,
                                         const ModelFit& baseline) {
  std::vector<NoisyControl> found;
  const Samples& samples = problem.samples;
  for (std::size_t t = 0; t < recording.tables.size(); ++t) {
    const RecordingTable& table = recording.tables[t];
    const bool is_series = table.kind == TableKind::series;
    // What scatters over repeats or neighbours holds the noise of the load already.
    if (is_series ? problem.noise.from[t].rfind("given", 0) != 0 : problem.noise.from[t] == "residuals")
      continue;
    for (const auto& [name, channel] : driving_channels(table, recording.mode)) {
      NoisyControl control{t, is_series, name, channel,
                           noise_of_channel(recording, samples, t, name, channel)};
      control.largest = *std::max_element(control.sd.begin(), control.sd.end());
      if (!(control.largest > 0)) continue;
      const std::vector<double> passed = passed_on(baseline, samples, channel, control.sd);
      if (!is_series &&
          !accounts_for_scatter(samples, t, problem.baseline_residual, problem.noise.sd, passed))
        continue;
      control.over_noise =
          std::sqrt(mean_square(samples, t, passed) / mean_square(samples, t, problem.noise.sd));
      found.push_back(control);
    }
  }
  return found;
}

void smooth_controls(Samples& samples, std::vector<NoisyControl>& controls) {
  constexpr double well_below = 0.2;  // of the noise of the response
  for (NoisyControl& control : controls)
    for (const auto& run : samples.runs) {
      if (run.table != control.table || run.independent_rows) continue;
      const std::vector<double> left =
          smooth_control(samples, run, control.channel, well_below / control.over_noise);
      for (std::size_t i = run.begin; i < run.end; ++i) control.sd[i] *= left[i - run.begin];
    }
}

void add_noise_of_controls(const std::vector<NoisyControl>& controls, const FitProblem& problem,
                           const ModelFit& baseline, Noise& noise) {
  for (const NoisyControl& control : controls) {
    const std::vector<double> passed = passed_on(baseline, problem.samples, control.channel, control.sd);
    add_to(noise, problem.samples, control.table, problem.baseline_residual, passed);
    noise.of_control.push_back({control.name, problem.samples.response_channels[control.table], control.table,
                                control.by_row, control.largest,
                                std::sqrt(mean_square(problem.samples, control.table, passed))});
  }
}

std::vector<std::string> unused_deviations(const Recording& recording, const Noise& noise) {
  std::vector<std::string> remarks;
  for (std::size_t t = 0; t < recording.tables.size(); ++t) {
    const RecordingTable& table = recording.tables[t];
    const DrivingChannels driving = driving_channels(table, recording.mode);
    for (const std::string& channel : known_channels()) {
      if (channel == table.response || !table.has(channel + "_sd")) continue;
      const bool counts = std::any_of(noise.of_control.begin(), noise.of_control.end(),
                                      [&](const auto& of) { return of.table == t && of.channel == channel; });
      if (counts) continue;
      const bool drives = std::any_of(driving.begin(), driving.end(),
                                      [&](const auto& other) { return other.first == channel; });
      const std::string why =
          !drives ? "no simulation of this table passes it on"
          : table.kind == TableKind::series
              ? "the noise of '" + table.response + "', from " + noise.from[t] + ", holds it already"
              : "what is left of '" + table.response + "' scatters by no more than its own noise";
      remarks.push_back(printable(table.file) + ": '" + channel + "_sd' is not used: " + why);
    }
  }
  for (const auto& given : recording.noise) {
    const std::string& name = given.first;
    const bool counts = std::any_of(recording.tables.begin(), recording.tables.end(),
                                    [&](const RecordingTable& table) { return table.response == name; }) ||
                        std::any_of(noise.of_control.begin(), noise.of_control.end(),
                                    [&](const NoiseOfControl& of) { return of.channel == name; });
    if (!counts) remarks.push_back("the noise given of '" + name + "' is not used: no response shows it");
  }
  return remarks;
}

}  // namespace asperity
