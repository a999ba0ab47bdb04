// Elastic solids of the paper.
#pragma once

#include "fem/materials/j2_plasticity.h"

namespace asperity::test {

inline const fem::J2Material borosilicate = fem::J2Material::elastic(71e9, 0.17),
                             silicon = fem::J2Material::elastic(179e9, 0.25);

}  // namespace asperity::test
