// Image Metrology's files of SPIP (.bcr, .bcrf): lines "key = value" in characters of 8 or 16 bit up to
// headersize (2048 characters without it), then 16-bit integers ("fileformat = bcrstm") or 32-bit floats
// ("bcrf"), little-endian where intelmode is not 0, top row first. Integers times bit2nm, and floats, are in
// zunit, xlength and ylength in xunit and yunit, nanometres without one. Where voidpixels counts any, 32767
// or 1.7e38 and more was not measured (Image Metrology, SPIP reference guide, "BCR-STM file format"). No real
// file was at hand: checked against files that the tests write from this description.
#include <cmath>
#include <limits>
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

const std::string magic = "fileformat = bcr";
using Entries = std::map<std::string, std::string>;

Entries entries_of(const std::string& header) {
  Entries entries;
  for (std::size_t begin = 0; begin < header.size();) {
    const std::size_t end = std::min(header.find('\n', begin), header.size());
    const std::string line = trimmed_text(header.substr(begin, end - begin));
    begin = end + 1;
    const auto equals = line.find('=');
    if (equals != std::string::npos && line[0] != '%' && line[0] != '#')
      entries[trimmed_text(line.substr(0, equals))] = trimmed_text(line.substr(equals + 1));
  }
  return entries;
}

std::optional<double> number_entry(const Entries& entries, const std::string& key) {
  const auto found = entries.find(key);
  return found == entries.end() ? std::nullopt : whole_number_text(found->second);
}

std::int64_t count_entry(const SourceFile& file, const Entries& entries, const std::string& key) {
  const auto number = number_entry(entries, key);
  constexpr double most = 1 << 20;
  if (!number || !(*number >= 1 && *number <= most))
    throw InputError(file.name() + " has no valid '" + key +
                     "' in its SPIP header, so it is damaged; export it again, for example as .gsf");
  return static_cast<std::int64_t>(*number);
}

std::string unit_entry(const Entries& entries, const std::string& key) {
  const auto found = entries.find(key);
  return found == entries.end() || found->second.empty() ? "nm" : plain_unit(found->second);
}

std::optional<double> side(const Entries& entries, const std::string& key, const std::string& unit_key) {
  const auto number = number_entry(entries, key);
  const auto unit = length_unit_factor(unit_entry(entries, unit_key));
  return number && unit ? std::optional<double>(*number * *unit) : std::nullopt;
}

/// Characters of 16 bit, with or without a mark of their byte order before them.
struct Encoding {
  std::size_t begin = 0, character = 1;  ///< [bytes]
};

Encoding encoding_of(const SourceFile& file) {
  Encoding encoding;
  if (file.bytes.compare(0, 2, "\xFF\xFE") == 0) encoding.begin = 2;
  if (file.bytes.size() > encoding.begin + 1 && file.bytes[encoding.begin + 1] == '\0')
    encoding.character = 2;
  return encoding;
}

/// The first `characters` of the header in bytes of one character each.
std::string header_text(const SourceFile& file, std::size_t characters) {
  const Encoding encoding = encoding_of(file);
  std::string text;
  for (std::size_t i = 0; i < characters; ++i) {
    const std::size_t at = encoding.begin + i * encoding.character;
    if (at >= file.bytes.size()) break;
    text += file.bytes[at];
  }
  return text;
}

bool is_void(double stored, NumberType type) {
  constexpr double void_integer = 32767, least_void_float = 1.7e38;
  return type == NumberType::int16 ? stored == void_integer : stored >= least_void_float;
}

/// Where and how the heights lie, from a header of which they set the end.
StoredGrid stored_grid(const SourceFile& file, const Entries& entries, std::size_t characters) {
  const auto format = entries.find("fileformat");
  StoredGrid grid;
  grid.begin = characters * encoding_of(file).character;
  const bool floats = format != entries.end() && format->second.rfind("bcrf", 0) == 0;
  grid.type = floats ? NumberType::float32 : NumberType::int16;
  grid.order = number_entry(entries, "intelmode").value_or(1) != 0 ? ByteOrder::little : ByteOrder::big;
  grid.columns = count_entry(file, entries, "xpixels");
  grid.rows = count_entry(file, entries, "ypixels");
  return grid;
}

StoredMap read(const SourceFile& file, const ReadOptions& options) {
  constexpr std::size_t usual_header = 2048, longest_header = 1 << 16;
  const double size =
      number_entry(entries_of(header_text(file, usual_header)), "headersize").value_or(usual_header);
  if (!(size >= 0 && size <= longest_header))
    throw InputError(file.name() + " has no valid 'headersize' in its SPIP header; export it again");
  const auto characters = static_cast<std::size_t>(size);
  const Entries entries = entries_of(header_text(file, characters));
  const StoredGrid grid = stored_grid(file, entries, characters);
  const std::string unit_name = unit_entry(entries, "zunit");
  const auto unit = length_unit_factor(unit_name);
  choose_channel(file, {{"heights", unit_name, unit.has_value()}}, options);
  const double per_bit = number_entry(entries, "bit2nm").value_or(1.0);
  if (grid.type == NumberType::float32 && per_bit != 1.0)
    throw InputError(
        file.name() +
        " has a scale 'bit2nm' of its own for numbers that have a unit already; export it from SPIP "
        "as .bcr, or as .gsf from Gwyddion");
  const double step = per_bit * *unit;
  StoredMap map;
  map.nx = static_cast<int>(grid.columns);
  map.ny = static_cast<int>(grid.rows);
  map.heights = grid_numbers(file, grid);
  const bool has_voids = number_entry(entries, "voidpixels").value_or(0) != 0;
  for (double& height : map.heights)
    height =
        has_voids && is_void(height, grid.type) ? std::numeric_limits<double>::quiet_NaN() : height * step;
  map.lx = side(entries, "xlength", "xunit");
  map.ly = side(entries, "ylength", "yunit");
  map.channel = "heights";
  map.scale = "heights in steps of " + format_quantity(step, Dimension::length, 6);
  map.first_row = FirstRow::top;
  return map;
}

bool recognises(const SourceFile& file) { return header_text(file, magic.size()) == magic; }

}  // namespace

namespace formats {
TopographyFormat make_image_metrology() {
  return {"SPIP (.bcr, .bcrf)", {".bcr", ".bcrf"}, "the line 'fileformat = bcrf'", recognises, read};
}
}  // namespace formats

}  // namespace asperity
