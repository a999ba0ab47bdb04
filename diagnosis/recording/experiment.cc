#include "diagnosis/recording/experiment.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnosis/recording/median.h"
#include "diagnosis/recording/time_from_path.h"

namespace asperity {
namespace {

/// Values that differ by more than a tenth: less is the spread of one setting.
int different(std::vector<double> values) {
  constexpr double least_ratio = 1.1;
  std::sort(values.begin(), values.end());
  int count = 0;
  double last = 0;
  for (const double value : values)
    if (count == 0 || value > least_ratio * last) last = value, ++count;
  return count;
}

/// The value that a part of them stays below; 0 of none.
double quantile(std::vector<double> values, double part) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const auto last = static_cast<double>(values.size() - 1);
  return values[static_cast<std::size_t>(std::lround(part * last))];
}

void take_bodies(Experiment& e, const Recording& recording) {
  e.mode = recording.mode;
  e.particle = {recording.particle.youngs_modulus, recording.particle.poissons_ratio};
  e.substrate = {recording.substrate.youngs_modulus, recording.substrate.poissons_ratio};
  e.indenter = recording.indenter
                   ? ElasticBody{recording.indenter->youngs_modulus, recording.indenter->poissons_ratio}
                   : e.substrate;
  e.radius = recording.particle.radius;
  for (const double yield : {recording.particle.yield_stress, recording.substrate.yield_stress})
    if (yield > 0) e.yield_hint = e.yield_hint > 0 ? std::min(e.yield_hint, yield) : yield;
}

/// What all samples together say, beside what each alone widens in the experiment.
struct Gathered {
  std::vector<double> forces, speeds, approaches;
  std::map<std::string, std::vector<double>> set;  ///< by channel that an experimenter sets
  bool forward = false, backward = false;
  double deepest = 0, shallowest = 0;
};

void take_sample(Experiment& e, Gathered& all, const Sample& s, bool response_is_displacement) {
  const bool normal = e.mode == Motion::normal;
  const double force = normal && !response_is_displacement ? s.response : s.normal_force;
  const bool missing = normal && !s.counts;
  if (!missing || response_is_displacement) all.forces.push_back(force);
  if (force > 0) e.smallest_force = std::min(e.smallest_force, force);
  all.deepest =
      std::max(all.deepest, normal && response_is_displacement ? s.response : s.normal_displacement);
  all.shallowest = std::min(all.shallowest, s.normal_displacement);
  if (s.counts) e.largest_response = std::max(e.largest_response, std::abs(s.response));
  e.hold_duration = std::max(e.hold_duration, s.hold_time);
  if (s.speed > 0) all.speeds.push_back(s.speed);
  if (s.approach != 0) all.approaches.push_back(std::abs(s.approach));
  e.cycles = std::max(e.cycles, s.cycle + 1);
  e.smoothest = std::min(e.smoothest, s.rms_roughness);
  e.roughest = std::max(e.roughest, s.rms_roughness);
  e.smallest_radius = std::min(e.smallest_radius, s.radius);
  e.largest_radius = std::max(e.largest_radius, s.radius);
  if (s.counts) {
    all.set["rms_roughness"].push_back(s.rms_roughness);
    all.set["radius"].push_back(s.radius);
    all.set["rail_angle"].push_back(s.rail_angle);
    all.set["humidity"].push_back(s.humidity);
  }
  (s.direction > 0 ? all.forward : all.backward) = true;
}

void take_run(Experiment& e, Gathered& all, const SampleRun& run, const Samples& samples) {
  (run.independent_rows ? e.has_series : e.has_trace) = true;
  if (e.mode == Motion::normal && !run.response_is_displacement) e.response_is_force = true;
  double left = std::numeric_limits<double>::infinity(), right = -left;
  for (std::size_t i = run.begin; i < run.end; ++i) {
    const Sample& s = samples.list[i];
    take_sample(e, all, s, run.response_is_displacement);
    left = std::min(left, s.lateral_displacement);
    right = std::max(right, s.lateral_displacement);
  }
  const double lasted = samples.list[run.end - 1].time - samples.list[run.begin].time;
  if (!run.independent_rows && lasted > 0) {
    e.slowest_run = e.slowest_run > 0 ? std::min(e.slowest_run, 1 / lasted) : 1 / lasted;
    e.fastest_run = std::max(e.fastest_run, 1 / lasted);
  }
  e.stroke = std::max(e.stroke, right - left);
  e.duration = std::max(e.duration, lasted);
}

}  // namespace

Experiment experiment_of(const Recording& recording, const Samples& samples) {
  constexpr double least_part = 0.02;  // of the largest displacement, beyond which nothing touches
  Experiment e;
  take_bodies(e, recording);
  e.smallest_force = e.smoothest = e.smallest_radius = std::numeric_limits<double>::infinity();
  Gathered all;
  for (const auto& run : samples.runs) take_run(e, all, run, samples);
  e.has_time =
      e.has_trace && std::all_of(samples.runs.begin(), samples.runs.end(), [&](const SampleRun& run) {
        return run.independent_rows || time_is_known(recording, recording.tables[run.table]);
      });
  for (auto& [channel, values] : all.set) e.different[channel] = different(std::move(values));
  e.largest_force = *std::max_element(all.forces.begin(), all.forces.end());
  std::vector<double> sizes;
  for (const double f : all.forces) sizes.push_back(std::abs(f));
  e.typical_force = median(sizes);
  if (e.typical_force <= 0) e.typical_force = e.largest_force;
  e.largest_displacement = recording.mode == Motion::normal && all.deepest > 0
                               ? all.deepest
                               : e.hertz().approach(std::max(e.largest_force, 0.0));
  if (e.mode == Motion::sliding && e.has_trace) e.sliding_trace = std::make_shared<SlidingTrace>(samples);
  e.has_both_directions = all.forward && all.backward;
  e.has_unloading = recording.mode == Motion::normal && all.backward;
  e.has_off_contact = recording.mode == Motion::normal && all.shallowest < 0;
  if (e.has_off_contact)
    e.samples_off_contact = static_cast<std::size_t>(
        std::count_if(samples.list.begin(), samples.list.end(), [&](const Sample& s) {
          return s.counts && s.normal_displacement < -least_part * e.largest_displacement;
        }));
  constexpr double outermost = 0.05;  // beyond, speeds are those of single steps near turns
  e.slowest = quantile(all.speeds, outermost);
  e.fastest = quantile(all.speeds, 1 - outermost);
  e.fastest_approach = quantile(all.approaches, 1 - outermost);
  if (!std::isfinite(e.smallest_force)) e.smallest_force = e.typical_force;
  return e;
}

}  // namespace asperity
