// Laws of one mode of motion (sliding, torsion, rolling) from the cases of that experiment: steady resistance
// after full slip, R = mu lambda (f + h), its length lambda where it has one, and the stiffness without slip.
// SI units. A resistance holds for constant load and for paths beyond full slip; see core/steady_motion.h and
// resistance_law.h.
#pragma once

#include "dem_compare/derive/derivation.h"

namespace asperity {

/// Sets the quantities of the mode (for sliding, reduced_shear_modulus too) and adds what was found; the
/// normal law must be there already.
void derive_motion(const ReducedSet& set, const MotionMode& mode, Derivation& derivation);

}  // namespace asperity
