// Energy balance along a path: external work against stored energy and dissipation.
#pragma once

#include <vector>

#include "results/history.h"

namespace asperity::fem {

/// Sets `work` [J] and `energy_error` (over the largest work) of all records of a path from first touch, anew
/// with each step: a step's work becomes better known with the one that follows. rolling_radius: of the
/// particle [m].
void balance_energy(std::vector<HistoryRow>& records, bool has_adhesion, double rolling_radius);

}  // namespace asperity::fem
