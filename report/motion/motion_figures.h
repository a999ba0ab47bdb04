// What a sliding or spinning contact resists with, along its path, against the laws of smooth elastic bodies.
#pragma once

#include <string>

#include "report/page/chart.h"
#include "results/solved_case.h"

namespace asperity::report {

/// Lateral force over lateral displacement, and Cattaneo's, Mindlin's and Deresiewicz' law with Masing's
/// rule.
Chart friction_loop_chart(const SolvedCase& solved);
/// Torsion moment over angle, and Lubkin's law with Masing's rule.
Chart torsion_chart(const SolvedCase& solved);
Chart rolling_chart(const SolvedCase& solved);
/// Forces, and moments, of a program that combines motions, over its steps.
Chart program_forces_chart(const SolvedCase& solved);
Chart program_moments_chart(const SolvedCase& solved);

/// The figure of the motion with its explanation as HTML; empty for a contact that was only pressed.
std::string motion_figure(const SolvedCase& solved);

}  // namespace asperity::report
