// Whether a recorded lateral force and displacement are positive in the same direction.
#pragma once

#include "diagnosis/recording/recording.h"

namespace asperity {

/// Lets force and displacement of each lateral trace be positive in the same direction, so that its friction
/// dissipates: where the force is smaller, beyond its scatter, while the displacement rises than while it
/// falls, the displacement's sign is turned and `recording.remarks` says so. A run in one direction, to whose
/// force a constant may be added, tells that only if its segment is "forward" while the displacement falls,
/// or "backward" while it rises. Throws InputError, naming the table, where some of its runs dissipate and
/// others would give energy, or where only the names of segments say the direction.
void turn_displacement_along_force(Recording& recording);

}  // namespace asperity
