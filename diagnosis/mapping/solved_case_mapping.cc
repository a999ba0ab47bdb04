#include "diagnosis/mapping/solved_case_mapping.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "core/error.h"
#include "core/quantity.h"
#include "diagnosis/choose/law_error.h"

namespace asperity {
namespace {

using Effects = std::vector<const Effect*>;

/// Most solutions for one set; and how near solution and expectation must be, in units of noise and mesh
/// error, root mean square.
constexpr int most_solves = 4;
constexpr double near_enough = 0.2;
/// Log evidence over the simulation alone from which a single effect is worth solutions of its own.
constexpr double worth_solving = 8;
constexpr std::size_t most_survivors = 3;

Effects in_case(const Effects& effects, const Experiment& experiment) {
  Effects found;
  for (const Effect* effect : effects)
    if (effect->enters_by(experiment) == EntersBy::finite_elements) found.push_back(effect);
  return found;
}

/// Entries of the case for the values of a fit.
std::vector<CaseChange> changes_of(const FitProblem& problem, const ModelFit& fit) {
  std::vector<CaseChange> changes;
  const auto& parameters = fit.explanation->parameters();
  const auto& effects = fit.explanation->effects();
  for (std::size_t e = 0; e < effects.size(); ++e) {
    std::size_t first = 0;
    while (first < parameters.size() && parameters[first].effect != static_cast<int>(e)) ++first;
    for (auto& change : effects[e]->case_changes(problem.experiment, fit.values.data() + first))
      changes.push_back(std::move(change));
  }
  return changes;
}

/// The reduced law of the contact, without what measures it and without a correction.
Mechanics reduced_law(const FitProblem& problem, const ModelFit& fit) {
  const ModelFit contact = fit.only(problem, in_case(fit.explanation->effects(), problem.experiment), fit);
  Mechanics m = contact.explanation->mechanics(contact.values);
  m.normal.correction = nullptr;
  return m;
}

/// Root mean square of a difference in units of noise and mesh error.
double distance(const FitProblem& problem, const ModelFit& fit, const std::vector<double>& expected) {
  const auto solved = fit.simulate(problem.samples);
  const LawError mesh = mesh_error(fit, problem.samples, solved);
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < solved.size(); ++i)
    if (problem.samples.list[i].counts) {
      sum += std::pow((solved[i] - expected[i]) / std::hypot(problem.noise.sd[i], mesh[i]), 2);
      ++count;
    }
  return std::sqrt(sum / std::max(1.0, count));
}

std::string in_words(const std::vector<CaseChange>& changes) {
  std::string text;
  for (const auto& change : changes) {
    char number[64];
    std::snprintf(number, sizeof number, "%.4g %s", change.value, change.unit.c_str());
    text += (text.empty() ? "" : ", ") + change.entry + " = " + number;
  }
  return text.empty() ? "as it is" : text;
}

void take(RecordedBody& recorded, const ElasticBody& of_case, const std::string& name,
          std::vector<std::string>& remarks) {
  constexpr double rounding = 1e-3;
  const auto differs = [](double a, double b) { return std::abs(a - b) > rounding * std::abs(b); };
  if (differs(recorded.youngs_modulus, of_case.youngs_modulus) ||
      differs(recorded.poissons_ratio, of_case.poisson_ratio)) {
    char text[200];
    std::snprintf(
        text, sizeof text,
        "the recording gives the %s E = %.4g Pa, nu = %.3g, and the case %.4g Pa, %.3g: the case is "
        "what was diagnosed",
        name.c_str(), recorded.youngs_modulus, recorded.poissons_ratio, of_case.youngs_modulus,
        of_case.poisson_ratio);
    remarks.push_back(text);
  }
  recorded.youngs_modulus = of_case.youngs_modulus;
  recorded.poissons_ratio = of_case.poisson_ratio;
}

}  // namespace

Recording SolvedCaseMapping::with_bodies_of_case(const Recording& recording) {
  if (recording.mode != Motion::normal)
    throw InputError("--case takes recordings of normal contact so far, and this one is of " +
                     name_of(recording.mode) + "; leave out --case to diagnose it by reduced laws");
  const SimulatedBodies bodies = model_.bodies();
  Recording changed = recording;
  take(changed.particle, bodies.particle, "particle", remarks_);
  take(changed.substrate, bodies.substrate, "substrate", remarks_);
  constexpr double rounding = 1e-3;
  if (std::abs(recording.particle.radius - bodies.radius) > rounding * bodies.radius)
    remarks_.push_back("the recording gives the particle's radius as " +
                       format_quantity(recording.particle.radius, Dimension::length) + ", and the case as " +
                       format_quantity(bodies.radius, Dimension::length) +
                       ": the case is what was diagnosed");
  changed.particle.radius = bodies.radius;
  for (auto& table : changed.tables) table.columns.erase("radius");
  return changed;
}

std::vector<SolvedResponse> SolvedCaseMapping::solve(const FitProblem& problem,
                                                     const std::vector<CaseChange>& changes) {
  const bool yields = problem.experiment.particle_yields || problem.experiment.substrate_yields ||
                      std::any_of(changes.begin(), changes.end(), [](const CaseChange& change) {
                        return change.entry.find("Yield stress") != std::string::npos;
                      });
  // An elastic contact comes back as it went, and less load is a part of its way.
  std::vector<LoadingProtocol> asked = protocols_.list;
  if (!yields) asked = {{protocols_.list.front().largest_force, false}};
  say("solving the case, " + in_words(changes) + ", up to " +
      format_quantity(asked.front().largest_force, Dimension::force) +
      (asked.size() > 1 ? " and " + std::to_string(asked.size() - 1) + " smaller loads" : ""));
  std::vector<SolvedResponse> solved = model_.solve(changes, asked);
  solves_ += static_cast<int>(solved.size());
  while (solved.size() < protocols_.list.size()) solved.push_back(solved.front());
  return solved;
}

void SolvedCaseMapping::correct(FitProblem& problem) {
  const SimulatedBodies bodies = model_.bodies();
  problem.experiment.by_finite_elements = true;
  problem.experiment.particle_yields = bodies.particle_yields;
  problem.experiment.substrate_yields = bodies.substrate_yields;
  protocols_ = protocols_of(problem.samples);
  const auto solved = solve(problem, {});
  before_ = solved.front().source;
  displacement_error_ = solved.front().displacement_error;
  problem.correction = difference_to(solved, protocols_,
                                     baseline_mechanics(problem.experiment, problem.choice), problem.samples);
}

bool SolvedCaseMapping::confirm_set(Candidate& candidate, const FitProblem& problem) {
  constexpr int steps = 6;
  ModelFit& fit = candidate.fit;
  std::string source;
  double apart = 0;
  for (int i = 0; i < most_solves; ++i) {
    std::vector<SolvedResponse> solved;
    try {
      solved = solve(problem, changes_of(problem, fit));
    } catch (const InputError& error) {
      remarks_.push_back(fit.explanation->name() + " was not tried: " + error.what());
      return false;
    } catch (const WorkError& error) {
      remarks_.push_back(fit.explanation->name() + " could not be solved: " + error.what());
      return false;
    }
    const auto expected = fit.simulate(problem.samples);
    source = solved.front().source;
    fit.explanation =
        fit.explanation->with(difference_to(solved, protocols_, reduced_law(problem, fit), problem.samples));
    fit.is_confirmed = true;
    apart = distance(problem, fit, expected);
    fit = refitted(problem, fit, problem.samples, false, steps);
    if (i > 0 && apart < near_enough) break;
  }
  if (apart >= near_enough) {
    char text[240];
    std::snprintf(text, sizeof text,
                  "%s: after %d solutions the last still differs from what was expected of it by %.2g times "
                  "noise and mesh error",
                  fit.explanation->name().c_str(), most_solves, apart);
    remarks_.push_back(text);
  }
  after_.push_back({fit.explanation->name(), source});
  return true;
}

void SolvedCaseMapping::confirm(SearchResult& search, const FitProblem& problem,
                                const std::vector<const Candidate*>& survivors) {
  std::set<std::set<const Effect*>> wanted;
  const auto want = [&](const Effects& effects) {
    if (!in_case(effects, problem.experiment).empty()) wanted.insert({effects.begin(), effects.end()});
  };
  // What survived, with one member less too: a member must earn its place.
  for (std::size_t i = 0; i < std::min(most_survivors, survivors.size()); ++i) {
    const Effects& effects = survivors[i]->fit.explanation->effects();
    want(effects);
    for (const Effect* left_out : effects) {
      Effects fewer = effects;
      fewer.erase(std::find(fewer.begin(), fewer.end(), left_out));
      want(fewer);
    }
  }
  for (const auto& candidate : search.candidates)
    if (candidate.fit.explanation->effects().size() == 1 &&
        candidate.score > search.alone.score + worth_solving)
      want(candidate.fit.explanation->effects());
  std::vector<Candidate> kept;
  for (auto& candidate : search.candidates) {
    const Effects& effects = candidate.fit.explanation->effects();
    if (!in_case(effects, problem.experiment).empty()) {
      if (!wanted.count({effects.begin(), effects.end()})) continue;
      if (!confirm_set(candidate, problem)) {
        is_incomplete_ = true;
        continue;
      }
    }
    kept.push_back(candidate);
  }
  search.candidates = std::move(kept);
  rescore(search, problem);
}

SolvedSimulation SolvedCaseMapping::described(const FitProblem& problem, const ModelFit* chosen,
                                              const std::vector<DiagnosedEffect>& effects) const {
  SolvedSimulation s;
  s.by_finite_elements = true;
  s.before = before_;
  s.solves = solves_;
  s.displacement_error = displacement_error_;
  if (!chosen) return s;
  for (const auto& solution : after_)
    if (solution.effects == chosen->explanation->name()) s.after = solution.source;
  for (const DiagnosedEffect& effect : effects) {
    std::vector<double> value, low, high;
    for (const auto& p : effect.parameters) {
      value.push_back(p.value);
      low.push_back(p.low);
      high.push_back(p.high);
    }
    const auto changes = [&](const std::vector<double>& at) {
      return effect_of(effect.id).case_changes(problem.experiment, at.data());
    };
    const auto now = changes(value), from = changes(low), to = changes(high);
    for (std::size_t k = 0; k < now.size(); ++k)
      s.corrected.push_back({now[k].entry, now[k].unit, now[k].value, std::min(from[k].value, to[k].value),
                             std::max(from[k].value, to[k].value)});
  }
  return s;
}

std::vector<std::string> SolvedCaseMapping::remarks_on_effects_without_form(
    const Experiment& experiment) const {
  std::vector<std::string> list;
  for (const auto& effect : effect_catalogue())
    if (effect->is_shown_by(experiment) && effect->enters_by(experiment) == EntersBy::reduced_law_only)
      list.push_back(effect->id() + " was not tried: " + effect->why_not_by_finite_elements(experiment));
  return list;
}

}  // namespace asperity
