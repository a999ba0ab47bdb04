// Tables of a study: surfaces, stiffness and contact against load, what stays behind and what a fit would
// report, cost.
#pragma once

#include <string>
#include <vector>

#include "report/curves/study_curves.h"

namespace asperity::report {

/// RMS and spectrum of each contact's surfaces; empty where none is generated.
std::string surfaces_table(const std::vector<StudyCurve>& curves);
std::string stiffness_table(const std::vector<StudyCurve>& curves);
std::string contact_table(const std::vector<StudyCurve>& curves);
/// At the end of the path.
std::string imprint_and_fit_table(const std::vector<StudyCurve>& curves);
std::string case_list(const CaseCollection& collection);

}  // namespace asperity::report
