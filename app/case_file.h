// Reads a case file into CaseInput and refuses, in one sentence with file and line, what cannot be meant.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/parameter_file.h"

namespace asperity {

/// Case of a .prm or JSON file after overrides "Section/Entry=value". Throws InputError.
CaseInput read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// Case of settings already read from `file` (for messages, and the folder topography files are looked for
/// in).
/// Throws InputError naming file and line.
CaseInput case_from_settings(const Settings& settings, const std::filesystem::path& file);

/// Every entry of a case in the order of the manual, defaults written out and files of topographies named in
/// full, so that it can be read from any folder. Expects settings that case_from_settings accepts.
Settings complete_settings(const Settings& settings, const std::filesystem::path& file);

/// The scan with its file named in full, as seen from `folder`.
ScanParameters with_absolute_file(ScanParameters scan, const std::filesystem::path& folder);

/// Runs `work`; a scan that is refused in it (unreadable, too small) is refused with the line of the case
/// file that names it.
/// Throws InputError then.
void naming_lines_of_scans(const Settings& settings, const CaseInput& input,
                           const std::function<void()>& work);

/// Says on standard error, once for each, which entries were written under the name of an earlier version.
void warn_of_former_names(const Settings& settings);

/// Refuses a setting whose name is no entry of a case file: names the nearest right one.
void check_entry_exists(const Setting& setting);

}  // namespace asperity
