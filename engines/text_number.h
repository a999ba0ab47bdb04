// Numbers in the inputs that are written for engines.
// In the unit that the engine asks for.
#pragma once

#include <cmath>
#include <string>

#include "core/error.h"
#include "core/printed.h"

namespace asperity {

/// To 12 significant digits. Throws InputError for what is no number, which an engine would take for a name.
/// The number is in the unit that the engine asks for.
inline std::string text_number(double value) {
  if (!std::isfinite(value))
    throw InputError(
        "a number for the engine is beyond what a computer holds; look for a quantity that is too large or "
        "too small in the record");
  return printed("%.12g", value);
}

}  // namespace asperity
