// Samples that lie far off their neighbours, alone or two side by side.
#pragma once

#include <cstddef>
#include <vector>

#include "diagnosis/fit/noise.h"

namespace asperity {

/// Marks samples that lie far off those around them (Hampel 1974), alone or two side by side, as not
/// counting; none where they would be more than a twentieth of all. `residual`, `noise`: of every sample, in
/// the unit of the response. Returns how many.
std::size_t mark_outliers(Samples& samples, const std::vector<double>& residual, const Noise& noise);

}  // namespace asperity
