// The next step of a particle that rolls freely: its shift relieves the lateral force.
#pragma once

#include <vector>

#include "fem/programs/program.h"
#include "results/history.h"

namespace asperity::fem {

/// What the next step is estimated from.
struct RollingContact {
  double radius = 0, hertz_radius = 0;  ///< of the particle and of Hertz' contact [m]
  double lateral_stiffness = 0;         ///< [N/m]; 0: without friction
};

/// Shift and angle of a step.
struct RollingStep {
  double path_per_angle = 0;  ///< [m/rad]
  double back =
      0;  ///< shift against the rolling direction that relieves the lateral force left by the last step [m]
};

/// The next step of a program of which `records` (one at least) are done. A quarter of
/// that shift corrects the path length per angle, which is shorter than the radius by about the approach.
RollingStep free_rolling(const std::vector<Station>& program, const std::vector<HistoryRow>& records,
                         const RollingContact& contact);

}  // namespace asperity::fem
