// Largest lateral force of each mode at one instant:
//   sliding   mu (f_n + h), or tau pi a^2
//   rolling, rail   by the power of a sphere that rolls under a plate in a groove of inclination theta (theta
//   = 0: a plane),
//             f_l r (1 + cos theta) = mu lambda (f_n + h) + 2 (mu lambda cos theta + mu_to lambda sin
//             theta)(f_s + h), f_s = f_n/(2 cos theta) at the plate; at one slope f_l/2 and f_s (Fuchs,
//             Weinhart et al. 2014, eq:forces4, eq:murail)
//   torsion   M/r = mu_to lambda/r (f_n + h): the moment as a force at the particle's radius
// lambda: the particle's radius r, or the contact's a. SI units.
#pragma once

#include "diagnosis/mechanics/mechanics.h"

namespace asperity {

double lateral_limit(const Mechanics& mechanics, const Sample& sample, double coefficient, bool at_substrate);
/// a of the particle's contact with the substrate (sliding, torsion) under the sample's normal force.
double hertz_radius(const Mechanics& mechanics, const Sample& sample);
/// The same under the force that presses the bodies together in sliding: the normal force and, with it, an
/// attraction h (Derjaguin, Muller & Toporov 1975); in other modes hertz_radius().
double attracted_radius(const Mechanics& mechanics, const Sample& sample);

}  // namespace asperity
