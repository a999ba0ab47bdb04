#include "fem/case/contact_radii.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/attraction_zone.h"
#include "fem/interface/adhesion_law.h"
#include "fem/materials/material_law.h"
#include "half_space/filmed_sphere.h"

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
  std::vector<half_space::FilmOnBody> films;
  for (const BodyInput* body : {&input.particle, &input.substrate})
    if (body->film.is_there())
      films.push_back({elastic_film(body->film), elastic_body(*body), body->film.thickness});
  if (films.empty()) return setup.hertz_radius;
  const half_space::FilmedSphere sphere(setup.reduced_modulus, films);
  if (input.experiment.control == ExperimentInput::Control::force)
    return sphere.radius_at_force(setup.largest_contact_force(), input.radius);
  return sphere.radius_at_approach(setup.hertz_radius * setup.hertz_radius / input.radius, input.radius);
}

double least_contact_radius(const CaseInput& input, const CaseSetup& setup) {
  const double elastic = std::min(setup.hertz_radius, setup.filmed_radius);
  const bool bare = !input.particle.film.is_there() && !input.substrate.film.is_there();
  const bool by_force = input.experiment.control == ExperimentInput::Control::force;
  if (!bare || !by_force || !setup.attraction.acts()) return elastic;
  const double drawn =
      radius_least_by_attraction(setup.reduced_modulus, input.radius,
                                 work_of_adhesion(input.interface).closing, setup.largest_contact_force());
  const double wave =
      std::min(setup.roughness[0].scales.shortest_wave, setup.roughness[1].scales.shortest_wave);
  return std::max(elastic, std::min(drawn, wave));
}

double largest_contact_radius(const CaseInput& input, const CaseSetup& setup) {
  constexpr double mean_pressure = 2, piled_up = 1.5;  // of the yield stress, of Hertz' radius
  const double yield = std::min({make_material_law(input.particle).yield_stress,
                                 make_material_law(input.substrate).yield_stress,
                                 input.particle.film.yield_stress, input.substrate.film.yield_stress});
  double flowing = std::sqrt(setup.largest_contact_force() / (M_PI * mean_pressure * yield));
  if (input.experiment.control == ExperimentInput::Control::displacement)
    flowing = std::min(flowing, piled_up * setup.hertz_radius);
  return std::max({relaxed_radius(input, setup), flowing, setup.filmed_radius});
}

double attracted_radius(const CaseInput& input, const CaseSetup& setup) {
  const double R = input.radius, E = setup.reduced_modulus,
               work = setup.attraction.acts() ? work_of_adhesion(input.interface).opening : 0,
               F = setup.largest_contact_force();
  if (work == 0) return 0;
  if (input.experiment.control == ExperimentInput::Control::force)
    return radius_widest_by_attraction(E, R, work, F);
  double a = setup.hertz_radius;
  constexpr int enough = 30;  // each iteration leaves a quarter of the change before
  for (int k = 0; k < enough; ++k)
    a = std::sqrt(R * (setup.hertz_approach + std::sqrt(2 * M_PI * work * a / E)));
  return a;
}

}  // namespace asperity::fem
