// What the moments say on their length, in sentences.
#pragma once

#include <string>
#include <vector>

#include "dem_compare/resistance/findings.h"

namespace asperity {

/// "lambda = a", "cannot tell"
const char* verdict_words(LengthAnswer::Verdict verdict);
/// One per contact and motion.
std::vector<std::string> length_sentences(const ResistanceFindings& findings);

}  // namespace asperity
