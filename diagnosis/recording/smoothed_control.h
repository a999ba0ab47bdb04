// A driving channel without the noise that the response does not follow.
#pragma once

#include <vector>

#include "diagnosis/recording/samples.h"

namespace asperity {

/// Replaces a channel of one run by parabolas fitted to its neighbours within each part, over as many
/// (odd) as bring its noise down to `wanted` times itself [-], at most some quarter of the part (Savitzky &
/// Golay 1964): parabolas, for a motion may slow down before it turns. Nothing is changed where 1 is wanted.
/// Returns what is left of the noise at each sample of the run, as a factor [-].
std::vector<double> smooth_control(Samples& samples, const SampleRun& run, double Sample::*channel,
                                   double wanted);

}  // namespace asperity
