// Surface data files (.sdf) of ISO 25178-71:2017, and of BCR-1.0 before it: "aISO-1.0" as text, "bISO-1.0"
// in binary, little-endian. Spacings Xscale and Yscale and the unit of heights Zscale are metres. DataType 0
// to 7: unsigned integers of 8, 16, 32 bit, float, signed integers of 8, 16, 32 bit, double. What is not
// measured is BAD in text, else the largest unsigned or the smallest signed number of its type, or NaN.
// Profiles are taken from the top of the image down, as Gwyddion and SurfaceTopography show them. No real
// file was at hand: checked against files that the tests write from this description, of which Gwyddion reads
// the binary one likewise.
#include <cmath>
#include <limits>
#include <map>

#include "core/error.h"
#include "core/quantity.h"
#include "surfaces/readers/channels.h"
#include "surfaces/readers/format.h"
#include "surfaces/readers/stored_numbers.h"
#include "surfaces/readers/text_parts.h"

namespace asperity {
namespace {

constexpr std::size_t magic_size = 8;
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

struct SdfHeader {
  double points = 0, profiles = 0;
  double dx = 0, dy = 0, dz = 0;  ///< [m]
  double compression = 0, type = 0;
  std::size_t begin = 0;
};

SdfHeader binary_header(const SourceFile& file) {
  HeaderReader reader(file, "SDF", ByteOrder::little, magic_size);
  reader.skip(10 + 12 + 12);  // instrument, dates
  SdfHeader header;
  header.points = reader.next<std::uint16_t>();
  header.profiles = reader.next<std::uint16_t>();
  header.dx = reader.next<double>();
  header.dy = reader.next<double>();
  header.dz = reader.next<double>();
  reader.skip(sizeof(double));  // resolution
  header.compression = reader.next<std::uint8_t>();
  header.type = reader.next<std::uint8_t>();
  reader.skip(1);  // check sum
  header.begin = reader.at();
  return header;
}

SdfHeader text_header(const SourceFile& file) {
  constexpr std::size_t most_lines = 500;
  std::map<std::string, std::string> entries;
  SdfHeader header;
  std::size_t begin = std::min(file.bytes.find('\n'), file.bytes.size());
  for (std::size_t line = 0; line < most_lines && header.begin == 0; ++line) {
    if (begin >= file.bytes.size()) break;
    const std::size_t end = std::min(file.bytes.find('\n', begin + 1), file.bytes.size());
    const std::string text = trimmed_text(file.bytes.substr(begin + 1, end - begin - 1));
    begin = end;
    const auto equals = text.find('=');
    if (text == "*") header.begin = end;
    if (equals != std::string::npos)
      entries[lower_case(trimmed_text(text.substr(0, equals)))] = trimmed_text(text.substr(equals + 1));
  }
  if (header.begin == 0)
    throw InputError(file.name() + " ends inside its SDF header: it is cut off; copy or export it again");
  const auto number = [&](const std::string& key) {
    const auto value = whole_number_text(entries[key]);
    if (!value)
      throw InputError(file.name() + " has no valid '" + key +
                       "' in its SDF header, so it is damaged; export it again");
    return *value;
  };
  header.points = number("numpoints");
  header.profiles = number("numprofiles");
  header.dx = number("xscale");
  header.dy = number("yscale");
  header.dz = number("zscale");
  header.type = number("datatype");
  header.compression = entries.count("compression") ? number("compression") : 0;
  return header;
}

NumberType number_type(const SourceFile& file, const SdfHeader& header) {
  static const std::vector<NumberType> types{NumberType::uint8,   NumberType::uint16, NumberType::uint32,
                                             NumberType::float32, NumberType::int8,   NumberType::int16,
                                             NumberType::int32,   NumberType::float64};
  for (std::size_t i = 0; i < types.size(); ++i)
    if (header.type == static_cast<double>(i)) return types[i];
  throw InputError(file.name() + " stores numbers in a way that SDF does not know; export it again");
}

/// What stands for a point that was not measured; NaN where only NaN does.
double marker_of(NumberType type) {
  switch (type) {
    case NumberType::uint16:
      return std::numeric_limits<std::uint16_t>::max();
    case NumberType::uint32:
      return std::numeric_limits<std::uint32_t>::max();
    case NumberType::int16:
      return std::numeric_limits<std::int16_t>::min();
    case NumberType::int32:
      return std::numeric_limits<std::int32_t>::min();
    default:
      return missing;
  }
}

/// Numbers and BAD, up to a second "*".
std::vector<double> text_numbers(const SourceFile& file, const SdfHeader& header) {
  const double wanted = header.points * header.profiles;
  std::vector<double> numbers;
  const char* at = file.bytes.c_str() + header.begin;
  const char* const end = file.bytes.c_str() + file.bytes.size();
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == ','; };
  while (static_cast<double>(numbers.size()) < wanted) {
    while (at < end && blank(*at)) ++at;
    const char* const word_end = std::find_if(at, end, blank);
    const std::string word(at, word_end);
    const auto number = whole_number_text(word);
    if (!number && lower_case(word) != "bad")
      throw InputError(file.name() + " has " + std::to_string(numbers.size()) + " of the heights of " +
                       format_quantity(header.points, Dimension::none, 9) + " x " +
                       format_quantity(header.profiles, Dimension::none, 9) +
                       " points: it is cut off or damaged; copy or export it again");
    numbers.push_back(number.value_or(missing));
    at = word_end;
  }
  return numbers;
}

StoredMap read(const SourceFile& file, const ReadOptions& options) {
  const bool binary = file.bytes[0] == 'b';
  const SdfHeader header = binary ? binary_header(file) : text_header(file);
  choose_channel(file, {{"heights", "m", true}}, options);
  if (header.compression != 0)
    throw InputError(file.name() + " holds packed data, which is not read; export it without compression");
  constexpr double most = 1 << 20;
  const auto is_count = [](double n) { return n >= 1 && n <= most && n == std::floor(n); };
  if (!is_count(header.points) || !is_count(header.profiles))
    throw InputError(file.name() + " gives no valid number of points, so it is damaged; export it again");
  StoredGrid grid;
  grid.columns = static_cast<std::int64_t>(header.points);
  grid.rows = static_cast<std::int64_t>(header.profiles);
  grid.begin = header.begin;
  grid.type = number_type(file, header);
  StoredMap map;
  map.nx = static_cast<int>(grid.columns);
  map.ny = static_cast<int>(grid.rows);
  map.heights = binary ? grid_numbers(file, grid) : text_numbers(file, header);
  const double marker = marker_of(grid.type);
  for (double& height : map.heights) height = height == marker ? missing : height * header.dz;
  map.lx = std::abs(header.dx) * map.nx;
  map.ly = std::abs(header.dy) * map.ny;
  map.channel = "heights";
  map.scale = "heights in steps of " + format_quantity(header.dz, Dimension::length, 6);
  map.first_row = FirstRow::top;
  return map;
}

bool recognises(const SourceFile& file) {
  for (const char* magic : {"aISO-1.0", "bISO-1.0", "aBCR-1.0", "bBCR-1.0"})
    if (file.bytes.compare(0, magic_size, magic) == 0) return true;
  return false;
}

}  // namespace

namespace formats {
TopographyFormat make_sdf() {
  return {"surface data file (.sdf)", {".sdf"}, "the mark 'aISO-1.0' or 'bISO-1.0'", recognises, read};
}
}  // namespace formats

}  // namespace asperity
