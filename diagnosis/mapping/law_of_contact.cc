#include "diagnosis/mapping/law_of_contact.h"

#include "diagnosis/mapping/effects_in_case.h"

namespace asperity {
namespace {

Mechanics law_alone(const ModelFit& contact) {
  Mechanics m = contact.explanation->mechanics(contact.values);
  m.normal.correction = m.lateral.correction = nullptr;
  return m;
}

ModelFit what_is_in_case(const FitProblem& problem, const ModelFit& fit) {
  return fit.only(problem, in_case(fit.explanation->effects(), problem.experiment), fit);
}

}  // namespace

Mechanics reduced_law(const FitProblem& problem, const ModelFit& fit) {
  return law_alone(what_is_in_case(problem, fit));
}

Mechanics reduced_law_as_solved(const FitProblem& problem, const ModelFit& fit) {
  ModelFit contact = what_is_in_case(problem, fit);
  const auto& effects = contact.explanation->effects();
  const auto values = contact.values_of_effects();
  std::vector<double> as_solved;
  for (std::size_t e = 0; e < values.size(); ++e)
    for (const double value : effects[e]->values_as_solved(problem.experiment, values[e]))
      as_solved.push_back(value);
  // Those of the simulation itself stand first.
  contact.values.resize(contact.values.size() - as_solved.size());
  contact.values.insert(contact.values.end(), as_solved.begin(), as_solved.end());
  return law_alone(contact);
}

}  // namespace asperity
