// The folder of a solved case remembers its input: case.prm, complete, beside the results.
#pragma once

#include <filesystem>

#include "core/parameter_file.h"

namespace asperity {

/// Writes case.prm into `folder`. With `resume`, refuses a folder whose case.prm says another case (how it is solved
/// and what is written may differ). `file` is where the settings come from; it may be that case.prm itself.
void remember_case(const Settings& settings, const std::filesystem::path& file, const std::filesystem::path& folder,
                   bool resume);

}  // namespace asperity
