#include "diagnosis/mapping/solved_case_mapping.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/printed.h"
#include "core/quantity.h"
#include "diagnosis/mapping/changes_in_words.h"
#include "diagnosis/mapping/recorded_contact.h"

namespace asperity {
namespace {

using Effects = std::vector<const Effect*>;

/// Turning points that are solved, each on its own.
constexpr std::size_t most_turning_points = 6;

bool case_yields(const Experiment& experiment) {
  return std::isfinite(std::min(experiment.particle_yield, experiment.substrate_yield));
}

/// What a diagnosis says of it.
std::string name_of(EntersBy form) {
  switch (form) {
    case EntersBy::measurement:
      return "measurement";
    case EntersBy::in_series:
      return "reduced law in series with the solution";
    case EntersBy::beside:
      return "reduced law beside the solution";
    case EntersBy::on_friction:
      return "reduced law that changes the friction that was solved";
    case EntersBy::on_force:
      return "reduced law that changes the normal force that was solved";
    case EntersBy::finite_elements:
      return "entries of the case";
    case EntersBy::reduced_law_only:
      break;
  }
  return "";
}

void take(RecordedBody& recorded, const ElasticBody& of_case, const std::string& name,
          std::vector<std::string>& remarks) {
  constexpr double rounding = 1e-3;
  const auto differs = [](double a, double b) { return std::abs(a - b) > rounding * std::abs(b); };
  if (differs(recorded.youngs_modulus, of_case.youngs_modulus) ||
      differs(recorded.poissons_ratio, of_case.poisson_ratio)) {
    remarks.push_back(
        printed("the recording gives the %s E = %.4g Pa, nu = %.3g, and the case %.4g Pa, %.3g: the case is "
                "what was diagnosed",
                name.c_str(), recorded.youngs_modulus, recorded.poissons_ratio, of_case.youngs_modulus,
                of_case.poisson_ratio));
  }
  recorded.youngs_modulus = of_case.youngs_modulus;
  recorded.poissons_ratio = of_case.poisson_ratio;
}

}  // namespace

Recording SolvedCaseMapping::with_bodies_of_case(const Recording& recording) {
  if (recording.mode == Motion::rail)
    throw InputError(
        "a case has one contact on a plane, and this recording is of a rail, in which several contacts roll "
        "and spin; leave out --case to diagnose it by reduced laws");
  is_lateral_ = recording.mode != Motion::normal;
  const SimulatedBodies bodies = model_.bodies();
  if (bodies.particle_relaxation.share > 0 || bodies.substrate_relaxation.share > 0)
    prepare_relaxing(recording);
  Recording changed = recording;
  if (is_lateral_) prepare_lateral(changed, bodies);
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

void SolvedCaseMapping::prepare_relaxing(const Recording& recording) {
  const std::string relaxes = "a body of the case relaxes with time, and ";
  if (is_lateral_)
    throw InputError(relaxes + "a recording of " + name_of(recording.mode) +
                     " is not set against such a case yet; leave out Relaxing share and Relaxation time");
  for (const auto& table : recording.tables)
    if (!table.has("time"))
      throw InputError(relaxes +
                       "the recording has no column time; record it, or leave out Relaxing share "
                       "and Relaxation time");
  remarks_.push_back(
      "a body of the case relaxes with time: the case is solved as after fast loading, and relaxes around "
      "that "
      "solution in the times of the recording (hereditary integral of Lee & Radok 1960, Ting 1966)");
}

std::vector<LoadingProtocol> SolvedCaseMapping::asked_for(const FitProblem& problem,
                                                          const Trial& trial) const {
  // A contact that comes back as it went needs one solution: less load is a part of its way.
  LoadingProtocol largest;
  largest.largest_force = protocols_.list.front().largest_force;
  std::vector<LoadingProtocol> asked{largest};
  const bool yields = trial.yields || case_yields(problem.experiment);
  if (trial.opening > 0) {
    if (yields)
      throw WorkError(
          "attraction between bodies that yield is not solved for a recording yet; diagnose it without "
          "--case");
    asked.front().approach = trial.approach;
    asked.front().unloads = std::any_of(protocols_.list.begin(), protocols_.list.end(),
                                        [](const LoadingProtocol& protocol) { return protocol.unloads; });
    if (asked.front().unloads) asked.front().retract = trial.opening;
  } else if (yields) {
    asked.clear();
    for (const auto& protocol : protocols_.list)
      if (asked.empty() || protocol.unloads) asked.push_back(protocol);
    if (asked.size() > most_turning_points)
      throw WorkError(
          "the recording turns back from " + std::to_string(asked.size()) +
          " loads that differ by more than 5 %, each of them a solution of its own, and at most " +
          std::to_string(most_turning_points) + " are solved; record fewer");
  }
  return asked;
}

std::vector<SolvedResponse> SolvedCaseMapping::solve(const FitProblem& problem, const Trial& trial,
                                                     const EnoughOfIt& enough) {
  const std::vector<LoadingProtocol> asked = asked_for(problem, trial);
  say("solving the case, " + in_words(trial.changes) + ", up to " +
      format_quantity(asked.front().largest_force, Dimension::force) +
      (asked.size() > 1 ? " and " + std::to_string(asked.size() - 1) + " smaller loads" : ""));
  const std::vector<SolvedResponse> solved = model_.solve(trial.changes, asked, enough);
  solves_ += static_cast<int>(solved.size());
  std::vector<SolvedResponse> of_protocol;
  for (std::size_t p = 0, next = 1; p < protocols_.list.size(); ++p)
    of_protocol.push_back(p > 0 && asked.size() > 1 && protocols_.list[p].unloads ? solved[next++]
                                                                                  : solved.front());
  return of_protocol;
}

std::vector<SolvedResponse> SolvedCaseMapping::solved_up_to_largest_force(const FitProblem& problem,
                                                                          Trial& trial) {
  // A contact that attracts is driven by displacement, and rough surfaces approach further than the reduced
  // law says.
  constexpr int most_tries = 4;
  constexpr double further = 1.4, nearly = 0.99;
  for (int i = 1;; ++i) {
    auto solved = solve(problem, trial, nullptr);
    const SolvedResponse& response = solved.front();
    if (!(trial.opening > 0) ||
        response.force[response.peak] > nearly * protocols_.list.front().largest_force)
      return solved;
    if (i == most_tries)
      throw WorkError(
          "'" + response.source + "' reaches " +
          format_quantity(response.force[response.peak], Dimension::force) + " of the recorded " +
          format_quantity(protocols_.list.front().largest_force, Dimension::force) + " at " +
          format_quantity(response.displacement[response.peak], Dimension::length) +
          ", and is not pressed further; compare its Young modulus and Radius with the recording");
    trial.approach *= further;
  }
}

void SolvedCaseMapping::correct(FitProblem& problem) {
  const SimulatedBodies bodies = model_.bodies();
  problem.experiment.by_finite_elements = true;
  problem.experiment.case_is_smooth = bodies.is_smooth;
  problem.experiment.case_spacing = bodies.spacing;
  problem.experiment.particle_yield = bodies.particle_yield;
  problem.experiment.substrate_yield = bodies.substrate_yield;
  problem.experiment.case_friction = bodies.friction_coefficient;
  problem.experiment.case_adhesion_range = bodies.adhesion_range;
  problem.experiment.case_work_of_adhesion = bodies.work_of_adhesion;
  problem.experiment.case_work_of_separation = bodies.work_of_separation;
  problem.experiment.case_attraction_force = bodies.attraction_force;
  problem.experiment.particle_relaxation = bodies.particle_relaxation;
  problem.experiment.substrate_relaxation = bodies.substrate_relaxation;
  problem.experiment.case_rms = bodies.substrate_rms;
  if (is_lateral_) return correct_lateral(problem);
  model_.refuse_unless_normal();
  ModelFit as_it_is;
  as_it_is.explanation =
      std::make_shared<Explanation>(problem.experiment, problem.choice, std::vector<const Effect*>{});
  const Mechanics alone = as_it_is.explanation->mechanics({});
  protocols_ = protocols_of(problem.samples);
  if (bodies.unload_steps > 0)
    problem.samples.snap_width = 0.5 * recorded_in_contact(problem, Pressed::or_pulled) / bodies.unload_steps;
  Trial trial = trial_of(problem, as_it_is, protocols_.list.front().largest_force);
  const auto solved = solved_up_to_largest_force(problem, trial);
  before_ = solved.front().source;
  error_ = solved.front().displacement_error;
  if (!bodies.is_smooth) solve_on_other_surfaces();
  problem.correction = correction_by(solved, trial, alone);
}

std::vector<CaseChange> SolvedCaseMapping::changes_of(const Experiment& experiment, const ModelFit& fit) {
  std::vector<CaseChange> changes;
  const auto& effects = fit.explanation->effects();
  const auto values = fit.values_of_effects();
  for (std::size_t e = 0; e < effects.size(); ++e)
    for (auto& change : effects[e]->case_changes(experiment, values[e])) changes.push_back(std::move(change));
  return changes;
}

void SolvedCaseMapping::widen_untested(const FitProblem& problem,
                                       std::vector<DiagnosedEffect>& effects) const {
  for (DiagnosedEffect& effect : effects) {
    const Effect& of = effect_of(effect.id);
    std::vector<double> values;
    for (const auto& p : effect.parameters) values.push_back(p.value);
    if (values.empty() || !(of.opening_distance(problem.experiment, values.data()) > 0)) continue;
    for (const EffectParameter& admissible : of.parameters(problem.experiment))
      for (DiagnosedParameter& p : effect.parameters)
        if (p.name == admissible.name && p.unit.empty()) {
          p.low = admissible.low;
          p.high = admissible.high;
        }
  }
}

void SolvedCaseMapping::remark_on_values_as_solved(const ModelFit& fit) {
  constexpr double rounding = 1e-3;
  const Experiment& experiment = fit.explanation->experiment();
  const auto values = fit.values_of_effects();
  for (std::size_t e = 0; e < values.size(); ++e) {
    const Effect& effect = *fit.explanation->effects()[e];
    const auto as_solved = effect.values_as_solved(experiment, values[e]);
    const auto parameters = effect.parameters(experiment);
    for (std::size_t k = 0; k < as_solved.size(); ++k)
      if (std::abs(as_solved[k] - values[e][k]) > rounding * std::abs(values[e][k]))
        remarks_.push_back(effect.id() +
                           printed(" fits with %s = %.3g and was solved with %.3g, the nearest that the mesh "
                                   "resolves: its law says the difference, which corrected.prm has not",
                                   parameters[k].name.c_str(), values[e][k], as_solved[k]));
  }
}

SolvedSimulation SolvedCaseMapping::described(const ModelFit* chosen) {
  SolvedSimulation s;
  s.by_finite_elements = true;
  s.before = before_;
  s.solves = solves_;
  s.error = error_;
  if (is_lateral_) s.error_of = resistance_;
  if (!chosen) return s;
  remark_on_values_as_solved(*chosen);
  for (const auto& solution : after_)
    if (solution.effects == chosen->explanation->name()) s.after = solution.source;
  return s;
}

void SolvedCaseMapping::add_case_entries(const FitProblem& problem,
                                         std::vector<DiagnosedEffect>& effects) const {
  for (DiagnosedEffect& effect : effects) {
    const Effect& of = effect_of(effect.id);
    effect.case_entries = of.corrected_entries(problem.experiment, effect.parameters);
    effect.form = name_of(of.enters_by(problem.experiment));
  }
}

std::vector<UntriedEffect> SolvedCaseMapping::effects_without_form(const Experiment& experiment) const {
  std::vector<UntriedEffect> list;
  for (const auto& effect : effect_catalogue()) {
    const std::string why = effect->is_shown_by(experiment) ? why_without_form(*effect, experiment) : "";
    if (!why.empty()) list.push_back({effect->id(), why});
  }
  return list;
}

}  // namespace asperity
