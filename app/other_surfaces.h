// A case on other realisations of its generated surfaces, by half-spaces.
#pragma once

#include <vector>

#include "core/case.h"
#include "diagnosis/forward/forward_model.h"

namespace asperity {

/// How the approach changes on sixteen other seeds, under six forces up to `largest_force` [N]: elastic, on
/// cells of a sixth of the shortest wave. Empty where no surface is generated. Throws InputError and
/// WorkError as half_space::contact_of_case does.
std::vector<SurfaceChange> changes_on_other_surfaces(CaseInput input, double largest_force);

}  // namespace asperity
