// Coulomb's limit of the lateral force with an offset for adhesion (Coulomb 1785; Derjaguin 1934):
//   |f_l| <= mu (f_n + h).
// h stands for whatever holds the surfaces together without pressing from outside; the paper fits it for each
// mode by itself. One coefficient for rest and motion. Not valid where friction follows the area of contact
// instead of the load.
#pragma once

#include <algorithm>

#include "dem_compare/laws/law_registry.h"

namespace asperity {

/// Coefficient and offset of a limit.
struct CoulombLimit {
  double coefficient = 0;     ///< mu [-]
  double adhesion_force = 0;  ///< h [N]

  /// Largest lateral force [N] at a normal force [N].
  double limit(double normal_force) const {
    return std::max(0.0, coefficient * (normal_force + adhesion_force));
  }
};

/// Its parameters, of a law with the member `friction`.
template <class Law>
std::vector<LawField<Law>> friction_fields() {
  return {
      {{"coefficient", "", "mu"}, &Law::friction, &CoulombLimit::coefficient},
      {zero_otherwise({"adhesion_force", "N", "offset h"}), &Law::friction, &CoulombLimit::adhesion_force}};
}

}  // namespace asperity
