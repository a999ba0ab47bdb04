// What labels of cases have in common: the name of what they are cases of.
#pragma once

#include <string>
#include <vector>

namespace asperity {

/// What labels such as "300 uN, untreated 0.3 nm" have in common, part by part ("1.5 nm" of "sliding, 1.5 nm"
/// and "rolling, 1.5 nm 200 uN"); the first where that is nothing.
std::string common_label(const std::vector<std::string>& labels);

}  // namespace asperity
