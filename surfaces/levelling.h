// Removing tilt, bow or line offsets from a scan by least squares; missing points take no part.
#pragma once

#include "core/topography_spec.h"
#include "surfaces/topography.h"

namespace asperity {

/// The map with its least-squares fit subtracted. A row with fewer known points than its polynomial needs is
/// fitted with a lower degree. A levelled map is not periodic unless only its mean was removed.
Topography levelled(Topography map, Level level);

}  // namespace asperity
