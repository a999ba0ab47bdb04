// Exports of NanoScope software as text: the header of a NanoScope file, lines in quotes or not, then for
// each channel "\Exported image units: nm" and a table of its rows in that unit. The first row is the bottom
// of the image, as in the binary file and as Gwyddion takes it. No real file was at hand: checked only
// against files that the tests write from this description.
#include "core/error.h"
#include "surfaces/readers/channels.h"
#include "surfaces/readers/format.h"
#include "surfaces/readers/length_unit.h"
#include "surfaces/readers/nanoscope_header.h"
#include "surfaces/readers/text_parts.h"
#include "surfaces/readers/text_table.h"

namespace asperity {
namespace {

StoredMap read(const SourceFile& file, const ReadOptions& options) {
  const NanoscopeHeader header = nanoscope_header(file);
  const auto exports = nanoscope_exports(file);
  const bool named = exports.size() == header.images.size();
  std::vector<ChannelEntry> channels;
  for (std::size_t i = 0; i < exports.size(); ++i)
    channels.push_back({named ? nanoscope_image_name(header.images[i]) : "image " + std::to_string(i),
                        plain_unit(exports[i].unit), length_unit_factor(exports[i].unit).has_value()});
  const std::size_t chosen = choose_channel(file, channels, options);
  const NanoscopeExport& rows = exports[chosen];
  TextTable table = text_table({file.path, file.bytes.substr(rows.begin, rows.end - rows.begin)});
  StoredMap map;
  map.nx = static_cast<int>(table.columns);
  map.ny = static_cast<int>(table.rows);
  map.heights = std::move(table.values);
  const double unit = *length_unit_factor(rows.unit);
  for (double& height : map.heights) height *= unit;
  read_nanoscope_size(header, named ? header.images[chosen] : NanoscopeSection{}, map);
  map.channel = channels[chosen].name;
  map.scale = "heights in " + channels[chosen].unit;
  map.first_row = FirstRow::bottom;
  map.note = "channel " + std::to_string(chosen) + " of " + std::to_string(channels.size());
  return map;
}

bool recognises(const SourceFile& file) {
  const std::string beginning = lower_case(file.bytes.substr(0, 32));
  for (const char* first_line : {"\\*file list", "?*file list", "\"\\*file list", "\"?*file list"})
    if (beginning.rfind(first_line, 0) == 0) return !nanoscope_exports(file).empty();
  return false;
}

}  // namespace

namespace formats {
TopographyFormat make_nanoscope_text() {
  return {"NanoScope text export (.txt)", {}, "the line '\\*File list'", recognises, read};
}
}  // namespace formats

}  // namespace asperity
