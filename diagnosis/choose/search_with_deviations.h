// The search where rows of a series give deviations of their radius, roughness, load, ...: what these count
// depends on how the response depends on them, which the best explanation says better than the simulation.
#pragma once

#include "diagnosis/choose/search.h"
#include "diagnosis/fit/prepared_fit.h"

namespace asperity {

/// search_effects() with its seed for scans of what is left; again with the noise and baseline of `prepared`
/// anew, as long as deviations count otherwise in what was found.
SearchResult search_with_deviations(PreparedFit& prepared, unsigned seed,
                                    const std::function<void(const std::string&)>& progress);

}  // namespace asperity
