// A text matrix of heights, top row of the image first, under a header that names size and units: Gwyddion's
// ASCII export ("# Channel: Height", "# Width: 2.5 µm", "# Height: 2.5 µm", "# Value units: nm", also in
// German), or lines such as "size: 2.5 um x 2.5 um", "pixel size: 4.9 nm", "unit: nm". Without a unit heights
// are metres, as Gwyddion writes them, if that is plausible.

#include "core/error.h"
#include "surfaces/readers/channels.h"
#include "surfaces/readers/length_unit.h"
#include "surfaces/readers/text_names.h"
#include "surfaces/readers/text_parts.h"
#include "surfaces/readers/text_table.h"

namespace asperity {
namespace {

/// Length of a header value "2.5 um"; without a unit of its own in the header's lateral unit, else metres.
std::optional<double> length_of(const std::string& value, const TextTable& table, StoredMap& map) {
  const auto parts = number_with_unit(value);
  if (!parts) return std::nullopt;
  const std::string header_unit = table.find(text_names::lateral_unit);
  const std::string unit = parts->unit.empty() ? header_unit : parts->unit;
  map.lateral_unit_assumed = map.lateral_unit_assumed || unit.empty();
  const auto factor = unit.empty() ? std::optional<double>(1.0) : length_unit_factor(unit);
  return factor ? std::optional<double>(parts->number * *factor) : std::nullopt;
}

/// "2.5 um x 2 um", "2.5 x 2 um" or "2.5 um".
void read_size(const std::string& value, const TextTable& table, StoredMap& map) {
  const auto cross = value.find(" x ");
  if (cross == std::string::npos) {
    map.lx = length_of(value, table, map);
    return;
  }
  const std::string first = value.substr(0, cross), second = value.substr(cross + 3);
  map.ly = length_of(second, table, map);
  const auto first_parts = number_with_unit(first), second_parts = number_with_unit(second);
  const bool unit_shared = first_parts && second_parts && first_parts->unit.empty();
  map.lx = length_of(unit_shared ? first + " " + second_parts->unit : first, table, map);
}

void read_lateral_scale(const TextTable& table, StoredMap& map) {
  map.lx = length_of(table.find(text_names::width), table, map);
  map.ly = length_of(table.find(text_names::height), table, map);
  if (!map.lx && !map.ly) read_size(table.find(text_names::size), table, map);
  if (!map.lx && !map.ly)
    if (const auto pixel = length_of(table.find(text_names::pixel), table, map)) map.lx = *pixel * map.nx;
  if (map.lx && !map.ly) map.ly = *map.lx * map.ny / map.nx;
  if (map.ly && !map.lx) map.lx = *map.ly * map.nx / map.ny;
  if (map.lateral_unit_assumed)
    map.note += std::string(map.note.empty() ? "" : "; ") + "no unit of size given, metres taken";
}

StoredMap read(const SourceFile& file, const ReadOptions& options) {
  TextTable table = text_table(file);
  if (table.columns == 2 && table.rows > 2)
    throw InputError(file.name() + " has two columns, so it is a profile and not a map; pass a height map");
  StoredMap map;
  map.nx = static_cast<int>(table.columns);
  map.ny = static_cast<int>(table.rows);
  const double unit = text_height_unit(file, table, options, map);
  map.channel = table.find(text_names::channel);
  choose_channel(file, {{map.channel, "", true}}, options);
  map.heights = std::move(table.values);
  for (double& height : map.heights) height *= unit;
  read_lateral_scale(table, map);
  map.first_row = FirstRow::top;
  return map;
}

bool recognises(const SourceFile& file) { return text_beginning(file).columns > 0; }

}  // namespace

namespace formats {
TopographyFormat make_text_matrix() {
  return {"text matrix (.txt, .asc)",
          {".txt", ".asc", ".csv", ".dat"},
          "a header and rows of numbers",
          recognises,
          read,
          Tried::any_text};
}
}  // namespace formats

}  // namespace asperity
