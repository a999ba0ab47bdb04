// What the moments say on their length, in sentences.
#pragma once

#include <string>
#include <vector>

#include "dem_compare/resistance/findings.h"

namespace asperity {

/// "lambda = a", "cannot tell"
const char* verdict_words(LengthAnswer::Verdict verdict);
/// The same; of "neither" with telling odds, which of the two lengths is the better one.
std::string verdict_words(const LengthAnswer& answer);
/// One per contact and motion.
std::vector<std::string> length_sentences(const ResistanceFindings& findings);

}  // namespace asperity
