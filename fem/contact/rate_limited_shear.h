// Shear of laws of friction that resist by the rate of slip (FrictionLaw::resists_by_rate), found together
// with the slip.
//
// At rest the limit of such a law is zero: taken in turn with the slip, as for others, it would make each
// point stick and slip by turns. With the trial traction t* = lambda - eps s of the augmented Lagrangian,
//   L = limit(slip),   slip = (|t*| - L)/eps,   t = L t*/|t*|,
// which is the law's at the fixed point of the multipliers. For a limit that grows with the slip this derives
// from a convex potential, as the return to a given limit does: a dashpot in series with the penalty.
#pragma once

#include "fem/interface/friction_law.h"

namespace asperity::fem {

/// point: under its pressure, before this step's slip; size of the trial traction [Pa]; penalty eps [Pa/m].
/// Expects a limit that falls by less than eps per slip.
Shear return_to_rate(const FrictionLaw& law, const InterfacePoint& point, const double* history,
                     const PlaneVector& trial, double penalty);

}  // namespace asperity::fem
