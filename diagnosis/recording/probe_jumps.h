// Where a probe on a soft spring jumps to the surface or off it: it moves on its own then, faster than it is
// driven, and inertia and the fluid around it hold it back. A simulation in equilibrium says nothing of it.
#pragma once

#include "diagnosis/recording/samples.h"

namespace asperity {

/// Marks samples under a driven displacement as not counting where it moves at more than twice the
/// speed that a twentieth of its run's samples stays above, in all for less than a fiftieth of the run;
/// returns how many.
std::size_t mark_probe_jumps(Samples& samples);

}  // namespace asperity
