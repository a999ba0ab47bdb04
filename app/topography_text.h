// The text of a Topography entry: "smooth", a file, or "generated(rms=1.5 nm, hurst=0.8, ..., seed=3)".
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace asperity {

bool is_smooth(const std::string& topography);
bool is_generated(const std::string& topography);

/// Arguments of generated(...) in their order. Throws InputError naming a wrong name, unit or value.
std::vector<std::pair<std::string, std::string>> generated_arguments(const std::string& topography);

/// Seed of generated(...); 1 if it is not given.
int generated_seed(const std::string& topography);

/// The same surface statistics with another seed.
std::string with_seed(const std::string& topography, int seed);

/// Texts between separators outside of parentheses, blanks removed: "a(1, 2), b" gives "a(1, 2)" and "b".
std::vector<std::string> split_outside_parentheses(const std::string& text, char separator);

}  // namespace asperity
