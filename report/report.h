// asperity report: one self-contained report.html for a solved case or a study.
#pragma once

#include <filesystem>

namespace asperity {

/// Writes report.html into a folder of `asperity solve` or `asperity study`, finished or not.
/// Throws InputError if the folder is neither.
void write_report(const std::filesystem::path& directory);

}  // namespace asperity
