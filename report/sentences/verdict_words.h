// Verdicts in words: by how much a simplification misses, at which loads, and where it is good enough.
#pragma once

#include <string>
#include <vector>

#include "dem_compare/compare/side_by_side.h"
#include "dem_compare/compare/verdict.h"

namespace asperity::report {

/// "within 5 %"
/// tolerance: relative.
std::string within_text(double tolerance);

/// "overstates the lateral stiffness by 12 ± 3 % from 100 uN to 200 uN; whether within 5 % is not known at
/// 400 uN (5.5 ± 1.0 %)". Departures in order of load; nothing is said of loads between those compared.
/// tolerance: relative.
std::string departure_words(const std::vector<Departure>& departures, const std::string& quantity,
                            double tolerance);
/// A sentence: law or finite elements, departure_words, and what the mesh leaves open.
/// tolerance: relative.
std::string verdict_text(const LawVerdict& verdict, double tolerance);

/// " at 25 deg"; "" for NaN.
/// angle [rad].
std::string rail_words(double angle);

/// "from 135 uN on", "at all loads compared", "not known at any load compared", ...
std::string good_words(const LawVerdict& verdict);

/// The law against finite elements, otherwise against the measurement, at this row's load; "" where neither
/// is known.
/// tolerance: relative.
std::string row_verdict_text(const ComparisonRow& row, double tolerance);

/// How closely the engine does what the law says, over all lines of both; "" if none ran.
std::string engine_sentence(const SideBySide& comparison);

}  // namespace asperity::report
