// report.html of a diagnosis: verdict, where recording and simulation part, what was left out, how much
// better the fit is, and how sure one can be; for a reader who has nothing else.
#pragma once

#include <string>

#include "diagnosis/outcome/diagnosis.h"
#include "diagnosis/recording/recording.h"

namespace asperity::report {

std::string diagnosis_page(const Recording& recording, const Diagnosis& diagnosis);

}  // namespace asperity::report
