// Keyence's laser microscopes (.vk4, .vk6), little-endian: "VK4_", a table of offsets at byte 12 (the
// heights' is its seventh), conditions at byte 84 with the size of a pixel and the step of the heights in
// picometres. The heights: columns, rows, bits, packing, bytes, range, a palette of 768 bytes, then unsigned
// integers, top row first. A .vk6 is a packed copy and is refused. Layout as in SurfaceTopography's and
// Gwyddion's readers. No real file was at hand: checked against files that the tests write from this
// description, which Gwyddion reads likewise.
#include "core/error.h"
#include "core/quantity.h"
#include "surfaces/readers/channels.h"
#include "surfaces/readers/format.h"
#include "surfaces/readers/stored_numbers.h"

namespace asperity {
namespace {

const std::string magic = "VK4_", packed_magic = "VK6";
constexpr std::size_t offsets_at = 12, conditions_at = 84, palette = 768;
constexpr double picometre = 1e-12;

StoredGrid heights_of(const SourceFile& file, std::size_t begin) {
  HeaderReader reader(file, "Keyence", ByteOrder::little, begin);
  StoredGrid grid;
  grid.columns = reader.next<std::uint32_t>();
  grid.rows = reader.next<std::uint32_t>();
  const std::uint32_t bits = reader.next<std::uint32_t>(), packing = reader.next<std::uint32_t>();
  if ((bits != 8 && bits != 16 && bits != 32) || packing != 0)
    throw InputError(file.name() + " stores heights in " + std::to_string(bits) +
                     " bits or packed, which is not read; export it as text or .gsf");
  reader.skip(3 * 4 + palette);  // bytes, range of the palette
  grid.type = bits == 8 ? NumberType::uint8 : bits == 16 ? NumberType::uint16 : NumberType::uint32;
  grid.begin = reader.at();
  return grid;
}

StoredMap read(const SourceFile& file, const ReadOptions& options) {
  if (file.bytes.compare(0, packed_magic.size(), packed_magic) == 0)
    throw InputError(
        file.name() +
        " is a packed file of a newer Keyence microscope; export .vk4 or text from its software");
  choose_channel(file, {{"heights", "pm", true}}, options);
  HeaderReader reader(file, "Keyence", ByteOrder::little, offsets_at + 6 * 4);
  const std::size_t begin = reader.next<std::uint32_t>();
  if (begin == 0) throw InputError(file.name() + " holds pictures and no heights; save it with heights");
  reader.go_to(conditions_at + 42 * 4);
  const double dx = reader.next<std::uint32_t>(), dy = reader.next<std::uint32_t>();
  const double step = reader.next<std::uint32_t>() * picometre;
  const StoredGrid grid = heights_of(file, begin);
  StoredMap map;
  map.nx = static_cast<int>(grid.columns);
  map.ny = static_cast<int>(grid.rows);
  map.heights = grid_numbers(file, grid);
  for (double& height : map.heights) height *= step;
  map.lx = dx * picometre * map.nx;
  map.ly = dy * picometre * map.ny;
  map.channel = "heights";
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
TopographyFormat make_keyence() { return {"Keyence (.vk4)", {".vk4"}, "the mark 'VK4_'", recognises, read}; }
}  // namespace formats

}  // namespace asperity
