// Linear spring with a constant attraction (Cundall & Strack 1979): f_n = k delta - h, a = (R delta)^(1/2).
// SI units. An engine's convenience, no contact mechanics: right at the one load where k was taken from.
#pragma once

#include <cmath>

#include "dem_compare/laws/law_registry.h"
#include "dem_compare/laws/normal_state.h"

namespace asperity {

struct LinearNormal {
  double spring_stiffness = 0;  ///< k [N/m]
  double radius = 0;            ///< R [m]
  double adhesion_force = 0;    ///< h [N]

  NormalState advance(const NormalState&, double approach) const {
    if (approach <= 0) return {approach, 0, 0, 0, false};
    return {approach, spring_stiffness * approach - adhesion_force, std::sqrt(radius * approach),
            spring_stiffness, true};
  }
  double approach(double force) const { return (force + adhesion_force) / spring_stiffness; }
};

inline const LawEntry<LinearNormal, NormalMode> linear_normal_entry{
    {"linear", "f_n = k delta - h, a = (R delta)^(1/2)", "Cundall & Strack 1979",
     "near the one load where k was taken from"},
    {{{"spring_stiffness", "N/m", "k"}, &LinearNormal::spring_stiffness},
     {{"radius", "m", "R, for the contact radius"}, &LinearNormal::radius},
     {zero_otherwise({"adhesion_force", "N", "constant attraction h"}), &LinearNormal::adhesion_force}}};

}  // namespace asperity
