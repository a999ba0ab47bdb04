// A case solved in a process of its own, as `asperity solve` would, so that its peak memory is its own.
#pragma once

#include <filesystem>

#include "core/case.h"

namespace asperity {

/// Solves with so many threads, progress on the terminal; returns the largest resident set [B]. Throws
/// WorkError.
double solve_in_child(const CaseInput& input, const std::filesystem::path& folder, int threads);

}  // namespace asperity
