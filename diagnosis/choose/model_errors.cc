// What an explanation states of its own errors: mesh, surface, laws.
#include <algorithm>
#include <cmath>

#include "diagnosis/choose/law_error.h"
#include "diagnosis/fit/likely_surface.h"

namespace asperity {
namespace {

/// Largest within a twentieth of each part to either side: errors of a law do not vanish where its
/// contribution changes sign.
LawError largest_nearby(const Samples& samples, const LawError& error) {
  constexpr double reach_of_part = 0.05;
  LawError largest = error;
  for (const auto& run : samples.runs) {
    if (run.independent_rows) continue;
    for (std::size_t from = run.begin, to = from; from < run.end; from = to) {
      while (to < run.end && samples.list[to].part == samples.list[from].part) ++to;
      const auto reach = static_cast<std::size_t>(std::ceil(reach_of_part * static_cast<double>(to - from)));
      for (std::size_t i = from; i < to; ++i)
        largest[i] = *std::max_element(error.begin() + static_cast<long>(std::max(from + reach, i) - reach),
                                       error.begin() + static_cast<long>(std::min(to, i + reach + 1)));
    }
  }
  return largest;
}

/// What the hereditary integral of a case that relaxes may be off by: where the contact shrinks 0.3 % of the
/// largest force off boundary elements, 1 % of what relaxation changes.
LawError error_of_relaxation(const ModelFit& fit, const Explanation& elastic, const Samples& samples) {
  constexpr double accuracy = 0.02;
  const auto with = fit.simulate(samples), without = simulate(elastic.mechanics(fit.values), samples);
  LawError error(with.size());
  for (std::size_t i = 0; i < error.size(); ++i) error[i] = accuracy * std::abs(with[i] - without[i]);
  return largest_nearby(samples, error);
}

}  // namespace

std::vector<double> contribution_of(const Effect& effect, const FitProblem& problem, const Samples& samples,
                                    const ModelFit& fit, const std::vector<double>& with,
                                    const ModelFit& baseline) {
  std::vector<const Effect*> others;
  for (const Effect* other : fit.explanation->effects())
    if (other != &effect) others.push_back(other);
  const ModelFit fewer = fit.only(problem, others, baseline);
  const auto without = fewer.simulate(samples);
  double both = 0, own = 0;
  for (std::size_t i = 0; i < with.size(); ++i)
    if (samples.list[i].counts) both += with[i] * without[i], own += without[i] * without[i];
  const bool calibrated = !fewer.values.empty() && fewer.explanation->parameters().front().effect < 0;
  const double scale = calibrated && own > 0 ? both / own : 1;
  std::vector<double> contribution(with.size());
  for (std::size_t i = 0; i < with.size(); ++i) contribution[i] = with[i] - scale * without[i];
  return contribution;
}

Misfit shared_misfit(const FitProblem& problem, const ModelFit& fit) {
  const LikelySurface surface(problem, fit, problem.samples);
  Misfit misfit;
  misfit.residual = FitProblem::residual(problem.samples, surface.simulated(*fit.explanation, fit.values));
  misfit.errors.of_surfaces = surface.changes();
  if (fit.explanation->correction() && problem.experiment.mode != Motion::normal)
    misfit.errors.of_mesh = mesh_errors(fit, problem.samples);
  return misfit;
}

Misfit misfit_of(const FitProblem& problem, const ModelFit& fit, const ModelFit& baseline) {
  Misfit misfit = shared_misfit(problem, fit);
  ModelErrors own = law_errors(problem, fit, baseline);
  misfit.errors.of_laws = std::move(own.of_laws);
  misfit.errors.of_curves = std::move(own.of_curves);
  misfit.errors.of_mesh_along = std::move(own.of_mesh_along);
  return misfit;
}

LawError together(const std::vector<LawError>& errors, std::size_t count) {
  LawError all(count, 0.0);
  for (const LawError& error : errors)
    for (std::size_t i = 0; i < count; ++i) all[i] = std::hypot(all[i], error[i]);
  return all;
}

ModelErrors law_errors(const FitProblem& problem, const ModelFit& fit, const ModelFit& baseline,
                       const std::function<double(const Effect&)>& part) {
  const Samples& samples = problem.samples;
  const auto& effects = fit.explanation->effects();
  const auto with = fit.simulate(samples);
  ModelErrors errors;
  if (fit.explanation->correction())
    (problem.experiment.mode != Motion::normal ? errors.of_mesh : errors.of_mesh_along) =
        mesh_errors(fit, samples);
  if (const auto elastic = fit.explanation->without_relaxation_of_case())
    errors.of_laws.push_back(error_of_relaxation(fit, *elastic, samples));
  // What all change together bounds what one does: effects that undo each other lend each other no room.
  LawError changed(with.size());
  for (std::size_t i = 0; i < with.size(); ++i)
    changed[i] = samples.list[i].counts
                     ? std::abs(samples.list[i].response - problem.baseline_residual[i] - with[i])
                     : 0.0;
  changed = largest_nearby(samples, changed);
  const double largest = *std::max_element(changed.begin(), changed.end());
  for (const Effect* left_out : effects) {
    if (fit.is_confirmed && left_out->enters_by(problem.experiment) == EntersBy::finite_elements) continue;
    LawError error = contribution_of(*left_out, problem, samples, fit, with, baseline);
    for (double& change : error) change = std::abs(change);
    error = largest_nearby(samples, error);
    const EffectDescription& law = left_out->description();
    const double of_accuracy = part ? part(*left_out) : 1;
    for (std::size_t i = 0; i < error.size(); ++i)
      error[i] = of_accuracy *
                 std::hypot(law.accuracy * std::min(error[i], changed[i]),
                            std::min(law.accuracy_of_response * std::abs(with[i]), law.accuracy * largest));
    (left_out->is_one_curve(problem.experiment) ? errors.of_curves : errors.of_laws)
        .push_back(std::move(error));
  }
  return errors;
}

LawError law_error(const FitProblem& problem, const ModelFit& fit, const ModelFit& baseline) {
  const ModelErrors errors = law_errors(problem, fit, baseline);
  const std::size_t count = problem.samples.list.size();
  return together({together(errors.of_mesh, count), together(errors.of_mesh_along, count),
                   together(errors.of_laws, count), together(errors.of_curves, count)},
                  count);
}

double accuracy_of(const Effect& effect, const FitProblem& problem, const ModelFit& fit) {
  if (fit.is_confirmed && effect.enters_by(problem.experiment) == EntersBy::finite_elements) return 0;
  return effect.description().accuracy * (is_known_exactly(effect) ? fit.part_of_bound : 1);
}

bool is_known_exactly(const Effect& effect) {
  // Not one that states more than is usual, since others write it otherwise.
  const EffectDescription& law = effect.description();
  return (law.kind == EffectKind::instrument || effect.is_another_value()) &&
         law.accuracy <= EffectDescription::usual_accuracy;
}

}  // namespace asperity
