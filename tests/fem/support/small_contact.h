// A smooth elastic contact with some tens of thousands of unknowns.
#pragma once

#include "fem/contact/contact_system.h"

namespace asperity::test {

inline fem::ContactSystemOptions small_contact() {
  fem::ContactSystemOptions o;
  auto& s = o.mesh.sizes;
  s.radius = 8.5e-6, s.block_half_width = 6e-6;
  s.spacing_particle = s.spacing_substrate = 60e-9;
  s.region_particle = 280e-9, s.region_substrate = 460e-9;
  o.materials = {fem::J2Material::elastic(71e9, 0.17), fem::J2Material::elastic(179e9, 0.25)};
  return o;
}

}  // namespace asperity::test
