// Surfaces of a study that half-spaces alone have solved (`asperity study --preview`), as numbers beside the
// solved cases: corrected by how much finite elements differ from half-spaces on the surfaces that both
// solved (core/double_sampling.h). They tell the
// mean over surfaces, to which a few solved cases are too few.
#pragma once

#include <string>
#include <vector>

#include "dem_compare/cases/case_numbers.h"
#include "dem_compare/cases/parameter_sets.h"

namespace asperity {

/// A number of a solved case.
struct SolvedNumber {
  const SolvedCase* solved = nullptr;
  double load = 0;           ///< [N]
  double value = 0, sd = 0;  ///< of the case, in the number's unit; sd NaN where it is not known
};

/// Number of a preview that goes with E* of the surface: from its approaches at the smallest and the largest
/// load of the study.
inline constexpr const char* modulus_by_half_spaces = "reduced_modulus";

/// Surfaces beside the solved cases, none where fewer than two of a load were solved by both. name: of the
/// number in previews.json. The sd of each is that of the solved cases and of the ratio, which all share,
/// widened by Student's factor of the surfaces solved by both.
/// Throws InputError for a previews.json that cannot be read or is of other inputs than the cases beside it.
std::vector<CaseNumber> by_half_spaces(const std::vector<SolvedNumber>& solved, const std::string& name);

}  // namespace asperity
