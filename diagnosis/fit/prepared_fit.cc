#include "diagnosis/fit/prepared_fit.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.h"
#include "diagnosis/fit/outliers.h"
#include "diagnosis/recording/probe_jumps.h"

namespace asperity {
namespace {

/// Samples on which a search is made before its last steps are taken on all.
constexpr std::size_t samples_of_search = 800;

/// What an experimenter set in a run, in steps of a tenth: runs of the same are repeats.
std::vector<double> setting_of(const Samples& samples, const SampleRun& run) {
  double load = 0, shallow = 0, deep = 0, speed = 0, left = 0, right = 0, time = 0;
  for (std::size_t i = run.begin; i < run.end; ++i) {
    const Sample& s = samples.list[i];
    load = std::max(load, std::abs(s.normal_force));
    shallow = std::min(shallow, s.normal_displacement), deep = std::max(deep, s.normal_displacement);
    left = std::min(left, s.lateral_displacement), right = std::max(right, s.lateral_displacement);
    speed = std::max(speed, s.speed), time = std::max(time, s.time - samples.list[run.begin].time);
  }
  std::vector<double> setting{static_cast<double>(run.table)};
  constexpr double step = 0.1;
  for (const double value : {load, deep - shallow, right - left, speed, time})
    setting.push_back(value > 0 ? std::round(std::log(value) / step) : -1e9);
  return setting;
}

/// Samples for the search. Repeats tell the noise apart and little else: where there are too many samples,
/// two runs of each setting are kept densely rather than all of them coarsely, so that more data lose no
/// detail. Runs keep their numbers; those that are left out are empty.
Samples samples_for_search(const Samples& all) {
  if (all.list.size() <= samples_of_search) return all;
  constexpr int kept_repeats = 2;
  Samples few = all;
  few.list.clear();
  std::map<std::vector<double>, int> seen;
  for (auto& run : few.runs) {
    const std::size_t from = run.begin, to = run.end;
    const bool kept = run.independent_rows || seen[setting_of(all, run)]++ < kept_repeats;
    run.begin = few.list.size();
    if (kept)
      few.list.insert(few.list.end(), all.list.begin() + static_cast<long>(from),
                      all.list.begin() + static_cast<long>(to));
    run.end = few.list.size();
  }
  return thinned(few, samples_of_search);
}

FitProblem problem_of(const Recording& recording, Samples samples) {
  FitProblem problem;
  problem.samples = std::move(samples);
  problem.experiment = experiment_of(recording, problem.samples);
  if (!(problem.experiment.largest_force > 0))
    throw InputError(
        "no sample presses: the largest normal force is not above zero; check the sign (compression is "
        "positive)");
  if (problem.experiment.largest_response <= 0)
    throw InputError("the response is zero throughout; check the column");
  problem.choice = completed(recording.simulation, problem.experiment);
  return problem;
}

}  // namespace

bool PreparedFit::learn_noise(const std::vector<double>& residual, double off) {
  Noise learned = short_scale_noise;
  if (!refine_noise(problem.samples, residual, learned, off)) return false;
  problem.noise = learned;
  return true;
}

bool PreparedFit::pass_on_deviations(const ModelFit& fit) {
  const auto is_of_rows = [](const NoisyControl& control) { return control.by_row; };
  if (noisy_controls.empty() || !std::all_of(noisy_controls.begin(), noisy_controls.end(), is_of_rows))
    return false;
  Noise anew = of_response;
  add_noise_of_controls(noisy_controls, problem, fit, anew);
  constexpr double little = 0.05;
  bool changes = false;
  for (std::size_t i = 0; i < anew.sd.size(); ++i)
    changes = changes || std::abs(anew.sd[i] / problem.noise.sd[i] - 1) > little;
  if (!changes) return false;
  problem.noise = anew;
  baseline = fit_explanation(problem, {});
  problem.baseline_residual = baseline.residual(problem.samples);
  return true;
}

PreparedFit prepared_fit(const Recording& recording, const std::function<void(const std::string&)>& progress,
                         const MakeCorrection& correct) {
  check_recording(recording);
  const auto say = [&](const std::string& what) {
    if (progress) progress(what);
  };
  say("reading " + std::to_string(recording.tables.size()) +
      (recording.tables.size() == 1 ? " table" : " tables"));
  PreparedFit prepared;
  Samples samples = samples_of(recording);
  if (recording.mode == Motion::normal) prepared.in_jumps = mark_probe_jumps(samples);
  FitProblem& problem = prepared.problem = problem_of(recording, std::move(samples));
  if (correct) correct(problem);
  say("simulating " + std::to_string(problem.samples.list.size()) + " samples with " +
      (problem.correction ? "the case's solution" : "the laws named"));
  std::vector<double> recorded(problem.samples.list.size());
  for (std::size_t i = 0; i < recorded.size(); ++i) recorded[i] = problem.samples.list[i].response;
  const Noise recorded_noise = problem.noise = estimate_noise(recording, problem.samples, recorded);
  std::vector<NoisyControl>& noisy = prepared.noisy_controls;
  constexpr int rounds = 2;  // a first noise to fit with, then that of the fit's own residuals
  for (int round = 0; round < rounds; ++round) {
    if (round == 0 && problem.experiment.mode != Motion::normal)
      mark_beginnings(problem.samples, problem.noise);
    problem.thin = samples_for_search(problem.samples);
    problem.baseline_residual.clear();
    prepared.baseline = fit_explanation(problem, {});
    problem.baseline_residual = prepared.baseline.residual(problem.samples);
    Noise again = estimate_noise(recording, problem.samples, problem.baseline_residual);
    // A simulation that is far off, or driven by a noisy displacement, adds structure at short distances: the
    // smoother of both, the recorded signal and its residual, holds the noise.
    if (again.sd.front() < recorded_noise.sd.front() || !again.is_absolute)
      problem.noise = again;
    else
      problem.noise = recorded_noise;
    if (round == 0) noisy = noisy_controls(recording, problem, prepared.baseline);
    prepared.of_response = problem.noise;
    add_noise_of_controls(noisy, problem, prepared.baseline, problem.noise);
    if (round > 0) continue;
    prepared.outliers = mark_outliers(problem.samples, problem.baseline_residual, problem.noise);
    smooth_controls(problem.samples, noisy);
  }
  problem.thin = samples_for_search(problem.samples);
  prepared.short_scale_noise = problem.noise;
  prepared.learn_noise(problem.baseline_residual);
  prepared.baseline = fit_explanation(problem, {});
  problem.baseline_residual = prepared.baseline.residual(problem.samples);
  return prepared;
}

}  // namespace asperity
