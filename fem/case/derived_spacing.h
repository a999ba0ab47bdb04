// The spacing of the interface's nodes that bodies, load, roughness and attraction ask for, and what a mesh
// leaves out of them.
#pragma once

#include <string>
#include <vector>

#include "fem/case/case_setup.h"

namespace asperity::fem {

/// Spacing where the case gives none [m]: twelve cells over the least contact radius, which keep Hertz within
/// 1 %; four over the shortest wave of either surface, with which the largest pressure reads 10 to 25 % too
/// small and real area is good to some 7 %; four over the thinner film, but for that no more than 24 over the
/// contact radius; three over the zone of attraction,
/// with which the pull-off force is some 4 % too large (output/discretisation_error.h). result.json states
/// the errors. `setup` holds Hertz' contact and the scales of roughness and attraction.
double derived_spacing(const CaseSetup& setup);

/// A derived mesh must fit a workstation: hours and some 3 GB. Throws InputError with the remedy.
void require_affordable(const CaseInput& input, const CaseSetup& setup);

/// Lines on what the mesh resolves: which waves of each rough body, and films and attraction where it does
/// not resolve them, with what it makes of them.
std::vector<std::string> resolution_texts(const CaseSetup& setup);

}  // namespace asperity::fem
