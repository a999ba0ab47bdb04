// Whether a recorded lateral force and displacement are positive in the same direction.
#pragma once

#include "diagnosis/recording/recording.h"

namespace asperity {

/// Lets force and displacement of each lateral trace be positive in the same direction, so that its friction
/// dissipates: where the force of most runs is smaller, beyond scatter, chance and a drift that goes on, on
/// the way forward than on the way back, the displacement's sign is turned (the force's, where the names of
/// segments alone say the direction), and `recording.remarks` says so. A run in one direction, to whose force
/// a constant may be added, tells that only if its segment is "forward" while the displacement falls, or
/// "backward" while it rises. Runs that contradict the rest stay as they are, and a remark counts them.
void turn_signs_to_dissipate(Recording& recording);

}  // namespace asperity
