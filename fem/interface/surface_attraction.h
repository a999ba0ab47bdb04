// The attraction of a case's surfaces as half-spaces take it.
#pragma once

#include <optional>

#include "core/case.h"
#include "half_space/adhesive_contact.h"

namespace asperity::fem {

/// Gap at which all but a share of the work of adhesion has been done [m]; 0 without adhesion. left: that
/// share [-].
double attraction_reach(const InterfaceInput& input, double left = 0.02);

/// None: no adhesion, or one that is told as a force (Interface/Attraction force). Throws InputError as
/// make_adhesion_laws does.
std::optional<half_space::Attraction> surface_attraction(const InterfaceInput& input);

}  // namespace asperity::fem
