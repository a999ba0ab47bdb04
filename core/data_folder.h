// Files that come with the program: beside an installed one, else those of the source it was built from.
#pragma once

#include <filesystem>

namespace asperity {

/// PREFIX/share/asperity/`name` of the program that runs, if that is there; else `in_source`.
std::filesystem::path data_folder(const std::filesystem::path& name, const std::filesystem::path& in_source);

}  // namespace asperity
