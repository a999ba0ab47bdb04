// A case whose body relaxes, as the simulation of a recording: it is solved as it is right after fast
// loading, and relaxes around that solution.
#pragma once

#include "core/case.h"
#include "core/parameter_file.h"
#include "core/relaxing_modulus.h"

namespace asperity {

/// Of its shear modulus; a share of 0: it does not relax.
RelaxingPart relaxation_of(const BodyInput& body);

/// Sets the entries of the bodies that relax to none.
void leave_out_relaxation(Settings& settings, const CaseInput& input);

}  // namespace asperity
