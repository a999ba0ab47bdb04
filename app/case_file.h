// Reads a case file into CaseInput and refuses, in one sentence with file and line, what cannot be meant.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/parameter_file.h"
#include "core/case.h"

namespace asperity {

/// Case of a .prm or JSON file after overrides "Section/Entry=value". Throws InputError.
CaseInput read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// Case of settings already read from `file` (for messages, and the folder topography files are looked for in).
CaseInput case_from_settings(const Settings& settings, const std::filesystem::path& file);

/// Every entry of a case in the order of the manual, defaults written out and files of topographies named in full, so
/// that it can be read from any folder. Expects settings that case_from_settings accepts.
Settings complete_settings(const Settings& settings, const std::filesystem::path& file);

/// Refuses a setting whose name is no entry of a case file: names the nearest right one.
void check_entry_exists(const Setting& setting);

}  // namespace asperity
