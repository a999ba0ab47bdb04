// Elasto-plastic, adhesive normal laws of a parameter set, from its cases that yielded and were unloaded:
// those at the largest load are fitted (elastoplastic_fit.h), those at smaller loads judge the fit. SI units.
#pragma once

#include "dem_compare/derive/derivation.h"

namespace asperity {

/// Sets unloading_modulus and yield_pressure (Thornton & Ning) and luding_*, and adds what was found; nothing
/// where no case has yielded.
void derive_elastoplastic(const ReducedCases& cases, Derivation& derivation, LawFindings& findings);

}  // namespace asperity
