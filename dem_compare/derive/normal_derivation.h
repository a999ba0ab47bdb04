// Normal law of a parameter set: E* and the effective radius of Hertz fits, the exponent, k_n at each load,
// and the pull-off force. F = (4/3) E* R^(1/2) (delta - offset)^(3/2) over the first loading
// (normal_numbers.h); E* for the particle's own radius, or R for the materials' own E*. SI units. Valid on
// the loads of the fit; plastic flow of the first loading is in E*.
#pragma once

#include "dem_compare/derive/derivation.h"

namespace asperity {

/// Sets reduced_modulus, normal_stiffness and pull_off_force, and adds what was found.
void derive_normal(const ReducedSet& set, Derivation& derivation);

}  // namespace asperity
