#include "dem_compare/experiments/from_parameters.h"

#include "core/error.h"

namespace asperity {
namespace {

bool is_constant(const EffectiveQuantity& stiffness) { return stiffness.length_scale != LengthScale::contact_radius; }

/// G* that gives the record's k_l = 8 G* a.
double sliding_modulus_of(const ContactParameters& parameters) {
  const bool known_at_load = parameters.lateral_stiffness && std::isfinite(parameters.lateral_stiffness->at_load);
  if (!known_at_load) {
    if (parameters.reduced_shear_modulus) return parameters.reduced_shear_modulus->value;
    throw InputError(parameters.file +
                     ": neither 'reduced_shear_modulus' nor 'lateral_stiffness' with its at_load is given; give one");
  }
  constexpr double mindlin = 8;
  return parameters.lateral_stiffness->value / (mindlin * parameters.contact_radius(parameters.lateral_stiffness->at_load));
}

RotationalStiffness rotational_stiffness(const ContactParameters& parameters, const std::optional<EffectiveQuantity>& given) {
  using Kind = RotationalStiffness::Kind;
  if (!given) return {Kind::tangential_spring, sliding_modulus_of(parameters)};
  if (is_constant(*given)) return {Kind::constant, given->value};
  return {Kind::with_radius, given->value / parameters.contact_radius(given->at_load)};
}

/// Coefficient, offset, length and stiffness of rolling or torsion.
template <class Resistance>
Resistance resistance(const ContactParameters& parameters, const std::optional<EffectiveQuantity>& friction,
                      const std::optional<EffectiveQuantity>& offset, const std::optional<EffectiveQuantity>& stiffness) {
  Resistance law;
  if (!friction) return law;
  law.coefficient = friction->value;
  law.adhesion_force = value_or_zero(offset);
  if (friction->length_scale == LengthScale::contact_radius) law.length = LengthScale::contact_radius;
  if (friction->length_scale == LengthScale::none) law.coefficient /= parameters.particle.radius;  // it is a length
  law.stiffness = rotational_stiffness(parameters, stiffness);
  return law;
}

}  // namespace

ContactModel contact_model(const ContactParameters& parameters, const ReducedLawOptions& options) {
  const double attraction = options.normal_adhesion ? value_or_zero(parameters.pull_off_force) : 0;
  const double radius = parameters.effective_radius();
  if (!parameters.sliding_friction)
    throw InputError(parameters.file + ": 'sliding_friction' is missing among the quantities; give it");
  ContactModel model;
  model.lever = options.lever;
  model.history_spin = HistorySpin::other_body;
  if (parameters.reduced_modulus) model.normal = HertzOffset{parameters.reduced_modulus->value, radius, attraction};
  else if (parameters.normal_stiffness) model.normal = LinearNormal{parameters.normal_stiffness->value, radius, attraction};
  else throw InputError(parameters.file + ": neither 'reduced_modulus' nor 'normal_stiffness' is given; give one");
  const CoulombLimit friction{parameters.sliding_friction->value, value_or_zero(parameters.sliding_offset)};
  if (options.partial_slip) model.sliding = MindlinDeresiewicz{sliding_modulus_of(parameters), radius, friction};
  else if (parameters.lateral_stiffness && is_constant(*parameters.lateral_stiffness))
    model.sliding = LinearSliding{parameters.lateral_stiffness->value, friction};
  else model.sliding = Mindlin{sliding_modulus_of(parameters), friction};
  model.rolling = resistance<RollingResistance>(parameters, parameters.rolling_friction, parameters.rolling_offset,
                                                parameters.rolling_stiffness);
  model.torsion = resistance<TorsionResistance>(parameters, parameters.torsion_friction, parameters.torsion_offset,
                                                parameters.torsion_stiffness);
  return model;
}

}  // namespace asperity
