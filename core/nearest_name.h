// The name somebody probably meant: edit distance for the messages about unknown names.
#pragma once

#include <string>
#include <vector>

namespace asperity {

/// Edits (insert, delete, replace, swap of neighbours; upper and lower case alike) that turn one word into
/// the other: optimal string alignment, Damerau 1964.
int edit_distance(const std::string& a, const std::string& b);

/// The nearest of `names`; "" if none is near enough to be meant.
std::string nearest_name(const std::string& written, const std::vector<std::string>& names);

/// End of a message about an unknown name: "did you mean 'name'?", or `otherwise` where none is near.
std::string did_you_mean(const std::string& written, const std::vector<std::string>& names,
                         const std::string& otherwise);
/// The same, "there are a, b, c" where none is near.
std::string did_you_mean(const std::string& written, const std::vector<std::string>& names);

}  // namespace asperity
