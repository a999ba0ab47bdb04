// Everything a discrete element model needs of one parameter set, derived from its solved cases: `asperity
// derive`.
#pragma once

#include <string>
#include <vector>

#include "core/motion.h"
#include "dem_compare/cases/parameter_sets.h"
#include "dem_compare/derive/law_report.h"
#include "engines/parameters/contact_parameters.h"

namespace asperity {

struct Derivation {
  ContactParameters parameters;  ///< `derivation` holds cases, points, fits and odds
  std::vector<LawReport> laws;   ///< of normal, sliding, torsion, rolling
  /// The report on the law of this motion.
  const LawReport& law_of(Motion motion) const;
  std::string heading;  ///< bodies and cases in words
};

/// From all cases of one set.
Derivation derive_parameters(const ParameterSet& set);

/// Torsion and rolling of sets that differ by the particle's radius alone, their contacts taken for one law
/// with the same mu and h: radius and load part lambda = r from lambda = a better than loads do. Adds the
/// choice to the record of each of these sets, and writes its lambda where a set alone could not tell. Empty
/// for a single radius.
std::vector<LawReport> compare_radii(const std::vector<ParameterSet>& sets,
                                     std::vector<Derivation>& derivations);

/// For people: each law with its numbers, then what could not be told.
std::string to_text(const Derivation& derivation);
std::string to_text(const LawReport& report);

}  // namespace asperity
