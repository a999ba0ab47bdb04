// What a study found, in sentences.
#pragma once

#include <string>
#include <vector>

#include "report/study_curves.h"

namespace asperity::report {

std::string study_verdict(const CaseCollection& collection, const std::vector<StudyCurve>& curves);

}  // namespace asperity::report
