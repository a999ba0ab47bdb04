// What the discretisation error of the cases, which result.json states of its numbers, makes of a quantity
// that is derived from them. SI units.
#pragma once

#include <vector>

#include "dem_compare/cases/parameter_sets.h"
#include "dem_compare/derive/derivation.h"

namespace asperity {

/// Standard deviation of a quantity by the mesh, in its unit; NaN where no case states what it rests on.
///
/// A stiffness, a modulus or a pull-off force is off by the mean of what its cases (`behind`, told apart by
/// their loads) are off by, as a part of it; E* by 3/2 of that of the approach (Hertz). Coefficient and
/// offset of a law of resistance are those of the law fitted again: with all loads off in the same direction,
/// as discretisation errors mostly are, or with each on its own, whichever moves them more.
double sd_by_mesh(const ParameterSet& set, const Derivation& derivation, const QuantityEntry& entry,
                  const std::vector<CaseNumber>& behind);

}  // namespace asperity
