// The page of one solved case.
#pragma once

#include <string>

#include "report/fields/section_figures.h"

namespace asperity::report {

/// folder: of the solve; painter draws its sections.
std::string case_report_html(const std::filesystem::path& folder, SectionPainter& painter);

/// version: of asperity, which solved it; empty where that is not known. "Written on 2026-11-21 by asperity
/// ..., from ...": below the title.
std::string subtitle_of(const std::filesystem::path& folder, const std::string& version);

}  // namespace asperity::report
