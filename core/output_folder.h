// Folders for results.
#pragma once

#include <filesystem>

namespace asperity {

/// Makes a folder and those above it. Throws InputError if something else has that name, WorkError if it
/// cannot be made.
void make_folder(const std::filesystem::path& folder);

}  // namespace asperity
