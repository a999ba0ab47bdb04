// At which loads, and how far, a case is slid, rolled or spun for a recording. SI units.
#pragma once

#include <vector>

#include "diagnosis/fit/model_fit.h"
#include "diagnosis/forward/forward_model.h"

namespace asperity {

/// Three of the recorded loads of each surface at most, the largest first, each with a path on which a
/// contact of this local friction slips as a whole, or rolls steadily. Throws InputError where nothing is
/// pressed, and for rolling in a groove.
std::vector<MotionProtocol> motion_protocols_of(const FitProblem& problem, bool is_smooth);

/// The same with loads that are solved already in place of those that are near: the difference is known at
/// any load between.
std::vector<MotionProtocol> at_solved_loads(std::vector<MotionProtocol> asked,
                                            const std::vector<MotionProtocol>& solved);

/// RMS roughnesses [m] but for rounding.
bool have_same_roughness(double one, double other);
/// Of smooth spheres that touch without slip, 8 G* a [N/m] (Mindlin 1949).
double lateral_stiffness(const Experiment& experiment, double normal_force);

}  // namespace asperity
