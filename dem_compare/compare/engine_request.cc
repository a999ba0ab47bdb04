#include "dem_compare/compare/engine_request.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {
namespace {

/// Quasi-static: the density sets the time step of the engine and no result.
ContactParameters with_density(ContactParameters p) {
  constexpr double density_of_silica = 2200;
  if (!std::isfinite(p.particle.density)) p.particle.density = density_of_silica;
  return p;
}

}  // namespace

EffectiveQuantity constant(double value, LengthScale scale) {
  EffectiveQuantity quantity;
  quantity.value = value;
  quantity.length_scale = scale;
  return quantity;
}

ContactParameters of_bodies(const ComparedContact& contact) {
  ContactParameters p;
  if (contact.record) {
    p = *contact.record;
    p.normal_stiffness.reset();
    p.lateral_stiffness.reset();
  } else {
    p.file = contact.label;
    p.particle.radius = contact.radius;
    p.target.radius = std::numeric_limits<double>::infinity();
    if (contact.friction > 0) p.sliding_friction = constant(contact.friction);
  }
  p.reduced_modulus = constant(contact.hertz().reduced_modulus);
  p.reduced_shear_modulus = constant(contact.reduced_shear_modulus());
  return with_density(p);
}

ContactParameters as_given(const ComparedContact& contact) { return with_density(*contact.record); }

EngineExperiment engine_experiment(Motion type, const ContactParameters& substrate,
                                   const ContactParameters& indenter, double load, double rail_angle) {
  EngineExperiment experiment;
  experiment.type = type;
  experiment.substrate = substrate;
  experiment.indenter = indenter;
  if (!std::isfinite(experiment.indenter.particle.density))
    experiment.indenter.particle.density = substrate.particle.density;
  experiment.load = load;
  experiment.rail_angle = rail_angle;
  if (type == Motion::torsion) return experiment;  // goes by its limit, not by an amplitude
  const ClosedForm form = closed_form(experiment);
  constexpr double room = 10;
  experiment.amplitude = room * std::max(form.first_yield, form.full_yield);
  return experiment;
}

EngineExperiment glued(ContactParameters p, double load) {
  constexpr double any_friction = 0.1;
  if (!p.sliding_friction || p.sliding_friction->value <= 0) p.sliding_friction = constant(any_friction);
  return engine_experiment(Motion::sliding, p, p, load);
}

EngineExperiment twisting(const ComparedContact& contact, double load, double stiffness, double limit) {
  ContactParameters p = of_bodies(contact);
  p.torsion_stiffness = constant(stiffness, LengthScale::particle_radius);
  p.torsion_friction = constant(limit / (load * contact.radius), LengthScale::particle_radius);
  p.torsion_offset.reset();
  if (!p.sliding_friction) p.sliding_friction = constant(contact.friction);
  return engine_experiment(Motion::torsion, p, p, load);
}

EngineRequest rail_run(const ComparedContact& contact, double load, const RailCase& rail, double torsion,
                       bool with_offsets) {
  ContactParameters p = as_given(contact);
  p.rolling_friction = constant(rail.rolling.value, LengthScale::particle_radius);
  p.torsion_friction = constant(torsion, LengthScale::particle_radius);
  p.rolling_offset = constant(rail.offset.value);
  if (!with_offsets) {
    p.rolling_offset.reset();
    p.torsion_offset.reset();
  }
  return EngineRequest{engine_experiment(Motion::rail, p, p, load, rail.angle), "rail coefficient"};
}

}  // namespace asperity
