// Wyko files of Veeco and Bruker interferometers (.opd): two bytes, then a directory of blocks of 24 bytes
// (name, type, length, flags) that lists itself first; the blocks' contents follow in this order. An array
// begins with columns, rows and bytes of a number, and is stored column by column from the bottom up. Height
// = stored * Wavelength / Mult in nanometres; the side of a pixel is Pixel_size in millimetres, times Aspect
// along y. Points that were not measured hold 1e38 or more, as integers 32766 or more. Checked against a real
// file in the tests.
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/quantity.h"
#include "surfaces/readers/channels.h"
#include "surfaces/readers/format.h"
#include "surfaces/readers/stored_numbers.h"

namespace asperity {
namespace {

const std::string magic("\x01\0Directory", 11);
constexpr std::size_t block_size = 24, mark_size = 2;
constexpr double nanometre = 1e-9, millimetre = 1e-3;

struct Block {
  std::string name;
  int type = 0;
  std::uint64_t begin = 0, length = 0;
};

std::vector<Block> blocks_of(const SourceFile& file) {
  HeaderReader reader(file, "Wyko", ByteOrder::little, mark_size);
  const auto next_block = [&reader] {
    Block block;
    block.name = reader.text(16);
    block.type = reader.next<std::int16_t>();
    const auto length = reader.next<std::int32_t>();
    block.length = length > 0 ? static_cast<std::uint64_t>(length) : 0;
    reader.skip(2);  // flags
    return block;
  };
  const Block directory = next_block();
  std::vector<Block> blocks;
  std::uint64_t at = mark_size + directory.length;
  while (reader.at() + block_size <= mark_size + directory.length) {
    Block block = next_block();
    block.begin = at;
    at += block.length;
    if (block.length > 0) blocks.push_back(std::move(block));
  }
  return blocks;
}

const Block* find_block(const std::vector<Block>& blocks, const std::string& name) {
  for (const auto& block : blocks)
    if (block.name == name) return &block;
  return nullptr;
}

/// A number of its own block: a float, or a short for Mult.
std::optional<double> number_of(const SourceFile& file, const std::vector<Block>& blocks,
                                const std::string& name) {
  constexpr int of_short = 6, of_float = 7, of_double = 8;
  const Block* block = find_block(blocks, name);
  if (!block) return std::nullopt;
  HeaderReader reader(file, "Wyko", ByteOrder::little, block->begin);
  if (block->type == of_short) return reader.next<std::int16_t>();
  if (block->type == of_float) return reader.next<float>();
  if (block->type == of_double) return reader.next<double>();
  return std::nullopt;
}

bool is_heights(const std::string& name) {
  for (const char* known : {"OPD", "SAMPLE_DATA", "RAW_DATA", "RAW DATA", "Raw"})
    if (name == known) return true;
  return false;
}

/// The arrays of the file; heights are in waves of light until they are scaled.
std::vector<Block> arrays_of(const std::vector<Block>& blocks) {
  constexpr int of_array = 3;
  std::vector<Block> arrays;
  for (const auto& block : blocks)
    if (block.type == of_array) arrays.push_back(block);
  return arrays;
}

/// The array's grid, with columns and rows changed over: it is stored column by column.
StoredGrid stored_grid(const SourceFile& file, const Block& block) {
  HeaderReader reader(file, "Wyko", ByteOrder::little, block.begin);
  StoredGrid grid;
  grid.rows = reader.next<std::uint16_t>();
  grid.columns = reader.next<std::uint16_t>();
  const int size = reader.next<std::uint16_t>();
  if (size != 1 && size != 2 && size != 4)
    throw InputError(file.name() + " stores numbers in " + std::to_string(size) +
                     " bytes, which Wyko's format does not know; export it again");
  grid.type = size == 1 ? NumberType::uint8 : size == 2 ? NumberType::int16 : NumberType::float32;
  grid.begin = reader.at();
  return grid;
}

double known_number(const SourceFile& file, const std::vector<Block>& blocks, const std::string& name) {
  const auto number = number_of(file, blocks, name);
  if (!number || !(*number > 0) || !std::isfinite(*number))
    throw InputError(
        file.name() + " has no valid '" + name +
        "' in its Wyko header; open it in Vision or Gwyddion and export .gsf or x, y, z as text");
  return *number;
}

bool is_measured(double stored, NumberType type) {
  constexpr double bad_float = 1e38f, bad_integer = 32766;
  return type == NumberType::float32 ? std::abs(stored) < bad_float : stored < bad_integer;
}

StoredMap read(const SourceFile& file, const ReadOptions& options) {
  const auto blocks = blocks_of(file);
  const auto arrays = arrays_of(blocks);
  std::vector<ChannelEntry> channels;
  for (const auto& array : arrays) channels.push_back({array.name, "", is_heights(array.name)});
  if (channels.empty())
    throw InputError(file.name() + " is a Wyko file without a map; pass a file of a measurement");
  const std::size_t chosen = choose_channel(file, channels, options);
  const StoredGrid grid = stored_grid(file, arrays[chosen]);
  const double scale =
      known_number(file, blocks, "Wavelength") * nanometre / number_of(file, blocks, "Mult").value_or(1.0);
  if (!std::isfinite(scale)) known_number(file, blocks, "Mult");
  StoredMap map;
  map.nx = static_cast<int>(grid.rows);
  map.ny = static_cast<int>(grid.columns);
  map.heights = transposed(grid_numbers(file, grid), grid.rows, grid.columns);
  for (double& height : map.heights)
    height = is_measured(height, grid.type) ? height * scale : std::numeric_limits<double>::quiet_NaN();
  if (const auto pixel = number_of(file, blocks, "Pixel_size"); pixel && *pixel > 0) {
    map.lx = *pixel * millimetre * map.nx;
    map.ly = *pixel * millimetre * number_of(file, blocks, "Aspect").value_or(1.0) * map.ny;
  }
  map.channel = channels[chosen].name;
  map.scale = "heights in " + format_quantity(scale, Dimension::length, 6);
  map.first_row = FirstRow::bottom;
  map.note = "channel " + std::to_string(chosen) + " of " + std::to_string(channels.size());
  return map;
}

bool recognises(const SourceFile& file) { return file.bytes.compare(0, magic.size(), magic) == 0; }

}  // namespace

namespace formats {
TopographyFormat make_wyko_opd() {
  return {"Wyko (.opd)", {".opd"}, "a block named 'Directory'", recognises, read};
}
}  // namespace formats

}  // namespace asperity
