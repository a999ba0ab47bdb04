// Which cases must still be solved before an engine has all it can use of a contact.
#pragma once

#include <string>
#include <vector>

#include "engines/parameters/contact_parameters.h"

namespace asperity {

/// An experiment that tells quantities a record lacks.
struct NeededCase {
  std::string experiment;               ///< Experiment/Type of the case: "sliding"
  std::vector<std::string> quantities;  ///< keys that it tells
  bool is_required = false;             ///< no engine's input without it; else that resistance is left out
};

/// Sliding first, then rolling and torsion; empty where nothing is missing.
std::vector<NeededCase> needed_cases(const ContactParameters& parameters);

/// "rolling_friction and rolling_stiffness (a case with Experiment/Type = rolling)".
std::string to_text(const NeededCase& needed);

/// For people, behind what `derive` found: what an engine still needs, case by case, and how to go on; empty
/// where nothing is missing.
std::string needed_cases_text(const ContactParameters& parameters);

}  // namespace asperity
