// Maps of one solved case, seen along the axis of contact: roughness, pressure, what is open or closed,
// and what was added.
#pragma once

#include <string>

#include "results/solved_case.h"

namespace asperity::report {

/// Figures as HTML, or a note that says why there are none.
std::string roughness_figures(const SolvedCase& solved);
/// At the largest load, side by side: pressure, gap with the closed places, and the pressure over the
/// distance from the axis.
std::string contact_figures(const SolvedCase& solved);
/// Fields of the contact that files of their own have added, at the largest load.
std::string added_contact_figures(const SolvedCase& solved);

}  // namespace asperity::report
