#include "diagnosis/fit/prepared_fit.h"

#include "core/error.h"

namespace asperity {
namespace {

/// Samples on which a search is made before its last steps are taken on all.
constexpr std::size_t samples_of_search = 800;

FitProblem problem_of(const Recording& recording) {
  FitProblem problem;
  problem.samples = samples_of(recording);
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

bool PreparedFit::learn_noise(const std::vector<double>& residual) {
  Noise learned = short_scale_noise;
  if (!refine_noise(problem.samples, residual, learned)) return false;
  problem.noise = learned;
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
  FitProblem& problem = prepared.problem = problem_of(recording);
  if (correct) correct(problem);
  say("simulating " + std::to_string(problem.samples.list.size()) + " samples with " +
      (problem.correction ? "the case's solution" : "the laws named"));
  std::vector<double> recorded(problem.samples.list.size());
  for (std::size_t i = 0; i < recorded.size(); ++i) recorded[i] = problem.samples.list[i].response;
  const Noise recorded_noise = problem.noise = estimate_noise(recording, problem.samples, recorded);
  constexpr int rounds = 2;  // a first noise to fit with, then that of the fit's own residuals
  for (int round = 0; round < rounds; ++round) {
    if (round == 0 && problem.experiment.mode != Motion::normal)
      mark_beginnings(problem.samples, problem.noise);
    problem.thin = thinned(problem.samples, samples_of_search);
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
    if (round == 0)
      prepared.outliers = mark_outliers(problem.samples, problem.baseline_residual, problem.noise);
  }
  problem.thin = thinned(problem.samples, samples_of_search);
  prepared.short_scale_noise = problem.noise;
  prepared.learn_noise(problem.baseline_residual);
  prepared.baseline = fit_explanation(problem, {});
  problem.baseline_residual = prepared.baseline.residual(problem.samples);
  return prepared;
}

}  // namespace asperity
