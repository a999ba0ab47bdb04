#include "diagnosis/conceal/world.h"

#include <cmath>

namespace asperity::hidden {

double between(Random& random, double low, double high) {
  return low * std::pow(high / low, std::uniform_real_distribution<double>()(random));
}

double sign(Random& random) { return std::uniform_real_distribution<double>()(random) < 0.5 ? -1 : 1; }

double World::hide(const std::string& effect, const std::string& model, const std::string& parameter,
                   double value, bool is_the_catalogues) {
  for (auto& known : effects)
    if (known.id == effect) {
      known.parameters[parameter] = {value, is_the_catalogues};
      return value;
    }
  TrueEffect added;
  added.id = effect;
  added.model = model;
  for (const Motion mode : all_modes())
    for (const auto& other : concealable_out_of_catalogue(mode))
      if (other == effect) added.in_catalogue = false;
  if (!parameter.empty()) added.parameters[parameter] = {value, is_the_catalogues};
  effects.push_back(added);
  return value;
}

bool World::hides(const std::string& effect) const {
  for (const auto& known : effects)
    if (known.id == effect) return true;
  return false;
}

double World::value(const std::string& effect, const std::string& parameter) const {
  for (const auto& known : effects)
    if (known.id == effect && known.parameters.count(parameter)) return known.parameters.at(parameter).value;
  return 0;
}

std::vector<std::string> concealable_by_other_code(Motion mode) {
  if (mode == Motion::normal) return {"bulk_plasticity", "film", "roughness_compliance"};
  return {};
}

std::vector<std::string> concealable(Motion mode) {
  switch (mode) {
    case Motion::normal:
      return {"instrument_compliance",
              "contact_point_offset",
              "thermal_drift",
              "adhesion",
              "effective_radius",
              "bulk_plasticity",
              "roughness_compliance",
              "creep",
              "baseline_tilt",
              "adhesion_hysteresis",
              "pop_in",
              "capillary",
              "viscoelasticity"};
    case Motion::sliding:
      return {"lateral_compliance",
              "adhesion_offset",
              "static_friction_peak",
              "velocity_dependence",
              "partial_slip",
              "surface_tilt",
              "lateral_zero_offset",
              "area_proportional_friction",
              "run_in",
              "stick_slip",
              "rate_and_state"};
    case Motion::rolling:
      return {"rolling_adhesion_offset", "contact_radius_scaling", "roughness_dependent_rolling",
              "viscous_rolling"};
    case Motion::rail:
      return {"torsion_resistance", "rolling_adhesion_offset", "viscous_rolling"};
    case Motion::torsion:
      return {"contact_radius_scaling"};
    case Motion::program:
      break;
  }
  return {};
}

std::vector<std::string> concealable_out_of_catalogue(Motion mode) {
  switch (mode) {
    case Motion::normal:
      return {"interference", "piezo_hysteresis", "thermal_oscillation"};
    case Motion::sliding:
      return {"position_weakening", "lateral_oscillation"};
    case Motion::rolling:
      return {"resistance_peak"};
    default:
      return {};
  }
}

std::vector<std::string> concealable_beside_a_case(Motion mode) {
  if (mode == Motion::rolling) return {"rolling_adhesion_hysteresis"};
  if (mode == Motion::torsion) return {"adhesion_offset"};
  return {};
}

Recording paper_bodies(Motion mode, const std::string& title) {
  Recording recording;
  recording.title = title;
  recording.mode = mode;
  recording.particle = {"borosilicate", 71e9, 0.17, 8.5e-6, 0.7e-9, RecordedBody::unknown};
  recording.substrate = {"Si(100)", 179e9, 0.25, RecordedBody::unknown, 0.3e-9, RecordedBody::unknown};
  if (mode == Motion::rolling || mode == Motion::rail)
    recording.indenter =
        RecordedBody{"diamond", 1140e9, 0.07, RecordedBody::unknown, 4e-9, RecordedBody::unknown};
  return recording;
}

}  // namespace asperity::hidden
