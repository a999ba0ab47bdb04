// Lengths on the command line.
#pragma once

#include <string>

namespace asperity {

/// Length [m] above zero of the text passed to `option`; throws InputError naming the option.
double length_argument(const std::string& option, const std::string& text);

}  // namespace asperity
