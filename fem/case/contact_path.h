// Where the contact goes on both bodies, and whether their finely meshed regions hold it.
#pragma once

#include <string>

#include "fem/case/case_setup.h"

namespace asperity::fem {

/// A longest length [m] for a message, in three digits that are no longer than it: what is advised is not
/// refused.
std::string at_most(double length);

/// Widens the fine regions of the setup to those that the contact goes over in rolling or sliding along
/// Experiment/Distance, of regions of half width `region` [m] at rest. Throws InputError where it leaves
/// them.
void fit_to_rolling(const CaseInput& input, meshing::BodySizes& sizes, double region);
void fit_to_sliding(const CaseInput& input, meshing::BodySizes& sizes);

/// The same for a program, which goes over both bodies; needs the setup's motion. Throws InputError where it
/// leaves the fine regions.
void fit_to_program(const CaseInput& input, CaseSetup& setup);

}  // namespace asperity::fem
