#include "engines/parameters/contact_parameters.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace asperity {
namespace {

using OptionalQuantity = std::optional<EffectiveQuantity>;

/// The quantity, or an error that says which key is missing and what it would mean.
const EffectiveQuantity& need(const ContactParameters& parameters,
                              OptionalQuantity ContactParameters::*member) {
  if (parameters.*member) return *(parameters.*member);
  for (const auto& entry : quantity_entries())
    if (entry.member == member)
      throw InputError(parameters.file + ": 'quantities' has no '" + entry.key + "' (" + entry.meaning +
                       "), which is needed here; a solved case of this contact with Experiment/Type = " +
                       entry.told_by + " tells it to 'asperity derive'");
  throw InputError(parameters.file + ": a quantity is missing");
}

/// A stiffness at another load than its own.
double stiffness_at_load(const ContactParameters& parameters, const EffectiveQuantity& stiffness,
                         double load) {
  if (stiffness.length_scale != LengthScale::contact_radius) return stiffness.value;
  return stiffness.value * parameters.contact_radius(load) / parameters.contact_radius(stiffness.at_load);
}

double torque_limit(const ContactParameters& parameters, OptionalQuantity ContactParameters::*friction,
                    OptionalQuantity ContactParameters::*offset, double load) {
  const EffectiveQuantity& mu = need(parameters, friction);
  return mu.value * parameters.length(mu.length_scale, load) * (load + value_or_zero(parameters.*offset));
}

}  // namespace

const std::vector<QuantityEntry>& quantity_entries() {
  using P = ContactParameters;
  static const std::vector<QuantityEntry> entries{
      {"reduced_modulus", "Pa", "E* of F = (4/3) E* R^(1/2) delta^(3/2)", "normal", &P::reduced_modulus},
      {"reduced_shear_modulus", "Pa", "G* of k_l = 8 G* a", "sliding", &P::reduced_shear_modulus},
      {"normal_stiffness", "N/m", "k_n at its at_load", "normal", &P::normal_stiffness},
      {"lateral_stiffness", "N/m", "k_l at its at_load", "sliding", &P::lateral_stiffness},
      {"rolling_stiffness", "N m/rad", "k_ro at its at_load", "rolling", &P::rolling_stiffness},
      {"torsion_stiffness", "N m/rad", "k_to at its at_load", "torsion", &P::torsion_stiffness},
      {"sliding_friction", "", "mu_l of |f_l| <= mu_l (f + h_l)", "sliding", &P::sliding_friction},
      {"sliding_offset", "N", "h_l of |f_l| <= mu_l (f + h_l)", "sliding", &P::sliding_offset},
      {"rolling_friction", "", "mu_ro of |M| <= mu_ro lambda (f + h_ro)", "rolling", &P::rolling_friction},
      {"rolling_offset", "N", "h_ro of |M| <= mu_ro lambda (f + h_ro)", "rolling", &P::rolling_offset},
      {"torsion_friction", "", "mu_to of |M| <= mu_to lambda (f + h_to)", "torsion", &P::torsion_friction},
      {"torsion_offset", "N", "h_to of |M| <= mu_to lambda (f + h_to)", "torsion", &P::torsion_offset},
      {"pull_off_force", "N", "h_n, the force that parts the bodies", "normal", &P::pull_off_force},
      {"unloading_modulus", "Pa", "E* of Thornton & Ning's elasto-plastic law", "normal",
       &P::unloading_modulus, true},
      {"yield_pressure", "Pa", "p_y of Thornton & Ning's law", "normal", &P::yield_pressure, true},
      {"yielded_work_of_adhesion", "J/m^2", "w of Thornton & Ning's law", "normal",
       &P::yielded_work_of_adhesion, true},
      {"luding_k1", "N/m", "k1, loading, of Luding's piecewise linear law", "normal", &P::luding_k1, true},
      {"luding_kp", "N/m", "k_p, unloading from delta_p, of Luding's law", "normal", &P::luding_kp, true},
      {"luding_kc", "N/m", "k_c, adhesion, of Luding's law", "normal", &P::luding_kc, true},
      {"luding_delta_p", "m", "delta_p of Luding's law, up to which it was fitted", "normal",
       &P::luding_delta_p, true},
  };
  return entries;
}

double ContactParameters::effective_radius() const {
  return target.is_plane() ? particle.radius
                           : particle.radius * target.radius / (particle.radius + target.radius);
}

double ContactParameters::particle_mass() const {
  const double R = particle.radius;
  if (!std::isfinite(particle.density))
    throw InputError(file + ": 'particle/density' [kg/m^3] is missing, which a dynamic engine needs");
  return 4.0 / 3 * M_PI * R * R * R * particle.density;
}

Hertz ContactParameters::hertz() const {
  return {need(*this, &ContactParameters::reduced_modulus).value, effective_radius()};
}

double ContactParameters::normal_stiffness_at(double load) const {
  return normal_stiffness ? stiffness_at_load(*this, *normal_stiffness, load)
                          : hertz().normal_stiffness(load);
}

double ContactParameters::lateral_stiffness_at(double load) const {
  constexpr double mindlin = 8;
  return lateral_stiffness
             ? stiffness_at_load(*this, *lateral_stiffness, load)
             : mindlin * need(*this, &ContactParameters::reduced_shear_modulus).value * contact_radius(load);
}

double ContactParameters::rolling_stiffness_at(double load) const {
  return stiffness_at_load(*this, need(*this, &ContactParameters::rolling_stiffness), load);
}

double ContactParameters::torsion_stiffness_at(double load) const {
  return stiffness_at_load(*this, need(*this, &ContactParameters::torsion_stiffness), load);
}

double ContactParameters::length(LengthScale scale, double load) const {
  switch (scale) {
    case LengthScale::particle_radius:
      return particle.radius;
    case LengthScale::contact_radius:
      return contact_radius(load);
    case LengthScale::none:
      break;
  }
  return 1;
}

double ContactParameters::sliding_limit(double load) const {
  return need(*this, &ContactParameters::sliding_friction).value * (load + value_or_zero(sliding_offset));
}

double ContactParameters::rolling_limit(double load) const {
  return torque_limit(*this, &ContactParameters::rolling_friction, &ContactParameters::rolling_offset, load);
}

double ContactParameters::torsion_limit(double load) const {
  return torque_limit(*this, &ContactParameters::torsion_friction, &ContactParameters::torsion_offset, load);
}

std::optional<LoadRange> ContactParameters::load_range(OptionalQuantity ContactParameters::*friction,
                                                       OptionalQuantity ContactParameters::*offset) const {
  std::optional<LoadRange> common;
  for (const auto member : {friction, offset}) {
    const OptionalQuantity& quantity = this->*member;
    if (!quantity || !quantity->load_range) continue;
    if (!common) common = quantity->load_range;
    common->low = std::max(common->low, quantity->load_range->low);
    common->high = std::min(common->high, quantity->load_range->high);
  }
  if (common && common->low > common->high)
    throw InputError(
        file + ": a friction coefficient and its offset were found on load ranges without a load in common");
  return common;
}

}  // namespace asperity
