// The header of NanoScope files, binary ones and text exports alike: lines "\Key: value" in sections
// "\*Name".
#pragma once

#include <map>
#include <string>
#include <vector>

#include "surfaces/readers/format.h"

namespace asperity {

using NanoscopeSection = std::map<std::string, std::string>;  ///< lower-case key to value

/// What the sections say.
struct NanoscopeHeader {
  NanoscopeSection file_list;
  NanoscopeSection instrument;           ///< sensitivities: scanner, scan and other lists together
  std::vector<NanoscopeSection> images;  ///< one for each channel
};

/// Throws InputError where the file ends inside its header.
NanoscopeHeader nanoscope_header(const SourceFile& file);

/// "Height Sensor" out of S [ZSensor] "Height Sensor".
std::string nanoscope_image_name(const NanoscopeSection& section);

/// The size of the image's scan, else that of the whole scan; none where the header does not say.
void read_nanoscope_size(const NanoscopeHeader& header, const NanoscopeSection& image, StoredMap& map);

/// A table of an export as text, behind a line "\Exported image units: nm".
struct NanoscopeExport {
  std::string unit;
  std::size_t begin = 0, end = 0;  ///< bytes of its rows
};

/// All of them; none in a binary file.
std::vector<NanoscopeExport> nanoscope_exports(const SourceFile& file);

}  // namespace asperity
