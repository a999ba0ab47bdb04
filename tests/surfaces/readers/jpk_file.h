// The common map as JPK Instruments write it: a TIFF file of a thumbnail and one channel.
#pragma once

#include "tests/surfaces/readers/instrument_files.h"

namespace asperity::test {

/// A tag of a TIFF directory: number, type, its values' bytes, and how many there are.
struct TiffEntry {
  int tag, type;
  std::string values;
  std::uint32_t count = 1;
};

inline TiffEntry tiff_long(int tag, std::uint32_t value) { return {tag, 4, raw(value)}; }
inline TiffEntry tiff_short(int tag, std::uint16_t value) { return {tag, 3, raw(value)}; }
inline TiffEntry tiff_double(int tag, double value) { return {tag, 12, raw(value)}; }
inline TiffEntry tiff_string(int tag, const std::string& text) {
  return {tag, 2, text + '\0', static_cast<std::uint32_t>(text.size() + 1)};
}

/// The directory that begins at byte `at`, with the values that do not fit into it behind it.
inline std::string tiff_directory(const std::vector<TiffEntry>& entries, std::size_t at, bool last) {
  std::string directory = raw<std::uint16_t>(entries.size()), behind;
  const std::size_t values_at = at + 2 + 12 * entries.size() + 4;
  for (const auto& entry : entries) {
    directory += raw<std::uint16_t>(entry.tag) + raw<std::uint16_t>(entry.type) + raw(entry.count);
    if (entry.values.size() <= 4) {
      directory += field(entry.values, 4);
    } else {
      directory += raw<std::uint32_t>(values_at + behind.size());
      behind += entry.values;
    }
  }
  return directory + raw<std::uint32_t>(last ? 0 : values_at + behind.size()) + behind;
}

inline std::string jpk_map(const std::string& unit = "m", bool reflected = false) {
  const std::string numbers = map_numbers<std::int16_t>(10, reflected);
  const std::size_t begin = 8, first_row = 6;
  std::string bytes = std::string("II*\0", 4) + raw<std::uint32_t>(begin + numbers.size()) + numbers;
  bytes +=
      tiff_directory({tiff_long(256, 1), tiff_long(257, 1), tiff_short(258, 8), tiff_double(0x8042, 3e-6),
                      tiff_double(0x8043, 2e-6), tiff_string(0x8052, "thumbnail")},
                     bytes.size(), false);
  const std::string begins = raw<std::uint32_t>(begin) + raw<std::uint32_t>(begin + first_row);
  const std::string lengths = raw<std::uint32_t>(first_row) + raw<std::uint32_t>(first_row);
  return bytes + tiff_directory({tiff_long(256, 3),
                                 tiff_long(257, 2),
                                 tiff_short(258, 16),
                                 tiff_short(259, 1),
                                 {273, 4, begins, 2},
                                 {279, 4, lengths, 2},
                                 tiff_short(339, 2),
                                 tiff_long(0x8045, reflected),
                                 tiff_long(0x8051, 1),
                                 tiff_string(0x8052, "Height (measured)"),
                                 tiff_long(0x8080, 2),
                                 tiff_string(0x8081, "nominal"),
                                 tiff_string(0x8090, "volts"),
                                 tiff_string(0x80c0, "nominal"),
                                 tiff_string(0x80d2, unit),
                                 tiff_string(0x80d3, "LinearScaling"),
                                 tiff_double(0x80d5, 0.0),
                                 tiff_double(0x80d4, 1e-10)},
                                bytes.size(), true);
}

}  // namespace asperity::test
