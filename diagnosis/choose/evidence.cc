#include "diagnosis/choose/evidence.h"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

using Effects = std::vector<const Effect*>;

/// Log odds against each effect that other causes look like in these data: less than as_good, so that it
/// stays a candidate beside its equals.
constexpr double not_shown = 1.5;

/// The likelihood's mean over what the laws may be off by, and what of that is likely then.
struct OverLaws {
  double log_likelihood, part_of_bound;  ///< [-]
};
OverLaws over_laws(const Candidate& candidate, double overdispersion) {
  if (candidate.costs.empty()) return {-0.5 * candidate.cost / overdispersion, 1};
  const double least = *std::min_element(candidate.costs.begin(), candidate.costs.end());
  if (!std::isfinite(least)) return {-least, 1};
  double sum = 0, squares = 0;
  for (std::size_t k = 0; k < candidate.costs.size(); ++k) {
    const double likely = std::exp(-0.5 * (candidate.costs[k] - least) / overdispersion);
    sum += likely, squares += likely * parts_of_bound[k] * parts_of_bound[k];
  }
  return {-0.5 * least / overdispersion + std::log(sum / static_cast<double>(candidate.costs.size())),
          std::sqrt(squares / sum)};
}

/// Sets that say the same of these data differ by the machine's rounding alone, which is not to decide what
/// is named first.
double beyond_rounding(double score) {
  constexpr double rounding = 1e-6;  // of a log evidence
  return std::round(score / rounding);
}

void score(Candidate& candidate, const Experiment& experiment, std::size_t admissible,
           double overdispersion) {
  const auto parameters = static_cast<double>(candidate.fit.free_parameters());
  const Effects& members = candidate.fit.explanation->effects();
  double effects = 0;
  for (const Effect* effect : members)
    if (!effect->is_another_value()) effects += effect->effects_held();
  const auto count = static_cast<double>(std::max<std::size_t>(2, candidate.fit.count));
  double prior = -0.5 * parameters * std::log(count) -
                 effects * std::log(std::max<double>(2, static_cast<double>(admissible)));
  // A number read off a part of the recording is told by the samples of that part alone.
  if (const double read_off = candidate.fit.numbers_read_off(experiment); read_off > 0)
    prior -= 0.5 * read_off * std::log(std::max(2.0, count / read_off));
  for (const Effect* effect : members)
    if (!effect->not_recorded(experiment).empty()) prior -= not_shown;
  candidate.score_as_stated = prior - 0.5 * candidate.cost / overdispersion;
  const OverLaws likely = over_laws(candidate, overdispersion);
  candidate.score = prior + likely.log_likelihood;
  candidate.fit.part_of_bound = likely.part_of_bound;
}

/// Fits on the surface that is likely as long as its cost falls: what surfaces change is linear about the
/// factors of the last fit only, and the zero is not linear at all.
void settle_on_surface(Candidate& candidate, const FitProblem& problem, const LawErrors& laws,
                       const ModelFit& baseline) {
  constexpr int most_rounds = 4, steps = 3;
  constexpr double little = 0.5;  // of -2 log likelihood
  for (int round = 0; round < most_rounds; ++round) {
    Candidate next = candidate;
    next.fit = refitted(problem, candidate.fit, problem.samples, false, steps);
    cost_explanation(next, problem, laws, baseline);
    const double gain = candidate.least_cost() - next.least_cost();
    if (gain > 0) candidate = std::move(next);
    if (!(gain > little)) break;
  }
}

/// Sets that may win, or come near, once they are settled.
void settle_near_best(SearchResult& result, const FitProblem& problem, const LawErrors& laws) {
  constexpr double near = 25;
  constexpr std::size_t most = 12;
  if (!problem.correction || problem.correction->surface_errors().empty() || result.candidates.empty())
    return;
  const double least = std::max(result.alone.score, result.candidates.front().score) - near;
  settle_on_surface(result.alone, problem, laws, result.alone.fit);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t i = 0; i < std::min(most, result.candidates.size()); ++i)
    if (result.candidates[i].score > least)
      settle_on_surface(result.candidates[i], problem, laws, result.alone.fit);
  score_all(result, problem);
}

}  // namespace

void score_all(SearchResult& result, const FitProblem& problem) {
  const Experiment& experiment = problem.experiment;
  // Of what is left, not of the room that a mesh or the bounds of laws have.
  const auto misfit = [&](const Candidate& of) {
    if (has_shared_error(problem)) return of.left(problem);
    return of.least_cost();
  };
  double least = misfit(result.alone);
  for (const auto& candidate : result.candidates) least = std::min(least, misfit(candidate));
  result.overdispersion =
      std::max(1.0, least / static_cast<double>(std::max<std::size_t>(1, result.alone.fit.count)));
  score(result.alone, experiment, result.admissible, result.overdispersion);
  for (auto& candidate : result.candidates) {
    score(candidate, experiment, result.admissible, result.overdispersion);
    candidate.where_mended = nullptr;
  }
  std::stable_sort(result.candidates.begin(), result.candidates.end(), [](const auto& a, const auto& b) {
    return beyond_rounding(a.score) > beyond_rounding(b.score);
  });
}

void cost_explanation(Candidate& candidate, const FitProblem& problem, const LawErrors& laws,
                      const ModelFit& baseline) {
  const Misfit misfit = misfit_of(problem, candidate.fit, baseline);
  const LawErrors::Cost cost = laws.cost(problem.samples, problem.noise, misfit.residual, misfit.errors);
  candidate.cost = cost.sum();
  candidate.room = cost.log_determinant;
  candidate.costs.clear();
  if (misfit.errors.of_laws.empty() && misfit.errors.of_curves.empty()) return;
  for (const double part : parts_of_bound)
    candidate.costs.push_back(part == 1 ? candidate.cost
                                        : laws.cost(problem.samples, problem.noise, misfit.residual,
                                                    laws_off_by(part, misfit.errors))
                                              .sum());
}

void rescore(SearchResult& result, const FitProblem& problem) {
  const LawErrors laws(problem.samples);
  result.alone.fit = refitted(problem, result.alone.fit, problem.samples, false, 0);
  result.alone.cost = result.alone.fit.cost;
  if (problem.correction) cost_explanation(result.alone, problem, laws, result.alone.fit);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t i = 0; i < result.candidates.size(); ++i) {
    Candidate& candidate = result.candidates[i];
    candidate.fit = refitted(problem, candidate.fit, problem.samples, false, 0);
    cost_explanation(candidate, problem, laws, result.alone.fit);
  }
  score_all(result, problem);
  settle_near_best(result, problem, laws);
}

}  // namespace asperity
