// The page of a study: its contacts side by side, with scatter over realisations, and the cases that are missing.
#pragma once

#include <string>

#include "report/section_figures.h"

namespace asperity::report {

std::string study_report_html(const std::filesystem::path& folder, SectionPainter& painter);

}  // namespace asperity::report
