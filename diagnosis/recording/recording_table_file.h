// One CSV of a recording: columns named with their unit, numbers to SI.
#pragma once

#include <filesystem>

#include "diagnosis/recording/recording.h"

namespace asperity {

/// Fills columns and segments of `table` from the file. Throws InputError naming file and line.
void read_table_file(const std::filesystem::path& path, RecordingTable& table);
/// The table as CSV in SI units.
std::string format_table_file(const RecordingTable& table);

}  // namespace asperity
