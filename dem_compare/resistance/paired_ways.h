// Ways over the same surfaces, compared stretch by stretch: hills that both meet drop out of their
// difference, which is then better known than either. SI units.
#pragma once

#include <vector>

#include "dem_compare/cases/moving_case.h"

namespace asperity {

/// Energy per way of each way over stretches that all of them passed steadily, as long as the longest of
/// their stretches and four at least: one row per way, in the order of the stretches. Empty where less than
/// half of a way is common to all.
std::vector<std::vector<double>> rates_in_common(const std::vector<const SteadyWay*>& ways, WayPart part);

/// One less the other. The sd is that of the mean over stretches in common and, of the whole, what both
/// balances leave open; without stretches in common both err by themselves.
Uncertain paired_difference(const SteadyWay& one, const SteadyWay& other, WayPart part);

/// One over the other, of the whole; its sd as above (ratio of means: Cochran 1977, Sampling Techniques,
/// eq. 6.13).
Uncertain paired_ratio(const SteadyWay& one, const SteadyWay& other);

}  // namespace asperity
