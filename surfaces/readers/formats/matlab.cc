// Workspaces of MATLAB (.mat) of level 5: 116 bytes of text that begin with "MATLAB 5.0", version and byte
// order, then elements (type, length, data filled up to eight bytes; short ones in eight bytes). A matrix is
// an element of elements: flags with its class, sides, name, numbers, column by column; one packed by zlib is
// another inside (MathWorks, "MAT-File Level 5 File Format"). Each two-dimensional matrix of real numbers is
// a channel; sizes and units are not stored, and the first index runs down the rows of the image, as imagesc
// shows it. Level 7.3 is HDF5 and refused.
#include <map>

#include "core/error.h"
#include "surfaces/readers/channels.h"
#include "surfaces/readers/format.h"
#include "surfaces/readers/height_unit.h"
#include "surfaces/readers/inflate.h"
#include "surfaces/readers/stored_numbers.h"

namespace asperity {
namespace {

const std::string magic = "MATLAB 5.0 MAT-file", hdf5_magic = "MATLAB 7.3 MAT-file";
constexpr std::size_t header_size = 128;
constexpr std::uint32_t matrix_element = 14, packed_element = 15;

/// One element and where its data lie.
struct Element {
  std::uint32_t type = 0;
  std::uint64_t begin = 0, length = 0, next = 0;
};

/// Throws InputError where it would end behind `end`.
Element element_at(const SourceFile& file, ByteOrder order, std::uint64_t at, std::uint64_t end) {
  constexpr std::uint64_t alignment = 8;
  HeaderReader reader(file, "MATLAB", order, at);
  Element element;
  element.type = reader.next<std::uint32_t>();
  if (const std::uint32_t short_length = element.type >> 16; short_length > 0) {
    element.type &= 0xFFFF;
    element.length = std::min<std::uint32_t>(short_length, 4);
    element.begin = at + 4;
    element.next = at + alignment;
  } else {
    element.length = reader.next<std::uint32_t>();
    element.begin = at + alignment;
    const std::uint64_t filled = (element.length + alignment - 1) / alignment * alignment;
    element.next = element.begin + (element.type == packed_element ? element.length : filled);
  }
  if (element.begin + element.length > end)
    throw InputError(file.name() +
                     " has a MATLAB element that goes beyond its end: it is cut off or damaged; "
                     "save it again");
  return element;
}

/// A matrix that can be a map.
struct Matrix {
  std::string name;
  StoredGrid grid;  ///< columns and rows changed over: it is stored column by column
  SourceFile source;
};

std::optional<NumberType> number_type(std::uint32_t type) {
  static const std::map<std::uint32_t, NumberType> types{
      {1, NumberType::int8},   {2, NumberType::uint8},  {3, NumberType::int16},   {4, NumberType::uint16},
      {5, NumberType::int32},  {6, NumberType::uint32}, {7, NumberType::float32}, {9, NumberType::float64},
      {12, NumberType::int64}, {13, NumberType::uint64}};
  const auto found = types.find(type);
  return found == types.end() ? std::nullopt : std::optional<NumberType>(found->second);
}

/// The matrix if it is one of real numbers with two dimensions.
std::optional<Matrix> matrix_of(const SourceFile& file, ByteOrder order, const Element& whole) {
  constexpr std::uint32_t first_numeric = 6, last_numeric = 15, complex_flag = 0x0800;
  const std::uint64_t end = whole.begin + whole.length;
  const Element flags = element_at(file, order, whole.begin, end);
  const std::uint32_t word = HeaderReader(file, "MATLAB", order, flags.begin).next<std::uint32_t>();
  const std::uint32_t kind = word & 0xFF;
  if (kind < first_numeric || kind > last_numeric || (word & complex_flag)) return std::nullopt;
  const Element sides = element_at(file, order, flags.next, end);
  constexpr std::uint64_t of_two_sides = 8;
  if (sides.length != of_two_sides) return std::nullopt;
  HeaderReader reader(file, "MATLAB", order, sides.begin);
  Matrix matrix;
  matrix.grid.columns = reader.next<std::int32_t>();
  matrix.grid.rows = reader.next<std::int32_t>();
  if (matrix.grid.columns < 2 || matrix.grid.rows < 2) return std::nullopt;  // a number, a list or nothing
  const Element name = element_at(file, order, sides.next, end);
  matrix.name = HeaderReader(file, "MATLAB", order, name.begin).text(name.length);
  const Element numbers = element_at(file, order, name.next, end);
  const auto type = number_type(numbers.type);
  if (!type) return std::nullopt;
  matrix.grid.type = *type;
  matrix.grid.order = order;
  matrix.grid.begin = numbers.begin;
  const std::uint64_t needed = checked_grid_bytes(file, matrix.grid);
  if (needed > numbers.length)
    throw InputError(file.name() + " has fewer numbers in '" + matrix.name +
                     "' than its sides say: it is damaged; save it again");
  return matrix;
}

ByteOrder order_of(const SourceFile& file) {
  return file.bytes.compare(126, 2, "MI") == 0 ? ByteOrder::big : ByteOrder::little;
}

/// All matrices that can be maps; those that are packed bring what they unpack to, of which the limit of
/// core/read_limits.h holds for all together.
std::vector<Matrix> matrices_of(const SourceFile& file) {
  const ByteOrder order = order_of(file);
  std::vector<Matrix> matrices;
  std::uint64_t unpacked = 0;
  for (std::uint64_t at = header_size; at + 8 <= file.bytes.size();) {
    const Element element = element_at(file, order, at, file.bytes.size());
    at = element.next;
    std::optional<Matrix> matrix;
    if (element.type == matrix_element) {
      matrix = matrix_of(file, order, element);
    } else if (element.type == packed_element) {
      SourceFile inside{file.path, inflated(file, {element.begin, element.length}, Packing::zlib, unpacked)};
      unpacked += inside.bytes.size();
      const Element inner = element_at(inside, order, 0, inside.bytes.size());
      if (inner.type == matrix_element) matrix = matrix_of(inside, order, inner);
      if (matrix) matrix->source = std::move(inside);
    }
    if (matrix) matrices.push_back(std::move(*matrix));
  }
  return matrices;
}

StoredMap read(const SourceFile& file, const ReadOptions& options) {
  if (file.bytes.compare(0, hdf5_magic.size(), hdf5_magic) == 0)
    throw InputError(
        file.name() +
        " is a MATLAB file of level 7.3, which is not read; save it in MATLAB with save(name, '-v7')");
  if (file.bytes.size() < header_size)
    throw InputError(file.name() + " ends inside its MATLAB header: it is cut off; copy or save it again");
  const auto matrices = matrices_of(file);
  std::vector<ChannelEntry> channels;
  for (const auto& matrix : matrices) channels.push_back({matrix.name, "", true});
  if (channels.empty())
    throw InputError(file.name() + " holds no matrix of real numbers; save the heights as one");
  const std::size_t chosen = choose_channel(file, channels, options);
  const Matrix& matrix = matrices[chosen];
  StoredMap map;
  const double unit = height_unit(file, "", options, map);
  map.nx = static_cast<int>(matrix.grid.rows);
  map.ny = static_cast<int>(matrix.grid.columns);
  const SourceFile& source = matrix.source.bytes.empty() ? file : matrix.source;
  map.heights = transposed(grid_numbers(source, matrix.grid), matrix.grid.rows, matrix.grid.columns);
  for (double& height : map.heights) height *= unit;
  map.channel = matrix.name;
  map.note += "; the matrix's first index runs down the image; channel " + std::to_string(chosen) + " of " +
              std::to_string(channels.size());
  map.first_row = FirstRow::top;
  return map;
}

bool recognises(const SourceFile& file) {
  return file.bytes.compare(0, magic.size(), magic) == 0 ||
         file.bytes.compare(0, hdf5_magic.size(), hdf5_magic) == 0;
}

}  // namespace

namespace formats {
TopographyFormat make_matlab() {
  return {"MATLAB (.mat)", {".mat"}, "the text 'MATLAB 5.0 MAT-file'", recognises, read};
}
}  // namespace formats

}  // namespace asperity
