// The values that a solved case is for (`effective` of result.json), each with its standard deviation.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "core/case.h"
#include "fem/output/discretisation_error.h"
#include "fem/output/result_file.h"

namespace asperity::fem {

/// {"contact_area": {"value": 1e-13, "unit": "m^2", "sd": 1e-15}, ...}: of the contact at the row `peak` of
/// largest load, of yielding, of motion and of pull-off, as far as the case has them.
nlohmann::json effective_values(const CaseInput& input, const std::vector<HistoryRow>& records,
                                const HistoryRow& peak, const HistoryRow& least,
                                const DiscretisationError& error, const ResultSummary& summary);

/// Largest size of a column, in its unit.
double largest_size(const std::vector<HistoryRow>& records, double HistoryRow::*column);

}  // namespace asperity::fem
