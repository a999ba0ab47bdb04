// What a study found, in sentences.
#pragma once

#include <string>
#include <vector>

#include "report/curves/study_curves.h"

namespace asperity::report {

/// Largest relative errors of the balances over all cases; empty where none are known.
std::string worst_balance_sentence(const CaseCollection& collection);
std::string study_verdict(const CaseCollection& collection, const std::vector<StudyCurve>& curves);

}  // namespace asperity::report
