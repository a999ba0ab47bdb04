// Missing pixels filled by the smoothest heights that their surroundings allow: the discrete Laplace equation
// with the known pixels as boundary values (membrane interpolation), solved by a coarse-to-fine start and
// relaxation.
#pragma once

#include "surfaces/topography.h"

namespace asperity {

/// The map without missing pixels; `source` says how many were filled. Throws InputError if all are missing.
Topography fill_missing(const Topography& map);

}  // namespace asperity
