// Images of WSxM (.stp, .top), Nanotec: lines of text in sections "[Name]" up to the length that the third
// line states, then the numbers. Stored numbers span the Z Amplitude of [General Info]; X and Y Amplitude of
// [Control] are the sides. The first number stored is the lower right corner of the image, as Gwyddion shows
// it (SurfaceTopography turns it by half a turn). No real file was at hand: checked against files that the
// tests write from this description, which Gwyddion reads likewise.
#include <algorithm>
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

const std::string magic = "WSxM file copyright";
const std::string size_key = "Image header size:";
using Entries = std::map<std::string, std::string>;  ///< "Section/Key" to value

std::size_t header_size(const SourceFile& file) {
  const auto at = file.bytes.substr(0, 1000).find(size_key);
  const auto size =
      at == std::string::npos ? std::nullopt : number_with_unit(file.bytes.substr(at + size_key.size(), 30));
  if (!size || !(size->number > 0 && size->number <= static_cast<double>(file.bytes.size())))
    throw InputError(file.name() + " ends inside its WSxM header: it is cut off; copy or export it again");
  return static_cast<std::size_t>(size->number);
}

Entries entries_of(const std::string& header) {
  Entries entries;
  std::string section;
  for (std::size_t begin = 0; begin < header.size();) {
    const std::size_t end = std::min(header.find('\n', begin), header.size());
    const std::string line = trimmed_text(header.substr(begin, end - begin));
    begin = end + 1;
    const auto colon = line.find(':');
    if (line.size() > 2 && line.front() == '[' && line.back() == ']')
      section = line.substr(1, line.size() - 2);
    else if (colon != std::string::npos)
      entries[section + "/" + trimmed_text(line.substr(0, colon))] = trimmed_text(line.substr(colon + 1));
  }
  return entries;
}

/// A length such as "2.5 um"; empty if it is none.
std::optional<double> length_entry(const Entries& entries, const std::string& key) {
  const auto found = entries.find(key);
  const auto parts = found == entries.end() ? std::nullopt : number_with_unit(found->second);
  const auto unit = parts ? length_unit_factor(parts->unit) : std::nullopt;
  if (!unit || !std::isfinite(parts->number)) return std::nullopt;
  return parts->number * *unit;
}

std::int64_t count_entry(const SourceFile& file, const Entries& entries, const std::string& key) {
  const auto found = entries.find(key);
  const auto number = found == entries.end() ? std::nullopt : whole_number_text(found->second);
  constexpr double most = 1 << 20;
  if (!number || !(*number >= 1 && *number <= most))
    throw InputError(file.name() + " has no valid '" + key +
                     "' in its WSxM header, so it is damaged; export it again");
  return static_cast<std::int64_t>(*number);
}

NumberType number_type(const SourceFile& file, const Entries& entries) {
  const auto found = entries.find("General Info/Image Data Type");
  const std::string name = found == entries.end() ? "short" : lower_case(found->second);
  if (name == "short" || name == "integer") return NumberType::int16;
  if (name == "float") return NumberType::float32;
  if (name == "double") return NumberType::float64;
  throw InputError(file.name() + " stores numbers as '" + name +
                   "', which WSxM's format does not know; export it again");
}

StoredMap read(const SourceFile& file, const ReadOptions& options) {
  StoredGrid grid;
  grid.begin = header_size(file);
  const Entries entries = entries_of(file.bytes.substr(0, grid.begin));
  const auto amplitude = length_entry(entries, "General Info/Z Amplitude");
  const auto unit = entries.find("General Info/Z Amplitude");
  const auto parts = unit == entries.end() ? std::nullopt : number_with_unit(unit->second);
  choose_channel(file, {{"heights", parts ? plain_unit(parts->unit) : "", amplitude.has_value()}}, options);
  grid.columns = count_entry(file, entries, "General Info/Number of columns");
  grid.rows = count_entry(file, entries, "General Info/Number of rows");
  grid.type = number_type(file, entries);
  StoredMap map;
  map.nx = static_cast<int>(grid.columns);
  map.ny = static_cast<int>(grid.rows);
  map.heights = grid_numbers(file, grid);
  const auto [lowest, highest] = std::minmax_element(map.heights.begin(), map.heights.end());
  const double range = *highest - *lowest;
  const double step = range > 0 ? *amplitude / range : 0.0;  // 0: a flat map
  for (double& height : map.heights) height *= step;
  for (auto row = map.heights.begin(); row != map.heights.end(); row += map.nx)
    std::reverse(row, row + map.nx);
  map.lx = length_entry(entries, "Control/X Amplitude");
  map.ly = length_entry(entries, "Control/Y Amplitude");
  if (map.lx && !map.ly) map.ly = *map.lx * map.ny / map.nx;
  map.channel = "heights";
  map.scale = "heights over an amplitude of " + format_quantity(*amplitude, Dimension::length, 6);
  map.first_row = FirstRow::bottom;
  map.note = "rows stored from right to left";
  return map;
}

bool recognises(const SourceFile& file) { return file.bytes.compare(0, magic.size(), magic) == 0; }

}  // namespace

namespace formats {
TopographyFormat make_wsxm() {
  return {"WSxM (.stp, .top)", {".stp", ".top"}, "the line 'WSxM file copyright'", recognises, read};
}
}  // namespace formats

}  // namespace asperity
