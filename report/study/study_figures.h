// Figures of a study: everything against load, against RMS, against the spectrum; and each contact in
// pictures.
#pragma once

#include <string>
#include <vector>

#include "report/curves/study_curves.h"
#include "report/fields/section_figures.h"

namespace asperity::report {

/// Everything against load.
std::string load_figures(const std::vector<StudyCurve>& curves);
/// Empty where the study does not vary RMS or spectrum.
std::string roughness_dependence_figures(const std::vector<StudyCurve>& curves);
std::string gallery(const std::vector<StudyCurve>& curves, SectionPainter& painter);

}  // namespace asperity::report
