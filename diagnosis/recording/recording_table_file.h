// One CSV of a recording: columns named with their unit, numbers to SI.
#pragma once

#include <filesystem>

#include "diagnosis/recording/recording.h"

namespace asperity {

/// Fills columns and segments of `table` from the file. Throws InputError naming file and line.
void read_table_file(const std::filesystem::path& path, RecordingTable& table);
/// Its channels in the order of a file: where a row belongs first, then what was measured.
std::vector<std::string> channels_in_order(const RecordingTable& table);
/// "normal_force [N]": a channel as a column's heading, in its SI unit.
std::string heading_of(const std::string& channel);
/// A value as a cell; empty: missing.
std::string cell_of(double value);
/// The table as CSV in SI units.
std::string format_table_file(const RecordingTable& table);

}  // namespace asperity
