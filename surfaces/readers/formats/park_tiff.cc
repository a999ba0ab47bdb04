// Park Systems (PSIA) TIFF: a TIFF picture whose private tags carry the heights: 50432 magic number, 50433
// version, 50434 data, 50435 header. Little-endian; size in micrometres; height = gain * (scale * stored +
// offset) in the unit of the header; bottom row first. Layout as described in SurfaceTopography's and
// Gwyddion's manuals and readers. No real file was at hand: checked only against files that the tests write
// from this description.
#include "core/error.h"
#include "surfaces/readers/channels.h"
#include "surfaces/readers/format.h"
#include "surfaces/readers/length_unit.h"
#include "surfaces/readers/text_parts.h"
#include "surfaces/readers/tiff_tags.h"

namespace asperity {
namespace {

constexpr std::uint32_t park_magic = 0x0E031301;
constexpr std::uint32_t version_1 = 0x01000001, version_2 = 0x01000002;
constexpr int magic_tag = 50432, version_tag = 50433, data_tag = 50434, header_tag = 50435;

/// Values of the header tag one after the other, without padding.
class HeaderCursor {
 public:
  HeaderCursor(const SourceFile& file, TiffTag tag)
      : file_(file), at_(tag.offset), end_(tag.offset + tag.length) {
    if (end_ > file.bytes.size()) refuse_cut_off_tiff(file);
  }
  template <class T>
  T next() {
    const std::size_t at = advance(sizeof(T));
    return little_endian<T>(file_.bytes, at);
  }
  void skip(std::size_t bytes) { advance(bytes); }
  /// A text of `characters` 16-bit characters as UTF-8.
  std::string next_text(std::size_t characters) {
    const std::size_t at = advance(2 * characters);
    std::string text;
    for (std::size_t i = 0; i < characters; ++i) {
      const auto code = little_endian<std::uint16_t>(file_.bytes, at + 2 * i);
      if (code == 0) break;
      append_utf8(code, text);
    }
    return trimmed_text(text);
  }

 private:
  static void append_utf8(std::uint16_t code, std::string& text) {
    if (code < 0x80) {
      text += static_cast<char>(code);
    } else if (code < 0x800) {
      text += static_cast<char>(0xC0 | code >> 6);
      text += static_cast<char>(0x80 | (code & 0x3F));
    } else {
      text += static_cast<char>(0xE0 | code >> 12);
      text += static_cast<char>(0x80 | (code >> 6 & 0x3F));
      text += static_cast<char>(0x80 | (code & 0x3F));
    }
  }
  std::size_t advance(std::size_t bytes) {
    if (at_ + bytes > end_)
      throw InputError(file_.name() +
                       " has a Park header that is too short; export it again, for example as .gsf");
    at_ += bytes;
    return at_ - bytes;
  }
  const SourceFile& file_;
  std::size_t at_, end_;
};

enum class ImageType : std::uint32_t { map = 0, line_profile = 1, spectroscopy = 2 };
enum class DataType : std::uint32_t { int16 = 0, int32 = 1, float32 = 2 };

struct ParkHeader {
  ImageType image_type = ImageType::map;
  std::string source;
  std::uint32_t columns = 0, rows = 0;
  double width_um = 0, height_um = 0;
  double gain = 0, scale = 0, offset = 0;
  std::string unit;
  DataType data_type = DataType::int16;
};

ParkHeader read_header(const SourceFile& file, TiffTag tag, std::uint32_t version) {
  HeaderCursor cursor(file, tag);
  ParkHeader header;
  header.image_type = cursor.next<ImageType>();
  header.source = cursor.next_text(32);
  cursor.next_text(8);                  // image mode
  cursor.skip(sizeof(double) + 4 + 4);  // low pass filter, flattening, AC tracking
  header.columns = cursor.next<std::uint32_t>();
  header.rows = cursor.next<std::uint32_t>();
  cursor.skip(sizeof(double) + 4 + sizeof(double) + 4 + 4 +
              4);  // angle, sine scan, overscan, forward, up, swap
  header.width_um = cursor.next<double>();
  header.height_um = cursor.next<double>();
  cursor.skip(4 * sizeof(double));  // offsets, scan rate, set point
  cursor.next_text(8);              // unit of the set point
  cursor.skip(2 * sizeof(double));  // tip and sample bias
  header.gain = cursor.next<double>();
  header.scale = cursor.next<double>();
  header.offset = cursor.next<double>();
  header.unit = cursor.next_text(8);
  if (version == version_2) {
    cursor.skip(std::size_t{6} * 4);  // smallest, largest, mean, compression, logarithmic, square
    cursor.skip(2 * sizeof(double));  // servo gain, scanner range
    cursor.next_text(8);              // xy voltage mode
    cursor.next_text(8);              // voltage mode
    cursor.next_text(8);              // xy servo mode
    header.data_type = cursor.next<DataType>();
  }
  if (header.scale == 0) header.scale = 1;
  if (header.unit.empty()) header.unit = "um";
  return header;
}

std::uint32_t number_of(const SourceFile& file, const TiffDirectory& tags, int tag) {
  const auto found = tags.find(tag);
  if (found == tags.end() || found->second.length < 4) return 0;
  if (found->second.offset + 4 > file.bytes.size()) refuse_cut_off_tiff(file);
  return little_endian<std::uint32_t>(file.bytes, found->second.offset);
}

double stored_value(const SourceFile& file, DataType type, std::size_t begin, std::size_t index) {
  switch (type) {
    case DataType::int16:
      return little_endian<std::int16_t>(file.bytes, begin + 2 * index);
    case DataType::int32:
      return little_endian<std::int32_t>(file.bytes, begin + 4 * index);
    case DataType::float32:
      return little_endian<float>(file.bytes, begin + 4 * index);
  }
  throw InputError(file.name() +
                   " stores its heights in a way that is not known; open it in Gwyddion and pass a .gsf");
}

StoredMap read(const SourceFile& file, const ReadOptions& options) {
  if (file.bytes[0] == 'M')
    throw InputError(file.name() +
                     " is a big-endian TIFF picture and not a Park file; export the heights as .gsf");
  const TiffDirectory tags = tiff_directories(file).front();
  if (number_of(file, tags, magic_tag) != park_magic || !tags.count(data_tag) || !tags.count(header_tag))
    throw InputError(
        file.name() +
        " is a TIFF picture without Park's heights, so it holds colours and no lengths; export the "
        "heights, for example as .gsf");
  const std::uint32_t version = number_of(file, tags, version_tag);
  if (version != version_1 && version != version_2)
    throw InputError(file.name() + " is of a version of Park's format that is not known; export it as .gsf");
  const ParkHeader header = read_header(file, tags.at(header_tag), version);
  if (header.image_type == ImageType::line_profile)
    throw InputError(file.name() + " holds a line profile and not a map; pass the image");
  const auto unit = length_unit_factor(header.unit);
  choose_channel(file, {{header.source, plain_unit(header.unit), unit.has_value()}}, options);
  const TiffTag data = tags.at(data_tag);
  const std::size_t points = static_cast<std::size_t>(header.columns) * header.rows;
  const std::size_t bytes = header.data_type == DataType::int16 ? 2 : 4;
  constexpr std::uint32_t most_pixels = 1u << 20;
  if (header.columns > most_pixels || header.rows > most_pixels || data.length < points * bytes)
    throw InputError(file.name() + " keeps " + std::to_string(data.length) + " bytes for " +
                     std::to_string(header.columns) + " x " + std::to_string(header.rows) +
                     " pixels, which is too few; export it again");
  if (data.offset + points * bytes > file.bytes.size()) refuse_cut_off_tiff(file);
  StoredMap map;
  map.nx = static_cast<int>(header.columns);
  map.ny = static_cast<int>(header.rows);
  map.heights.resize(points);
  for (std::size_t i = 0; i < points; ++i)
    map.heights[i] = *unit * header.gain *
                     (header.scale * stored_value(file, header.data_type, data.offset, i) + header.offset);
  constexpr double micrometre = 1e-6;
  if (header.width_um > 0 && header.height_um > 0) {
    map.lx = header.width_um * micrometre;
    map.ly = header.height_um * micrometre;
  }
  map.channel = header.source;
  map.scale = "heights in " + plain_unit(header.unit);
  map.first_row = FirstRow::bottom;
  return map;
}

bool recognises(const SourceFile& file) { return is_tiff(file); }

}  // namespace

namespace formats {
TopographyFormat make_park_tiff() {
  return {"Park Systems TIFF (.tiff)", {".tiff", ".tif"}, "the mark of a TIFF file", recognises, read};
}
}  // namespace formats

}  // namespace asperity
