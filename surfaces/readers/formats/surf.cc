// Digital Surf's surfaces (.sur) of MountainsMap: a header of 512 bytes, a comment and a private zone whose
// lengths it states, then integers of 16 or 32 bit, little-endian, top row first. Height = stored * the
// spacing of z + its offset, in its unit; where special points are announced, the lowest value less two marks
// a point that was not measured (Digital Surf, format of .sur files). Checked against a real file in the
// tests.
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/quantity.h"
#include "surfaces/readers/channels.h"
#include "surfaces/readers/format.h"
#include "surfaces/readers/length_unit.h"
#include "surfaces/readers/stored_numbers.h"

namespace asperity {
namespace {

const std::string magic = "DIGITAL SURF", packed_magic = "DSCOMPRESSED";
constexpr std::size_t header_size = 512;

struct SurfHeader {
  int format = 0, type = 0;
  std::string name;
  bool special_points = false;
  std::int64_t lowest = 0;
  StoredGrid grid;
  int bits = 0;
  double dx = 0, dy = 0, dz = 0, z_offset = 0;
  std::string x_unit, y_unit, z_unit;
};

SurfHeader header_of(const SourceFile& file) {
  HeaderReader reader(file, "Digital Surf", ByteOrder::little, magic.size());
  SurfHeader header;
  header.format = reader.next<std::uint16_t>();
  reader.skip(2 + 2);  // number of objects, version
  header.type = reader.next<std::uint16_t>();
  header.name = reader.text(30);
  if (header.name.empty()) header.name = "surface";
  reader.skip(30 + 2 + 2 + 2);  // operator, material, acquisition, range
  header.special_points = reader.next<std::uint16_t>() != 0;
  reader.skip(2 + 8);  // absolute heights, reserved
  header.bits = reader.next<std::uint16_t>();
  header.lowest = reader.next<std::int32_t>();
  reader.skip(4);  // highest
  header.grid.columns = reader.next<std::int32_t>();
  header.grid.rows = reader.next<std::int32_t>();
  reader.skip(4);  // number of points
  header.dx = reader.next<float>();
  header.dy = reader.next<float>();
  header.dz = reader.next<float>();
  reader.skip(std::size_t{3} * 16);  // names of the axes
  header.x_unit = reader.text(16);
  header.y_unit = reader.text(16);
  header.z_unit = reader.text(16);
  // Units that are shown, their ratios, imprint, inversion, levelling, date, duration.
  reader.skip(std::size_t{3} * 16 + 3 * 4 + 3 * 2 + 12 + 7 * 2 + 4 + 10);
  const std::uint64_t comment = reader.next<std::uint16_t>();
  const std::uint64_t private_zone = reader.next<std::uint16_t>();
  reader.skip(128 + 2 * 4);  // client's zone, offsets of x and y
  header.z_offset = reader.next<float>();
  header.grid.begin = header_size + comment + private_zone;
  header.grid.type = header.bits == 16 ? NumberType::int16 : NumberType::int32;
  return header;
}

void check(const SourceFile& file, const SurfHeader& header) {
  constexpr int surface = 2, written_on_macintosh = 257;
  if (header.format == written_on_macintosh)
    throw InputError(file.name() +
                     " is a Digital Surf file in the byte order of old Macintosh computers; open it in "
                     "MountainsMap or Gwyddion and export .x3p or .gsf");
  if (header.type != surface)
    throw InputError(file.name() + " is a Digital Surf file of type " + std::to_string(header.type) +
                     " and not a single surface (2); export the surface from MountainsMap, as .sur or .x3p");
  if (header.bits != 16 && header.bits != 32)
    throw InputError(file.name() + " stores heights in " + std::to_string(header.bits) +
                     " bits, which Digital Surf does not know; export it again");
}

StoredMap read(const SourceFile& file, const ReadOptions& options) {
  if (file.bytes.compare(0, packed_magic.size(), packed_magic) == 0)
    throw InputError(file.name() +
                     " is a Digital Surf file with packed data; export it from MountainsMap without "
                     "compression, or as .x3p");
  const SurfHeader header = header_of(file);
  check(file, header);
  const auto z_unit = length_unit_factor(header.z_unit);
  choose_channel(file, {{header.name, header.z_unit, z_unit.has_value()}}, options);
  StoredMap map;
  map.nx = static_cast<int>(header.grid.columns);
  map.ny = static_cast<int>(header.grid.rows);
  map.heights = grid_numbers(file, header.grid);
  const double step = header.dz * *z_unit;
  const auto not_measured = static_cast<double>(header.lowest - 2);
  for (double& height : map.heights)
    height = header.special_points && height == not_measured ? std::numeric_limits<double>::quiet_NaN()
                                                             : height * step + header.z_offset * *z_unit;
  const auto x_unit = length_unit_factor(header.x_unit), y_unit = length_unit_factor(header.y_unit);
  if (x_unit && y_unit) {
    map.lx = std::abs(header.dx) * *x_unit * map.nx;
    map.ly = std::abs(header.dy) * *y_unit * map.ny;
  }
  map.channel = header.name;
  map.scale = "heights in steps of " + format_quantity(step, Dimension::length, 6);
  map.first_row = FirstRow::top;
  return map;
}

bool recognises(const SourceFile& file) {
  return file.bytes.compare(0, magic.size(), magic) == 0 ||
         file.bytes.compare(0, packed_magic.size(), packed_magic) == 0;
}

}  // namespace

namespace formats {
TopographyFormat make_surf() {
  return {"Digital Surf (.sur)", {".sur"}, "the mark 'DIGITAL SURF'", recognises, read};
}
}  // namespace formats

}  // namespace asperity
