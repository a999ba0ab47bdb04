// A law as it is written on the command line: "jkr, work_of_adhesion = 50 mJ/m^2".
#pragma once

#include <string>

#include "dem_compare/laws/law_registry.h"

namespace asperity {

/// A law and the values that were written with it.
struct WrittenLaw {
  LawDescription description;
  LawValues values;  ///< those that were written
};

/// Name, then parameters after commas: a number with a unit of its dimension (a plain number is SI), or the
/// name of a choice. Throws InputError naming what is wrong and what was meant.
WrittenLaw parse_law(const std::string& text);

}  // namespace asperity
