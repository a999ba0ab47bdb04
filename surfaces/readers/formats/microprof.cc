// MicroProf files of FRT (.frt): "FRTM_GLIDERV1.00" or 1.01, the number of blocks, then blocks of a tag of 16
// bit and a length of 32 (1.00) or 64 bit (1.01), little-endian. Block 0x66: columns, rows, bits; 0x67: sides
// in metres; 0x6c: range and the metres of one step; 0x0b: the heights, 16 bit unsigned or 32 bit signed, of
// which 1 was not measured. The first row stored is the bottom of the image. Layout as in Gwyddion's and
// SurfaceTopography's readers. No real file was at hand: checked against files that the tests write from this
// description, which Gwyddion reads likewise.
#include <limits>
#include <map>

#include "core/error.h"
#include "core/quantity.h"
#include "surfaces/readers/channels.h"
#include "surfaces/readers/format.h"
#include "surfaces/readers/stored_numbers.h"

namespace asperity {
namespace {

const std::string magic = "FRTM_GLIDERV", short_version = "1.00", long_version = "1.01";
constexpr int heights_block = 0x0b, grid_block = 0x66, sides_block = 0x67, scale_block = 0x6c;

struct Block {
  std::size_t begin = 0;
  std::uint64_t length = 0;
};

std::map<int, Block> blocks_of(const SourceFile& file) {
  HeaderReader reader(file, "MicroProf", ByteOrder::little, magic.size());
  const std::string version = reader.text(short_version.size());
  if (version != short_version && version != long_version)
    throw InputError(file.name() + " is of version " + version +
                     " of the MicroProf format, which is not read; open it in Gwyddion and export .gsf");
  const int count = reader.next<std::uint16_t>();
  std::map<int, Block> blocks;
  for (int i = 0; i < count; ++i) {
    const int tag = reader.next<std::uint16_t>();
    const std::uint64_t length =
        version == short_version ? reader.next<std::uint32_t>() : reader.next<std::uint64_t>();
    blocks.emplace(tag, Block{reader.at(), length});
    reader.skip(length);
  }
  return blocks;
}

HeaderReader contents(const SourceFile& file, const std::map<int, Block>& blocks, int tag) {
  const auto found = blocks.find(tag);
  if (found == blocks.end())
    throw InputError(file.name() + " lacks block " + std::to_string(tag) +
                     " of the MicroProf format, so it holds no map; pass a file of an area scan");
  return {file, "MicroProf", ByteOrder::little, found->second.begin};
}

StoredMap read(const SourceFile& file, const ReadOptions& options) {
  const auto blocks = blocks_of(file);
  choose_channel(file, {{"heights", "m", true}}, options);
  HeaderReader pixels = contents(file, blocks, grid_block);
  StoredGrid grid;
  grid.columns = pixels.next<std::uint32_t>();
  grid.rows = pixels.next<std::uint32_t>();
  const std::uint32_t bits = pixels.next<std::uint32_t>();
  if (bits != 16 && bits != 32)
    throw InputError(file.name() + " stores heights in " + std::to_string(bits) +
                     " bits, which the MicroProf format does not know; export it again");
  grid.type = bits == 16 ? NumberType::uint16 : NumberType::int32;
  grid.begin = contents(file, blocks, heights_block).at();
  HeaderReader scale = contents(file, blocks, scale_block);
  scale.skip(4);  // range of the sensor
  const double step = scale.next<double>();
  HeaderReader sides = contents(file, blocks, sides_block);
  StoredMap map;
  map.lx = sides.next<double>();
  map.ly = sides.next<double>();
  map.nx = static_cast<int>(grid.columns);
  map.ny = static_cast<int>(grid.rows);
  map.heights = grid_numbers(file, grid);
  constexpr double not_measured = 1;
  for (double& height : map.heights)
    height = height == not_measured ? std::numeric_limits<double>::quiet_NaN() : height * step;
  map.channel = "heights";
  map.scale = "heights in steps of " + format_quantity(step, Dimension::length, 6);
  map.first_row = FirstRow::bottom;
  return map;
}

bool recognises(const SourceFile& file) { return file.bytes.compare(0, magic.size(), magic) == 0; }

}  // namespace

namespace formats {
TopographyFormat make_microprof() {
  return {"MicroProf (.frt)", {".frt"}, "the mark 'FRTM_GLIDERV'", recognises, read};
}
}  // namespace formats

}  // namespace asperity
