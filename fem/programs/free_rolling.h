// How a particle that rolls freely goes on: so that no lateral force stays on it.
#pragma once

#include <vector>

#include "fem/programs/program.h"
#include "results/history.h"

namespace asperity::fem {

struct RollingContact {
  double radius = 0, hertz_radius = 0;  ///< of the particle and of Hertz' contact [m]
  double lateral_stiffness = 0;         ///< [N/m]; 0: without friction
};

struct RollingStep {
  double way_per_angle = 0;  ///< [m/rad]
  double back =
      0;  ///< way along which the lateral force that the last step left along it is given way to [m]
};

/// The next step of a program of which `records` (one at least) are done. A quarter of what is given way to
/// enters the way per angle, which is shorter than the radius by about the approach.
RollingStep free_rolling(const std::vector<Station>& program, const std::vector<HistoryRow>& records,
                         const RollingContact& contact);

}  // namespace asperity::fem
