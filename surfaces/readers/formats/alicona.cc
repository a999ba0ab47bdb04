// Alicona's maps (.al3d): a mark, then tags of 52 bytes (key, value, line end), the first two of them Version
// and TagCount; the heights are 32-bit floats in metres at DepthImageOffset, top row first, each row filled
// up to eight bytes; InvalidPixelValue marks points that were not measured (Alicona Imaging, AL3D format).
// Checked against a real file and its owners' RMS in the tests.
#include <cmath>
#include <limits>
#include <map>

#include "core/error.h"
#include "surfaces/readers/channels.h"
#include "surfaces/readers/format.h"
#include "surfaces/readers/stored_numbers.h"
#include "surfaces/readers/text_parts.h"

namespace asperity {
namespace {

const std::string magic("AliconaImaging\0\r\n", 17);
using Tags = std::map<std::string, std::string>;

double number_of(const SourceFile& file, const Tags& tags, const std::string& key, double most) {
  const auto found = tags.find(key);
  const auto number = found == tags.end() ? std::nullopt : whole_number_text(found->second);
  if (!number || !(*number >= 0 && *number <= most))
    throw InputError(file.name() + " has no valid '" + key +
                     "' in its Alicona header, so it is damaged; export it again");
  return *number;
}

Tags tags_of(const SourceFile& file) {
  constexpr std::size_t key_size = 20, value_size = 30, line_end = 2, always = 2;
  constexpr double most_tags = 10000;
  HeaderReader reader(file, "Alicona", ByteOrder::little, magic.size());
  Tags tags;
  std::size_t count = always;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string key = reader.text(key_size);
    tags[key] = reader.text(value_size);
    reader.skip(line_end);
    if (i + 1 == always) count += static_cast<std::size_t>(number_of(file, tags, "TagCount", most_tags));
  }
  return tags;
}

StoredMap read(const SourceFile& file, const ReadOptions& options) {
  constexpr double most_pixels_along = 1 << 20, largest_offset = 1e12, widest_pixel = 1;
  const Tags tags = tags_of(file);
  choose_channel(file, {{"depth image", "m", true}}, options);
  StoredGrid grid;
  grid.columns = static_cast<std::int64_t>(number_of(file, tags, "Cols", most_pixels_along));
  grid.rows = static_cast<std::int64_t>(number_of(file, tags, "Rows", most_pixels_along));
  grid.begin = static_cast<std::uint64_t>(number_of(file, tags, "DepthImageOffset", largest_offset));
  if (grid.begin == 0)
    throw InputError(file.name() + " holds a picture without heights; export it with its depth image");
  constexpr std::uint64_t filled_up_to = 8;
  grid.row_bytes = (grid.bytes_per_row() + filled_up_to - 1) / filled_up_to * filled_up_to;
  StoredMap map;
  map.nx = static_cast<int>(grid.columns);
  map.ny = static_cast<int>(grid.rows);
  map.heights = grid_numbers(file, grid);
  const auto invalid_text = tags.find("InvalidPixelValue");
  const auto invalid = invalid_text == tags.end() ? std::nullopt : whole_number_text(invalid_text->second);
  if (invalid)
    for (double& height : map.heights)
      if (static_cast<float>(height) == static_cast<float>(*invalid))
        height = std::numeric_limits<double>::quiet_NaN();
  map.lx = number_of(file, tags, "PixelSizeXMeter", widest_pixel) * map.nx;
  map.ly = number_of(file, tags, "PixelSizeYMeter", widest_pixel) * map.ny;
  map.channel = "depth image";
  map.scale = "heights in m";
  map.first_row = FirstRow::top;
  return map;
}

bool recognises(const SourceFile& file) { return file.bytes.compare(0, magic.size(), magic) == 0; }

}  // namespace

namespace formats {
TopographyFormat make_alicona() {
  return {"Alicona (.al3d)", {".al3d"}, "the mark 'AliconaImaging'", recognises, read};
}
}  // namespace formats

}  // namespace asperity
