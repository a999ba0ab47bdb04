// PicoView and PicoScan files of Molecular Imaging, Agilent and Keysight (.mi): lines of a key in 14
// characters and a value; "bufferLabel" begins a channel, "data" ends the header and says how the channels'
// integers follow one after the other. Height = stored / 2^(bits - 1) * bufferRange in bufferUnit; xLength
// and yLength are metres. The first row stored is the bottom of the image. Checked against a real file in the
// tests.
#include <cmath>
#include <map>

#include "core/error.h"
#include "core/quantity.h"
#include "surfaces/readers/channels.h"
#include "surfaces/readers/format.h"
#include "surfaces/readers/length_unit.h"
#include "surfaces/readers/stored_numbers.h"
#include "surfaces/readers/text_parts.h"

namespace asperity {
namespace {

constexpr std::size_t key_width = 14;
const std::string magic = "fileType      ";
using Section = std::map<std::string, std::string>;

struct MiHeader {
  Section file;
  std::vector<Section> buffers;  ///< one for each channel
  std::string data;              ///< how numbers are stored
  std::size_t data_begin = 0;
};

MiHeader header_of(const SourceFile& file) {
  MiHeader header;
  for (std::size_t begin = 0; begin < file.bytes.size();) {
    const std::size_t end = file.bytes.find('\n', begin);
    if (end == std::string::npos) break;
    const std::string line = file.bytes.substr(begin, end - begin);
    begin = end + 1;
    const std::string key = trimmed_text(line.substr(0, key_width));
    const std::string value = line.size() > key_width ? trimmed_text(line.substr(key_width)) : "";
    if (line.empty() || line[0] == ' ') continue;  // goes on with the line before
    if (key == "data") {
      header.data = value;
      header.data_begin = begin;
      return header;
    }
    if (key == "bufferLabel") header.buffers.emplace_back();
    (header.buffers.empty() ? header.file : header.buffers.back())[key] = value;
  }
  throw InputError(file.name() + " ends inside its PicoView header: it is cut off; copy or export it again");
}

std::string text_entry(const Section& section, const std::string& key) {
  const auto found = section.find(key);
  return found == section.end() ? "" : found->second;
}

double number_entry(const SourceFile& file, const Section& section, const std::string& key) {
  const auto number = whole_number_text(text_entry(section, key));
  constexpr double most = 1e12;
  if (!number || !(std::abs(*number) <= most))
    throw InputError(file.name() + " has no valid '" + key +
                     "' in its PicoView header, so it is damaged; export it again, for example as .gsf");
  return *number;
}

void check_kind(const SourceFile& file, const MiHeader& header) {
  if (text_entry(header.file, "fileType") != "Image")
    throw InputError(file.name() + " is a PicoView file of kind '" + text_entry(header.file, "fileType") +
                     "' and no image; pass a file of an image scan");
  if (header.data != "BINARY" && header.data != "BINARY_32" && !header.data.empty())
    throw InputError(
        file.name() + " stores its channels as '" + header.data +
        "', which is not read; save it from PicoView in binary form, or export .gsf from Gwyddion");
}

StoredMap read(const SourceFile& file, const ReadOptions& options) {
  const MiHeader header = header_of(file);
  check_kind(file, header);
  std::vector<ChannelEntry> channels;
  for (const auto& buffer : header.buffers) {
    const std::string unit = plain_unit(text_entry(buffer, "bufferUnit"));
    const bool is_ampere = unit == "A";
    const std::string retraced = text_entry(buffer, "trace") == "Retrace" ? " (Retrace)" : "";
    channels.push_back({text_entry(buffer, "bufferLabel") + retraced, unit,
                        !is_ampere && length_unit_factor(unit).has_value()});
  }
  if (channels.empty())
    throw InputError(file.name() + " is a PicoView file without images; pass a file of an image scan");
  const std::size_t chosen = choose_channel(file, channels, options);
  const Section& buffer = header.buffers[chosen];
  StoredGrid grid;
  grid.columns = static_cast<std::int64_t>(number_entry(file, header.file, "xPixels"));
  grid.rows = static_cast<std::int64_t>(number_entry(file, header.file, "yPixels"));
  grid.type = header.data == "BINARY_32" ? NumberType::int32 : NumberType::int16;
  grid.begin = header.data_begin;
  grid.begin += chosen * checked_grid_bytes(file, grid);
  const double steps = std::exp2(8.0 * static_cast<double>(bytes_of(grid.type)) - 1);
  const double range = number_entry(file, buffer, "bufferRange") * *length_unit_factor(channels[chosen].unit);
  StoredMap map;
  map.nx = static_cast<int>(grid.columns);
  map.ny = static_cast<int>(grid.rows);
  map.heights = grid_numbers(file, grid);
  for (double& height : map.heights) height *= range / steps;
  map.lx = number_entry(file, header.file, "xLength");
  map.ly = number_entry(file, header.file, "yLength");
  map.channel = channels[chosen].name;
  map.scale = "heights in steps of " + format_quantity(range / steps, Dimension::length, 6);
  map.first_row = FirstRow::bottom;
  map.note = "channel " + std::to_string(chosen) + " of " + std::to_string(channels.size());
  return map;
}

bool recognises(const SourceFile& file) { return file.bytes.compare(0, magic.size(), magic) == 0; }

}  // namespace

namespace formats {
TopographyFormat make_picoview() {
  return {"PicoView (.mi)", {".mi"}, "the line 'fileType'", recognises, read};
}
}  // namespace formats

}  // namespace asperity
