#include "diagnosis/fit/explanation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnosis/fit/model_fit.h"

namespace asperity {
namespace {

constexpr double smallest_friction = 1e-7, largest_friction = 20;

/// Parameters of the simulation that the mode of motion makes use of.
std::vector<std::string> used_in(Motion mode, const SimulationChoice& choice) {
  switch (mode) {
    case Motion::normal:
      return {};
    case Motion::sliding:
      return {"sliding_friction"};
    case Motion::rolling:
      return {"rolling_friction"};
    case Motion::rail:
      if (choice.torsion == "constant") return {"rolling_friction", "torsion_friction"};
      return {"rolling_friction"};
    case Motion::torsion:
      return {"torsion_friction"};
    case Motion::program:
      break;
  }
  return {};
}

/// Of several such the set's replaces the case's.
bool attracts(const Effect& effect) { return effect.description().takes("attraction"); }

}  // namespace

double FreeParameter::coordinate(double value) const {
  return logarithmic ? std::log(std::max(value, 1e-300)) : value / scale;
}
double FreeParameter::value(double coordinate) const {
  return logarithmic ? std::exp(coordinate) : coordinate * scale;
}

bool FreeParameter::is_stopped_at(double value) const {
  if (bounds_are_meant) return false;
  constexpr double at_bound = 1e-3;  // of the range
  const double from = coordinate(low), to = coordinate(high), at = coordinate(value);
  const bool low_is_none = !logarithmic && low >= 0;  // an effect that vanishes
  return to - at < at_bound * (to - from) || (!low_is_none && at - from < at_bound * (to - from));
}

SimulationChoice completed(const SimulationChoice& given, const Experiment& experiment) {
  SimulationChoice choice = given;
  const double guess =
      experiment.largest_force > 0 ? experiment.largest_response / experiment.largest_force : 0.1;
  for (const auto& name : used_in(experiment.mode, choice))
    if (!choice.parameters.count(name)) choice.parameters[name] = {guess, true};
  return choice;
}

Explanation::Explanation(const Experiment& experiment, const SimulationChoice& choice,
                         std::vector<const Effect*> effects,
                         std::shared_ptr<const BranchCorrection> correction)
    : experiment_(experiment),
      choice_(choice),
      effects_(std::move(effects)),
      correction_(std::move(correction)) {
  std::stable_sort(effects_.begin(), effects_.end(), [](const Effect* a, const Effect* b) {
    return a->description().order != b->description().order ? a->description().order < b->description().order
                                                            : a->id() < b->id();
  });
  for (const auto& effect : effect_catalogue())
    if (experiment.by_finite_elements && !effect->values_in_case(experiment).empty() &&
        std::find(effects_.begin(), effects_.end(), effect.get()) == effects_.end() &&
        !(attracts(*effect) && std::any_of(effects_.begin(), effects_.end(),
                                           [](const Effect* other) { return attracts(*other); })))
      as_in_case_.push_back({effect.get(), effect->values_in_case(experiment)});
  std::stable_sort(as_in_case_.begin(), as_in_case_.end(), [](const AsInCase& a, const AsInCase& b) {
    return a.effect->description().order < b.effect->description().order;
  });
  std::vector<std::string> replaced;
  for (const Effect* effect : effects_)
    for (const auto& name : effect->description().replaces) replaced.push_back(name);
  for (const auto& name : used_in(experiment.mode, choice_)) {
    const SimulationParameter& parameter = choice_.parameters.at(name);
    // In a rail, the rolling coefficient replaced by another law leaves that of torsion where it is.
    if (!parameter.calibrate || std::find(replaced.begin(), replaced.end(), name) != replaced.end()) continue;
    const double guess = parameter.value > 0 ? parameter.value : 0.1;
    parameters_.push_back({name, "", -1, smallest_friction, largest_friction, true, 1, {guess}});
  }
  for (std::size_t e = 0; e < effects_.size(); ++e)
    for (const auto& p : effects_[e]->parameters(experiment)) {
      FreeParameter free{p.name, p.unit,   static_cast<int>(e), p.low,       p.high,  p.logarithmic,
                         1,      p.starts, p.bounds_are_meant,  p.no_effect, p.absent};
      free.off_by = p.off_by;
      if (!p.logarithmic) {
        free.scale = 0;
        for (const double start : p.starts) free.scale = std::max(free.scale, std::abs(start));
        if (free.scale == 0) free.scale = std::max(std::abs(p.low), std::abs(p.high));
      }
      parameters_.push_back(free);
    }
}

Mechanics Explanation::mechanics(const std::vector<double>& values) const {
  SimulationChoice choice = choice_;
  std::size_t next = 0;
  for (; next < parameters_.size() && parameters_[next].effect < 0; ++next)
    choice.parameters[parameters_[next].name].value = values[next];
  Mechanics m = baseline_mechanics(experiment_, choice);
  std::size_t of_case = 0;
  const auto assemble_case_up_to = [&](int order) {
    for (; of_case < as_in_case_.size() && as_in_case_[of_case].effect->description().order <= order;
         ++of_case) {
      // On another radius the same work of adhesion is another pull-off force.
      Experiment on_radius = experiment_;
      on_radius.radius = m.geometry.radius;
      const auto values = on_radius.radius == experiment_.radius
                              ? as_in_case_[of_case].values
                              : as_in_case_[of_case].effect->values_in_case(on_radius);
      as_in_case_[of_case].effect->assemble(m, values.data());
    }
  };
  for (std::size_t e = 0; e < effects_.size(); ++e) {
    assemble_case_up_to(effects_[e]->description().order - 1);
    effects_[e]->assemble(m, values.data() + next);
    while (next < parameters_.size() && parameters_[next].effect == static_cast<int>(e)) ++next;
  }
  assemble_case_up_to(std::numeric_limits<int>::max());
  m.normal.correction = m.lateral.correction = correction_;
  return m;
}

std::shared_ptr<const Explanation> Explanation::with(
    std::shared_ptr<const BranchCorrection> correction) const {
  auto other = std::make_shared<Explanation>(*this);
  other->correction_ = std::move(correction);
  return other;
}

std::shared_ptr<const Explanation> Explanation::without_relaxation_of_case() const {
  auto other = std::make_shared<Explanation>(*this);
  auto& list = other->as_in_case_;
  list.erase(std::remove_if(list.begin(), list.end(),
                            [&](const AsInCase& of_case) {
                              return of_case.effect->enters_by(experiment_) == EntersBy::on_force;
                            }),
             list.end());
  return list.size() < as_in_case_.size() ? other : nullptr;
}

bool Explanation::is_smooth() const {
  return std::all_of(effects_.begin(), effects_.end(),
                     [](const Effect* effect) { return effect->description().is_smooth; });
}

std::string Explanation::name() const {
  std::string text;
  for (const Effect* effect : effects_) text += (text.empty() ? "" : " + ") + effect->id();
  return text.empty() ? "the simulation alone" : text;
}

bool Explanation::compatible(const std::vector<const Effect*>& effects) {
  std::vector<std::string> taken;
  for (const Effect* effect : effects)
    for (const auto& slot : effect->description().slots) {
      if (std::find(taken.begin(), taken.end(), slot) != taken.end()) return false;
      taken.push_back(slot);
    }
  return true;
}

ModelFit ModelFit::only(const FitProblem& problem, const std::vector<const Effect*>& effects,
                        const ModelFit& baseline) const {
  ModelFit fewer;
  fewer.explanation =
      std::make_shared<Explanation>(problem.experiment, problem.choice, effects, explanation->correction());
  fewer.is_confirmed = is_confirmed;
  for (const FreeParameter& p : fewer.explanation->parameters()) {
    const Effect* owner =
        p.effect < 0 ? nullptr : fewer.explanation->effects()[static_cast<std::size_t>(p.effect)];
    const double* value = value_of(p.name, owner);
    fewer.values.push_back(value ? *value : *baseline.value_of(p.name, owner));
    fewer.held.push_back(value && is_held(static_cast<std::size_t>(value - values.data())));
  }
  return fewer;
}

const double* ModelFit::value_of(const std::string& name, const Effect* owner) const {
  const auto& parameters = explanation->parameters();
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const Effect* own = parameters[k].effect < 0
                            ? nullptr
                            : explanation->effects()[static_cast<std::size_t>(parameters[k].effect)];
    if (own == owner && parameters[k].name == name) return &values[k];
  }
  return nullptr;
}

std::vector<const double*> ModelFit::values_of_effects() const {
  std::vector<const double*> list;
  std::size_t next = 0;
  const auto& parameters = explanation->parameters();
  while (next < parameters.size() && parameters[next].effect < 0) ++next;
  for (std::size_t e = 0; e < explanation->effects().size(); ++e) {
    list.push_back(values.data() + next);
    while (next < parameters.size() && parameters[next].effect == static_cast<int>(e)) ++next;
  }
  return list;
}

bool ModelFit::is_itself() const {
  const auto at = values_of_effects();
  for (std::size_t e = 0; e < at.size(); ++e)
    if (!explanation->effects()[e]->is_itself(explanation->experiment(), at[e])) return false;
  return true;
}

std::vector<ModelFit> ModelFit::in_simpler_form(const FitProblem& problem) const {
  const auto at = values_of_effects();
  std::vector<ModelFit> fits;
  for (std::size_t e = 0; e < at.size(); ++e) {
    std::vector<const Effect*> effects = explanation->effects();
    if (effects[e]->is_itself(problem.experiment, at[e])) continue;
    const SimplerForm form = effects[e]->simpler_form(problem.experiment, at[e]);
    if (form.effect.empty()) continue;
    const Effect* simpler = &effect_of(form.effect);
    if (std::find(effects.begin(), effects.end(), simpler) != effects.end()) continue;
    effects[e] = simpler;
    std::sort(effects.begin(), effects.end());  // as the search orders its sets
    if (!Explanation::compatible(effects)) continue;
    const auto simple =
        std::make_shared<Explanation>(problem.experiment, problem.choice, effects, explanation->correction());
    for (const EffectStart& start : form.starts) {
      ModelFit fit;
      fit.explanation = simple;
      std::size_t next = 0;
      for (const FreeParameter& p : simple->parameters()) {
        const Effect* owner = p.effect < 0 ? nullptr : simple->effects()[static_cast<std::size_t>(p.effect)];
        const double* known = owner == simpler ? &start[next++] : value_of(p.name, owner);
        fit.values.push_back(std::clamp(known ? *known : p.starts.front(), p.low, p.high));
        fit.held.push_back(known && owner != simpler &&
                           is_held(static_cast<std::size_t>(known - values.data())));
      }
      fits.push_back(fit);
    }
  }
  return fits;
}

double ModelFit::numbers_read_off(const Experiment& experiment) const {
  const auto at = values_of_effects();
  double sum = 0;
  for (std::size_t e = 0; e < at.size(); ++e)
    sum += explanation->effects()[e]->numbers_read_off(experiment, at[e]);
  return sum;
}

std::string ModelFit::stopped_at() const {
  const auto& parameters = explanation->parameters();
  for (std::size_t k = 0; k < parameters.size(); ++k)
    if (parameters[k].is_stopped_at(values[k])) return parameters[k].name;
  return "";
}

}  // namespace asperity
