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

/// By how much more than between smooth bodies the approach of a case with this generated substrate grows
/// between two forces [N], elastic and without adhesion, of twelve seeds [m]. Throws as half-spaces do.
std::vector<double> growth_on(const CaseInput& input, const RoughSubstrate& substrate, double from,
                              double to);

}  // namespace asperity
