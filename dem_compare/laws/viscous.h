// Viscous part of the contact force (Thornton, Cummins & Cleary 2013, as used by Fuchs, Weinhart et al.
// 2014):
//   f_d = gamma v,   gamma = c (m k)^(1/2),   k = d f_n/d delta at the present approach;   M_d = gamma lambda
//   r omega.
// c = 2 (5/6)^(1/2) beta gives a restitution that does not depend on speed for Hertz' law, beta = -ln e/(ln^2
// e + pi^2)^(1/2) (Tsuji, Tanaka & Ishida 1992). It acts in all modes with the same gamma, and only before
// the slider moves: the sum of elastic and viscous part obeys the slider's limit. A numerical device: it
// stands for no measured loss. SI units.
#pragma once

#include <cmath>

#include "dem_compare/laws/law_registry.h"

namespace asperity {

struct ViscousDamping {
  double coefficient = 0;  ///< c [-]

  double factor(double mass, double normal_stiffness) const {
    return coefficient * std::sqrt(mass * normal_stiffness);
  }
};

inline const LawEntry<ViscousDamping, ViscousMode> viscous_entry{
    {"viscous", "f_d = c (m k)^(1/2) v, k = d f_n/d delta",
     "Thornton, Cummins & Cleary 2013; Tsuji et al. 1992",
     "a numerical device for dynamic runs; rates far below the contact's own frequency"},
    {{{"coefficient", "", "c"}, &ViscousDamping::coefficient}}};

}  // namespace asperity
