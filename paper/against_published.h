// Simulated resistances and their trend with roughness beside the paper's Table 2, where contact and load are
// the paper's. The paper's rolling numbers are means over two contacts of the sphere, with silicon below and
// a diamond indenter above: what roughness of the silicon changes at its own contact is twice what it changes
// in the mean.
#pragma once

#include <vector>

#include "dem_compare/resistance/measured_resistances.h"
#include "paper/published.h"

namespace asperity {

/// `trends` must outlive the result.
AgainstPublished against_published(const MovingStudy& study, const std::vector<RoughnessTrend>& trends,
                                   const Published& published);

}  // namespace asperity
