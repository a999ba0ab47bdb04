// Figures of moving contacts: resistance over load, over RMS, and by mechanism.
#pragma once

#include <string>
#include <vector>

#include "dem_compare/resistance/findings.h"
#include "report/page/chart.h"

namespace asperity::report {

/// What a resistance is divided by in a figure.
enum class ResistanceUnit {
  load,      ///< P: sliding
  contact,   ///< P a, a of Hertz
  particle,  ///< P r
  coulomb    ///< 3 pi/16 mu P a: torsion of smooth Coulomb bodies
};
/// "M / (P a)"
std::string unit_label(const MotionMode& mode, ResistanceUnit unit);

/// One series per contact; bars are standard deviations.
Chart resistance_over_load(const MovingStudy& study, const MotionMode& mode, ResistanceUnit unit);
/// One series per load, with the paper's points where it measured.
Chart resistance_over_rms(const RoughnessTrend& trend, const AgainstPublished& published);
/// What each mechanism takes over RMS, at one load of the trend.
Chart parts_over_rms(const RoughnessTrend& trend, const TrendAtLoad& at);

}  // namespace asperity::report
