// Runs of one table that were driven alike: what their responses scatter is noise, whatever the law.
#pragma once

#include "diagnosis/recording/recording.h"
#include "diagnosis/recording/samples.h"

namespace asperity {

/// Standard deviation between runs of a table whose control is the same, sample by sample, in units of the
/// response; 0 if there are too few.
double scatter_of_repeats(const Recording& recording, const Samples& samples, std::size_t table);

}  // namespace asperity
