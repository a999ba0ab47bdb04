// The part of a study's page on moving contacts: what resists sliding, rolling and torsion, and what that
// says on the paper's open questions.
#pragma once

#include <string>

#include "dem_compare/resistance/findings.h"

namespace asperity::report {

/// Answers in sentences.
std::string resistance_verdict(const ResistanceFindings& findings);
/// Figures and tables, with the sentences that they support.
std::string resistance_sections(const ResistanceFindings& findings);

/// A sentence of the answers for HTML: escaped, with its symbols.
std::string answer_html(const std::string& sentence);

}  // namespace asperity::report
