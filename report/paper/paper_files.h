// The analysis of the paper as text, JSON and CSV.
#pragma once

#include <string>

#include "paper/analysis.h"

namespace asperity::report {

/// Sections as tables of text.
std::string paper_text(const PaperAnalysis& analysis);
/// Format "asperity-paper/1".
std::string paper_json(const PaperAnalysis& analysis);
/// Of one section's numbers.
std::string paper_csv(const PaperSection& section);

}  // namespace asperity::report
