// Height maps that people bring, read into a Topography with units, orientation, scale and channel said back.
//
// Orientation: every reader returns pixel rows from the bottom of the image to its top (y up, x to the
// right), as a viewer such as Gwyddion shows the file. Formats that store the top row first are turned over,
// and `source` says so.
#pragma once

#include <filesystem>
#include <string>

#include "core/topography_spec.h"
#include "surfaces/topography.h"

namespace asperity {

/// Reads a file of any kind in surfaces/readers/formats/, recognised by what it holds and not by
/// its name. Throws InputError with one sentence that says what is wrong with the file and what to pass
/// instead.
Topography read_topography(const std::filesystem::path& path, const ReadOptions& options = {});

/// One line: pixels, size, range of heights, channel, missing points, and from what file, scale and
/// orientation.
std::string describe(const Topography& map);

/// Writes a Gwyddion Simple Field (32-bit heights in metres, NaN where missing), whole or not at all.
void write_gsf(const std::filesystem::path& path, const Topography& map);

}  // namespace asperity
