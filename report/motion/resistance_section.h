// The part of a study's page on moving contacts: dissipation in sliding, rolling and torsion by
// mechanism, and what that says on the paper's open questions.
#pragma once

#include <string>

#include "dem_compare/resistance/findings.h"

namespace asperity::report {

/// Answers in sentences.
std::string resistance_verdict(const ResistanceFindings& findings);
/// Figures and tables, with the sentences that they support.
std::string resistance_sections(const ResistanceFindings& findings);

}  // namespace asperity::report
