// Tables of moving contacts.
#pragma once

#include <string>

#include "dem_compare/resistance/findings.h"

namespace asperity::report {

/// Of one motion, a row per contact and load.
std::string resistance_table(const MovingStudy& study, const MotionMode& mode);
/// Contacts that roll and spin at once; empty without any.
std::string rail_table(const MovingStudy& study);
/// Exponents of the moments in load and radius; empty without any.
std::string exponent_table(const ResistanceFindings& findings);
/// Changes per nm of RMS; empty without trends.
std::string trend_table(const ResistanceFindings& findings);
/// What switching yielding or adhesion off changes; empty without such pairs.
std::string contribution_table(const ResistanceFindings& findings);
/// Powers with which resistance goes with local friction, works of adhesion, yield stresses; empty without
/// such pairs.
std::string input_table(const ResistanceFindings& findings);
/// Beside the paper; empty where it measured nothing alike.
std::string measurement_table(const ResistanceFindings& findings);

}  // namespace asperity::report
