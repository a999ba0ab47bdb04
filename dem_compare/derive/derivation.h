// Everything a discrete element model needs of one parameter set, derived from its solved cases: `asperity
// derive`.
#pragma once

#include <string>
#include <vector>

#include "core/motion.h"
#include "dem_compare/cases/parameter_sets.h"
#include "dem_compare/derive/law_findings.h"
#include "dem_compare/derive/reduced_case.h"
#include "engines/parameters/contact_parameters.h"

namespace asperity {

struct Derivation {
  using Member = std::optional<EffectiveQuantity> ContactParameters::*;

  ContactParameters parameters;  ///< `derivation` holds cases, points, fits and odds; in words nothing yet
  ContactInputs inputs;          ///< what all cases agree in
  std::size_t cases = 0;
  std::vector<LawFindings> laws;  ///< of normal, sliding, torsion, rolling
  std::vector<std::pair<Member, std::vector<Origin>>> origins;

  /// The findings on the law of this motion.
  const LawFindings& law_of(Motion motion) const;
  /// Where a quantity comes from; empty for a new one.
  std::vector<Origin>& origin_of(Member member);
};

/// From all cases of one set.
Derivation derive_parameters(const ReducedSet& set);

/// Torsion and rolling of sets that differ by the particle's radius alone, their contacts taken for one law
/// with the same mu and h: radius and load part lambda = r from lambda = a better than loads do. Adds the
/// choice to the record of each of these sets, and writes its lambda where a set alone could not tell. Empty
/// for a single radius.
std::vector<LawFindings> compare_radii(const std::vector<ParameterSet>& sets,
                                       std::vector<Derivation>& derivations);

}  // namespace asperity
