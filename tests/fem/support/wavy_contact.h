// A wavy sphere on a smooth plane, small enough for seconds: what tests compare that must not depend on
// control, linear solver or number of ranks.
#pragma once

#include <cmath>

#include "fem/contact/contact_system.h"

namespace asperity::test {

/// yield_stress: of the particle [Pa]; cells_per_radius: of Hertz' contact at 100 uN.
inline fem::ContactSystemOptions wavy_contact(double yield_stress, double cells_per_radius = 6) {
  fem::ContactSystemOptions o;
  constexpr double a = 230e-9;
  auto& s = o.mesh.sizes;
  s.radius = 8.5e-6, s.block_half_width = 6e-6;
  s.spacing_particle = s.spacing_substrate = a / cells_per_radius;
  s.offset_substrate_x = 0.3 * s.spacing_substrate;
  s.region_particle = 1.3 * a;
  s.region_substrate = 1.3 * a + 3 * s.spacing_substrate;
  o.mesh.particle_height = [](double x, double y) {
    return 2e-9 * std::sin(x / 20e-9) * std::cos(y / 25e-9);
  };
  o.mesh.largest_height_particle = 2e-9;
  o.materials = {fem::J2Material::elastic(71e9, 0.17), fem::J2Material::elastic(179e9, 0.25)};
  o.materials[0].yield_stress = yield_stress;
  return o;
}

}  // namespace asperity::test
