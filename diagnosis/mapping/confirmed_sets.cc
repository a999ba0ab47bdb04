// Which sets are solved by finite elements, and what the solutions say of them.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/printed.h"
#include "core/quantity.h"
#include "diagnosis/choose/evidence.h"
#include "diagnosis/choose/judged_sets.h"
#include "diagnosis/choose/law_error.h"
#include "diagnosis/choose/members.h"
#include "diagnosis/mapping/effects_in_case.h"
#include "diagnosis/mapping/judged_part.h"
#include "diagnosis/mapping/law_of_contact.h"
#include "diagnosis/mapping/recorded_contact.h"
#include "diagnosis/mapping/solved_case_mapping.h"

namespace asperity {
namespace {

using Effects = std::vector<const Effect*>;

/// Most solutions for one set (a second one checks the first, except of motions, which take minutes, and
/// where the fit to the first leaves what the case does as it was solved); root mean square distance to what
/// was expected, in units of noise and mesh.
constexpr int most_solves = 4, steps_of_refit = 6;
constexpr double near_enough = 0.2, too_far = 1;
/// Log evidence by which other values fit better than those that were solved: no more than noise makes of two
/// parameters.
constexpr double little_to_gain = 1;
/// Log evidence by which another must be better for a set that was solved in part to be excluded.
constexpr double excluded_by_part = 4 * as_good;
/// The same of a solution in progress, from which it begins again with values that its first loads ask for.
constexpr double surprising = 3;
/// What tells of a set whose solution failed, and of one that took too long.
const char* const to_be_solved = "a case that can be solved with what the remarks name";
const char* const in_more_time = "a longer --minutes, in which it is solved to its end";
const char* const not_as_expected = "its first loads were not what was expected and ask for other values";

/// Root mean square of a difference in units of noise and mesh error, over the samples of `part` that count.
double distance(const FitProblem& problem, const Samples& part, const ModelFit& fit,
                const std::vector<double>& expected) {
  const auto solved = fit.simulate(problem.samples);
  const LawError mesh = together(mesh_errors(fit, problem.samples), solved.size());
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < solved.size(); ++i)
    if (part.list[i].counts) {
      sum += std::pow((solved[i] - expected[i]) / std::hypot(problem.noise.sd[i], mesh[i]), 2);
      ++count;
    }
  return std::sqrt(sum / std::max(1.0, count));
}

/// The fit with another's values of these effects and, where `of_simulation`, of the simulation's own
/// parameters.
ModelFit with_values(ModelFit fit, const ModelFit& other, const Effects& of_effects, bool of_simulation) {
  const auto& parameters = fit.explanation->parameters();
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const int e = parameters[k].effect;
    const Effect* owner = e < 0 ? nullptr : fit.explanation->effects()[static_cast<std::size_t>(e)];
    const bool is_meant =
        owner ? std::find(of_effects.begin(), of_effects.end(), owner) != of_effects.end() : of_simulation;
    const double* value = is_meant ? other.value_of(parameters[k].name, owner) : nullptr;
    if (value) fit.values[k] = *value;
  }
  return fit;
}

/// By how much what the case does has moved since it was solved, as distance() says [-].
double moved_since(const ModelFit& solved_at, const ModelFit& fit, const FitProblem& problem,
                   const Samples& part) {
  const Effects solved = in_case(fit.explanation->effects(), problem.experiment);
  return distance(problem, part, with_values(fit, solved_at, solved, false), fit.simulate(problem.samples));
}

/// Displacement of the contact, without instruments, under a force on loading [m].
double loaded_displacement(const FitProblem& problem, const ModelFit& fit, double force) {
  Samples samples;
  samples.list.resize(1);
  samples.list.front().normal_force = force;
  SampleRun run;
  run.end = 1;
  run.response_is_displacement = true;
  samples.runs.push_back(run);
  Mechanics m = reduced_law(problem, fit);
  m.normal.correction = problem.correction;
  return simulate(m, samples).front();
}

}  // namespace

SolvedCaseMapping::Trial SolvedCaseMapping::trial_of(const FitProblem& problem, const ModelFit& fit,
                                                     double largest_force) {
  Trial trial;
  trial.effects = fit.explanation->effects();
  trial.changes = changes_of(problem.experiment, fit);
  const auto values = fit.values_of_effects();
  for (std::size_t e = 0; e < trial.effects.size(); ++e) {
    const double opening = trial.effects[e]->opening_distance(problem.experiment, values[e]);
    const bool returns = trial.effects[e]->returns_on_another_curve();
    trial.opening = std::max(trial.opening, opening);
    trial.returns_on_another_curve = trial.returns_on_another_curve || returns;
    trial.yields = trial.yields || (returns && opening == 0);
  }
  for (const auto& of_case : fit.explanation->as_in_case()) {
    const double opening = of_case.effect->opening_distance(problem.experiment, of_case.values.data());
    if (!(opening > 0)) continue;
    trial.opening = std::max(trial.opening, opening);
    trial.returns_on_another_curve =
        trial.returns_on_another_curve || of_case.effect->returns_on_another_curve();
  }
  constexpr double a_little_further = 1.03;
  if (trial.opening > 0) trial.approach = a_little_further * loaded_displacement(problem, fit, largest_force);
  return trial;
}

std::string SolvedCaseMapping::enough_of(const SolvedResponse& so_far, const Watch& watch) const {
  const FitProblem& problem = watch.problem;
  const double far = far_beyond_recorded(problem), largest = so_far.force[so_far.peak];
  for (const double approach : so_far.displacement)
    if (approach > far)
      return "an approach of " + format_quantity(approach, Dimension::length) +
             " is far beyond what was recorded";
  // Attraction jumps, the way back is a part of the whole, and few loads show little.
  constexpr std::size_t least_steps = 4;
  constexpr double least_part = 0.2;
  if (watch.trial.opening > 0 || so_far.peak + 1 < so_far.force.size() || so_far.force.size() < least_steps ||
      largest < least_part * protocols_.list.front().largest_force)
    return "";
  const std::vector<SolvedResponse> solved(protocols_.list.size(), so_far);
  const Samples part = solved_part(problem.samples, protocols_, solved);
  ModelFit fit = watch.fit;
  fit.explanation = fit.explanation->with(
      difference_to(solved, protocols_, reduced_law(problem, fit), error_, surface_errors_));
  fit.is_confirmed = true;
  if (watch.may_begin_again && distance(problem, part, fit, watch.expected) > surprising)
    return not_as_expected;
  fit = refitted(problem, fit, part, false, steps_of_refit);
  const double worse = worse_on_part(problem, part, fit, best_measurement_, overdispersion_);
  if (worse < 2 * excluded_by_part) return "";
  return "its first loads are worse than " + best_measurement_.explanation->name() +
         printed(" by %.0f in log evidence", worse);
}

SolvedCaseMapping::Confirmation SolvedCaseMapping::reached(const FitProblem& problem,
                                                           const std::vector<SolvedResponse>& solved) const {
  Confirmation answer{Confirmation::complete, problem.samples, {}};
  for (const SolvedResponse& response : solved) {
    if (response.ended_early.empty()) continue;
    answer.state = Confirmation::partial;
    answer.part = solved_part(problem.samples, protocols_, solved);
    answer.is_out_of_time = answer.is_out_of_time || response.is_out_of_time;
    answer.may_begin_again = response.ended_early == not_as_expected;
    const double reach = reach_of(response).force, largest = protocols_.list.front().largest_force;
    answer.in_words = (reach < largest ? "solved up to " + format_quantity(reach, Dimension::force) + " of " +
                                             format_quantity(largest, Dimension::force) + " only ("
                                       : "solved to the largest force and not all the way back (") +
                      response.ended_early + ")";
  }
  return answer;
}

SolvedCaseMapping::SolvedSet SolvedCaseMapping::solved_set(const FitProblem& problem, const ModelFit& fit,
                                                           const std::vector<double>& expected,
                                                           bool may_begin_again) {
  const Mechanics reduced = reduced_law_as_solved(problem, fit);
  if (is_lateral_) {
    const auto moved = move(problem.experiment, &fit);
    return {resistance_difference_to(moved, reduced),
            {Confirmation::complete, problem.samples, {}},
            moved.front().source};
  }
  const Trial trial = trial_of(problem, fit, protocols_.list.front().largest_force);
  const Watch watch{problem, trial, fit, expected, may_begin_again};
  const auto solved =
      solve(problem, trial, [&](const SolvedResponse& so_far) { return enough_of(so_far, watch); });
  return {correction_by(solved, trial, reduced), reached(problem, solved), solved.front().source};
}

bool SolvedCaseMapping::is_served_by(const ConfirmedSet& other, ModelFit& fit,
                                     const FitProblem& problem) const {
  fit.explanation = fit.explanation->with(other.fit.explanation->correction());
  fit.is_confirmed = true;
  fit.surface = other.fit.surface;
  const auto from = [&](const ModelFit& start) {
    return refitted(problem, start, problem.samples, false, steps_of_refit);
  };
  const ModelFit from_other = from(with_values(fit, other.fit, other.fit.explanation->effects(), true));
  fit = from(fit);
  if (from_other.cost < fit.cost) fit = from_other;
  return moved_since(other.solved_at, fit, problem, problem.samples) < too_far;
}

SolvedCaseMapping::Confirmation SolvedCaseMapping::confirm_set(Candidate& candidate,
                                                               const FitProblem& problem) {
  ModelFit& fit = candidate.fit;
  const std::string name = fit.explanation->name();
  for (const ConfirmedSet& other : confirmed_)
    if (have_same_entries(other.fit.explanation->effects(), fit.explanation->effects(), problem.experiment) &&
        is_served_by(other, fit, problem)) {
      after_.push_back({name, other.source});
      return {Confirmation::complete, problem.samples, {}};
    }
  std::string source;
  double apart = 0;
  bool is_settled = false;
  Confirmation answer;
  ModelFit solved_at;
  for (int i = 0; i < most_solves; ++i) {
    const auto expected = fit.simulate(problem.samples);
    try {
      SolvedSet solved = solved_set(problem, fit, expected, i + 2 < most_solves);
      fit.explanation = fit.explanation->with(solved.correction);
      answer = std::move(solved.answer);
      source = solved.source;
    } catch (const InputError& error) {
      remarks_.push_back(name + " was not tried: " + error.what());
      return {Confirmation::failed, {}, {}};
    } catch (const OutOfTime& error) {
      remarks_.push_back(name + " was not solved: " + error.what());
      return {Confirmation::failed, {}, {}, true};
    } catch (const WorkError& error) {
      remarks_.push_back(name + " could not be solved: " + error.what());
      return {Confirmation::failed, {}, {}};
    }
    fit.is_confirmed = true;
    apart = distance(problem, answer.part, fit, expected);
    solved_at = fit;
    fit = refitted(problem, fit, answer.part, false, steps_of_refit);
    const bool stays = moved_since(solved_at, fit, problem, answer.part) < near_enough;
    if (stays) apart = 0;
    is_settled = apart < near_enough ||
                 (apart < too_far &&
                  worse_on_part(problem, answer.part, solved_at, fit, overdispersion_) < little_to_gain);
    if (answer.is_out_of_time ||
        (i > 0 && answer.state == Confirmation::partial && !answer.may_begin_again) ||
        ((i > 0 || is_lateral_ || stays) && answer.state == Confirmation::complete && is_settled))
      break;
  }
  if (answer.state == Confirmation::partial) return answer;
  if (!is_settled)
    remarks_.push_back(name + printed(": after %d solutions the last still differs from what was expected "
                                      "of it by %.2g times noise and mesh error%s",
                                      most_solves, apart, apart >= too_far ? "; it stays open" : ""));
  if (apart >= too_far) return {Confirmation::failed, {}, {}};
  after_.push_back({name, source});
  confirmed_.push_back({fit, solved_at, source});
  return answer;
}

void SolvedCaseMapping::confirm(SearchResult& search, const FitProblem& problem,
                                const std::vector<const Candidate*>& survivors) {
  const std::vector<Candidate> wanted = worth_solutions(search, problem, survivors);
  best_measurement_ = search.alone.fit;
  overdispersion_ = search.overdispersion;
  for (auto candidate = search.candidates.rbegin(); candidate != search.candidates.rend(); ++candidate)
    if (in_case(candidate->fit.explanation->effects(), problem.experiment).empty() &&
        candidate->score > search.alone.score)
      best_measurement_ = candidate->fit;
  std::vector<Candidate> kept;
  std::vector<std::pair<Candidate, Confirmation>> unsolved;
  for (const Candidate& candidate : search.candidates)
    if (in_case(candidate.fit.explanation->effects(), problem.experiment).empty()) kept.push_back(candidate);
  for (Candidate candidate : wanted) {
    Confirmation answer = confirm_set(candidate, problem);
    if (answer.state == Confirmation::complete) kept.push_back(candidate);
    if (answer.state != Confirmation::complete) unsolved.emplace_back(candidate, std::move(answer));
  }
  search.candidates = std::move(kept);
  rescore(search, problem);
  for (const auto& [candidate, answer] : unsolved)
    if (answer.state == Confirmation::partial)
      judge_on_part(search, problem, candidate, answer);
    else
      open_.push_back(open_set(problem, search, candidate.fit, problem.samples,
                               answer.is_out_of_time ? in_more_time : to_be_solved));
}

void SolvedCaseMapping::judge_on_part(const SearchResult& search, const FitProblem& problem,
                                      const Candidate& candidate, const Confirmation& answer) {
  const ModelFit& best = search.explains() ? search.candidates.front().fit : search.alone.fit;
  OpenSet set = open_set(problem, search, candidate.fit, answer.part,
                         answer.is_out_of_time ? in_more_time : to_be_solved);
  const double worse = set.behind;
  const bool excluded = worse > excluded_by_part;
  const bool adds_little = set.holds_more_than(best) && worse > -clear_evidence;
  remarks_.push_back(
      candidate.fit.explanation->name() + " was " + answer.in_words + ": on that part " +
      best.explanation->name() +
      (excluded ? printed(" is better by %.3g in log evidence, which excludes it", worse)
       : adds_little
           ? printed(" is as good without what it adds (%.3g in log evidence)", worse)
           : printed(" is not clearly better (%.3g in log evidence), which leaves it open", worse)) +
      (!excluded && answer.is_out_of_time ? "; a longer --minutes solves it further" : ""));
  if (!excluded) open_.push_back(std::move(set));
}

}  // namespace asperity
