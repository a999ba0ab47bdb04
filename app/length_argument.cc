#include "app/length_argument.h"

#include <cmath>

#include "core/error.h"
#include "core/quantity.h"

namespace asperity {

double length_argument(const std::string& option, const std::string& text) {
  try {
    const double value = parse_quantity(text, Dimension::length);
    if (value > 0 && std::isfinite(value)) return value;
  } catch (const InputError& error) {
    throw InputError(option + ": " + error.what());
  }
  throw InputError(option + " must be a length above 0, such as \"2.5 um\"; it is '" + text + "'");
}

}  // namespace asperity
