#include "dem_compare/laws/mindlin.h"
#include "diagnosis/mechanics/mechanics.h"

namespace asperity {
namespace {

double value_of(const SimulationChoice& choice, const std::string& name) {
  const auto found = choice.parameters.find(name);
  return found == choice.parameters.end() ? 0 : found->second.value;
}

}  // namespace

Mechanics baseline_mechanics(const Experiment& experiment, const SimulationChoice& choice) {
  Mechanics m;
  m.experiment = experiment;
  m.geometry = experiment.hertz();
  m.normal.contact = std::make_shared<HertzContact>(m.geometry);
  switch (experiment.mode) {
    case Motion::normal:
      break;
    case Motion::sliding:
      m.lateral.coefficient = value_of(choice, "sliding_friction");
      // Finite elements slip at their edge first, whatever laws are named.
      if (experiment.by_finite_elements) m.lateral.stick = LateralMechanics::Stick::strips;
      break;
    case Motion::rolling:
      m.lateral.coefficient = value_of(choice, "rolling_friction");
      break;
    case Motion::rail:
      m.lateral.coefficient = value_of(choice, "rolling_friction");
      if (choice.torsion == "constant") m.lateral.torsion_coefficient = value_of(choice, "torsion_friction");
      break;
    case Motion::torsion:
      m.lateral.coefficient = value_of(choice, "torsion_friction");
      // Local friction that slips everywhere acts over the contact's radius.
      if (experiment.by_finite_elements) m.lateral.length = LengthScale::contact_radius;
      break;
    case Motion::program:
      break;
  }
  return m;
}

}  // namespace asperity
