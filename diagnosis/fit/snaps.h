// Residuals where a simulated contact snaps in or off.
#pragma once

#include <vector>

#include "diagnosis/recording/samples.h"

namespace asperity {

/// When a contact snaps hangs on less than its law, the noise of the displacement and the distance of samples
/// tell: the sample before a snap of the simulation and the one after it may have been recorded on either
/// side. Their residuals are those to the nearer side. A solution in load steps snaps off somewhere within
/// one of them: samples that near, by Samples::snap_width, may lie on either side and between. Of normal
/// contact alone. residual: recorded less simulated, in the unit of the response; 0 of samples that do not
/// count.
void forgive_a_sample_at_snaps(const Samples& samples, const std::vector<double>& simulated,
                               std::vector<double>& residual);

}  // namespace asperity
