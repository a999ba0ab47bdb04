// Residual approach of a contact that has yielded.
#pragma once

#include <vector>

namespace asperity {

/// Approach that has not come back [m].
struct ResidualImprint {
  double depth;  ///< approach at the end of unloading less that of the first loading at the same force [m];
                 ///< NaN if nothing was unloaded
  double force;  ///< that force [N]
  double error;  ///< of the loading's approach below its first step: how far its power law is from Hertz'
                 ///< [m]; NaN as depth
};

/// approach [m], force [N] along the first loading and its unloading, with their turning point in both. Below
/// its first step the loading is a power law through first touch (no approach, no force) and its first two
/// steps; between steps approach is linear in force^(2/3) (Hertz). Steps after the first that bears nothing
/// any more are passed over: under control by displacement the bodies may be drawn apart further.
ResidualImprint residual_imprint(const std::vector<double>& loading_approach,
                                 const std::vector<double>& loading_force,
                                 const std::vector<double>& unloading_approach,
                                 const std::vector<double>& unloading_force);

}  // namespace asperity
