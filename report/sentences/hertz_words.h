// A contact against Hertz in words: within, outside or not known by the intervals of its ratios.
#pragma once

#include <string>

#include "dem_compare/compare/comparison.h"

namespace asperity::report {

/// Of a group whose loads are judged.
/// tolerance: relative.
std::string verdict_against_hertz(const GroupComparison& group, double tolerance);

/// "20 %" of a ratio 0.8; with as many digits as tell it from the tolerance.
std::string percent_off_one(double ratio, double tolerance);

/// " (-58 to +56 %)": the interval of a departure; "" where its width is not known or too small to be seen.
/// Both relative.
std::string interval_words(double departure, double half_width);

}  // namespace asperity::report
