// Everything a discrete element model needs of one parameter set, derived from its solved cases: `asperity derive`.
#pragma once

#include <string>
#include <vector>

#include "dem_compare/contact_parameters.h"
#include "dem_compare/derive/law_report.h"
#include "dem_compare/derive/parameter_sets.h"

namespace asperity {

struct Derivation {
  ContactParameters parameters;  ///< `derivation` holds cases, points, fits and odds
  std::vector<LawReport> laws;
  std::string heading;           ///< bodies and cases in words
};

Derivation derive_parameters(const ParameterSet& set);

/// For people: each law with its numbers, then what could not be told.
std::string to_text(const Derivation& derivation);

}  // namespace asperity
