// The comparison side by side as one page: verdicts in words, where each simplification is good enough, a
// figure and a table for each quantity.
#pragma once

#include <string>
#include <vector>

#include "dem_compare/compare/side_by_side.h"
#include "report/page/chart.h"

namespace asperity::report {

/// A quantity of one contact (one rail, if it is one) over the load: finite elements, law, engine and
/// measurement.
Chart quantity_chart(const std::vector<const ComparisonRow*>& rows);

/// Self-contained HTML.
std::string comparison_page(const SideBySide& comparison);

}  // namespace asperity::report
