// How wide a smooth contact of a case is.
#pragma once

#include "fem/case/case_setup.h"

namespace asperity::fem {

/// Radius of a smooth elastic contact of bodies with films at the largest load or approach [m].
double filmed_contact_radius(const CaseInput& input, const CaseSetup& setup);

/// Radius that a contact has at least [m]: the lesser of Hertz' and that of bodies with films, or as far as
/// attraction of a long range draws bare ones (Derjaguin, Muller & Toporov 1975) where that is more; of rough
/// bodies, of which single asperities touch, no further than their shortest wave.
double least_contact_radius(const CaseInput& input, const CaseSetup& setup);

/// Radius that a smooth contact has at most [m]: Hertz', or where a body yields that of a mean pressure of
/// two yield stresses. A sphere that is indented until all below it flows carries 2.84 of them, less where
/// the contact is wide (Jackson & Green 2005). Under a given approach its contact is 1.49 times Hertz' at 650
/// approaches of first yield, where the edge piles up (axisymmetric finite elements of another program).
double largest_contact_radius(const CaseInput& input, const CaseSetup& setup);

/// Radius to which attraction of a range of nothing draws a smooth contact [m]: the most that it can
/// (Johnson, Kendall & Roberts 1971). 0: nothing attracts.
double attracted_radius(const CaseInput& input, const CaseSetup& setup);

}  // namespace asperity::fem
