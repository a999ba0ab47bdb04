// The findings as files: one row per contact, motion and load, and everything with the answers as JSON. SI
// units.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "dem_compare/resistance/findings.h"

namespace asperity::report {

/// The rows of a study.
std::string resistance_csv(const MovingStudy& study);
/// Format "asperity-resistance/1".
nlohmann::ordered_json resistance_json(const ResistanceFindings& findings);

}  // namespace asperity::report
