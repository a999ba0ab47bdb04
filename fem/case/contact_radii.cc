#include "fem/case/contact_radii.h"

#include <algorithm>
#include <cmath>

#include "core/coated_half_space.h"
#include "fem/interface/adhesion_law.h"
#include "fem/materials/material_law.h"

namespace asperity::fem {
namespace {

/// Radius of Hertz' contact of bodies that have relaxed, under the largest load or approach [m].
double relaxed_radius(const CaseInput& input, const CaseSetup& setup) {
  if (input.experiment.control == ExperimentInput::Control::displacement) return setup.hertz_radius;
  double compliance = 0;
  for (const BodyInput* body : {&input.particle, &input.substrate}) {
    const J2Material m = material_of(*body);
    const double G = (1 - m.relaxation.share) * m.shear_modulus, K = m.bulk_modulus;
    compliance += (3 * K + 4 * G) / (4 * G * (3 * K + G));
  }
  return std::cbrt(0.75 * setup.largest_contact_force() * input.radius * compliance);
}

}  // namespace

double filmed_contact_radius(const CaseInput& input, const CaseSetup& setup) {
  if (!input.particle.film.is_there() && !input.substrate.film.is_there()) return setup.hertz_radius;
  const auto alone = [](const ElasticBody& body) {
    return body.youngs_modulus / (1 - body.poisson_ratio * body.poisson_ratio);
  };
  double a = setup.hertz_radius;
  constexpr int enough = 60;  // the modulus changes with less than the radius itself
  for (int k = 0; k < enough; ++k) {
    double compliance = 0;
    for (const BodyInput* body : {&input.particle, &input.substrate}) {
      const double of_body = alone(elastic_body(*body));
      const CoatedHalfSpace coated{body->film.is_there() ? alone(elastic_film(body->film)) : of_body, of_body,
                                   body->film.thickness};
      compliance += 1 / (body->film.is_there() ? coated.modulus(a) : of_body);
    }
    if (input.experiment.control == ExperimentInput::Control::force)
      a = std::cbrt(0.75 * setup.largest_contact_force() * input.radius * compliance);
  }
  return a;
}

double largest_contact_radius(const CaseInput& input, const CaseSetup& setup) {
  constexpr double mean_pressure = 2, piled_up = 1.5;  // of the yield stress, of Hertz' radius
  const double yield = std::min({make_material_law(input.particle).yield_stress,
                                 make_material_law(input.substrate).yield_stress,
                                 input.particle.film.yield_stress, input.substrate.film.yield_stress});
  // On a soft film much thinner than the contact is wide it is up to the root of two wider than on a
  // homogeneous body (Perriot & Barthel 2004).
  const auto is_softer = [](const BodyInput& body) {
    return body.film.is_there() && body.film.youngs_modulus < body.youngs_modulus;
  };
  const bool soft = is_softer(input.particle) || is_softer(input.substrate);
  const double filmed = soft ? M_SQRT2 * setup.filmed_radius : 0;
  double flowing = std::sqrt(setup.largest_contact_force() / (M_PI * mean_pressure * yield));
  if (input.experiment.control == ExperimentInput::Control::displacement)
    flowing = std::min(flowing, piled_up * setup.hertz_radius);
  return std::max({relaxed_radius(input, setup), flowing, filmed});
}

double attracted_radius(const CaseInput& input, const CaseSetup& setup) {
  const double R = input.radius, E = setup.reduced_modulus,
               work = setup.attraction.acts() ? work_of_adhesion(input.interface).opening : 0,
               c = 3 * M_PI * work * R, F = setup.largest_contact_force();
  if (work == 0) return 0;
  if (input.experiment.control == ExperimentInput::Control::force)
    return std::cbrt(0.75 * R * (F + c + std::sqrt(2 * c * F + c * c)) / E);
  double a = setup.hertz_radius;
  constexpr int enough = 30;  // each iteration leaves a quarter of the change before
  for (int k = 0; k < enough; ++k)
    a = std::sqrt(R * (setup.hertz_approach + std::sqrt(2 * M_PI * work * a / E)));
  return a;
}

}  // namespace asperity::fem
