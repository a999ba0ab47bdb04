// Segments of a run whose table names none, from where its driven motion turns and rests.
#pragma once

#include <string>
#include <vector>

namespace asperity {

/// Names of the segments ("load", "unload" in a normal experiment, "forward", "backward" otherwise, "hold")
/// of the values that the driven channel was given.
std::vector<std::string> inferred_segments(const std::vector<double>& given, bool normal);

}  // namespace asperity
