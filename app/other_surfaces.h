// A case on other realisations of its generated surfaces, by half-spaces.
#pragma once

#include "core/case.h"
#include "diagnosis/forward/forward_model.h"

namespace asperity {

/// How the approach changes on 32 other seeds, under twelve forces from 0.2 % of
/// `largest_force` on, where an instrument sees the contact, up to it [N]: elastic, on
/// cells of a sixth of the shortest wave. Empty where no surface is generated. Throws InputError and
/// WorkError as half_space::contact_of_case does.
OtherSurfaces other_surfaces_of(const CaseInput& input, double largest_force);

}  // namespace asperity
