// Paths over the same surfaces, compared block by block: topography that both meet drops out of their
// difference, which is then better known than either. SI units.
#pragma once

#include <vector>

#include "dem_compare/cases/moving_case.h"

namespace asperity {

/// Energy per path length of each path over blocks that all of them passed steadily, as long as the longest
/// of their blocks and four at least: one row per path, in the order of the blocks. Empty where less
/// than half of a path is common to all.
std::vector<std::vector<double>> rates_in_common(const std::vector<const SteadyPath*>& paths,
                                                 DissipationPart part);

/// One less the other. The sd is that of the mean over blocks in common and, of the whole, what both
/// balances leave open; without blocks in common both err by themselves.
Uncertain paired_difference(const SteadyPath& one, const SteadyPath& other, DissipationPart part);

/// One over the other, of the whole; its sd as above (ratio of means: Cochran 1977, Sampling Techniques,
/// eq. 6.13).
Uncertain paired_ratio(const SteadyPath& one, const SteadyPath& other);

}  // namespace asperity
