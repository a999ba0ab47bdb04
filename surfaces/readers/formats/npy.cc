// Arrays of NumPy (.npy), versions 1 to 3: after "\x93NUMPY" and the version the length of a header, which is
// the text of a Python dictionary with 'descr' (byte order, kind and bytes of a number), 'fortran_order' and
// 'shape', then the numbers (NumPy's documentation, numpy.lib.format). Sizes and units are not stored; the
// first index runs down the rows of the image, as matplotlib's imshow shows it.
#include <regex>

#include "core/error.h"
#include "surfaces/readers/channels.h"
#include "surfaces/readers/format.h"
#include "surfaces/readers/height_unit.h"
#include "surfaces/readers/stored_numbers.h"

namespace asperity {
namespace {

const std::string magic = "\x93NUMPY";

/// What the header's dictionary says.
struct NpyArray {
  std::string type;
  bool columns_first = false;  ///< as Fortran stores matrices
  std::vector<std::int64_t> shape;
  std::size_t begin = 0;
};

std::string entry(const SourceFile& file, const std::string& header, const std::string& form) {
  std::smatch found;
  if (!std::regex_search(header, found, std::regex(form)))
    throw InputError(file.name() +
                     " has a NumPy header that cannot be read; save the array again with numpy.save");
  return found[1];
}

NpyArray header_of(const SourceFile& file) {
  HeaderReader reader(file, "NumPy", ByteOrder::little, magic.size());
  const int version = reader.next<std::uint8_t>();
  reader.skip(1);  // minor version
  const std::size_t length = version == 1 ? reader.next<std::uint16_t>() : reader.next<std::uint32_t>();
  constexpr std::size_t longest = 4096;  // characters: std::regex recurses from one to the next
  if (length > longest)
    throw InputError(file.name() +
                     " has a NumPy header of many fields, so it is no map; save a plain array of heights");
  const std::string header = reader.text(length);
  NpyArray array;
  array.begin = reader.at();
  array.type = entry(file, header, R"('descr'\s*:\s*'([^']*)')");
  array.columns_first = entry(file, header, R"('fortran_order'\s*:\s*(True|False))") == "True";
  std::string shape = entry(file, header, R"('shape'\s*:\s*\(([0-9,\s]*)\))");
  static const std::regex number("[0-9]{1,9}");
  for (std::sregex_iterator it(shape.begin(), shape.end(), number), end; it != end; ++it)
    array.shape.push_back(std::stoll(it->str()));
  return array;
}

NumberType number_type(const SourceFile& file, const std::string& type) {
  static const std::vector<std::pair<std::string, NumberType>> types{
      {"f4", NumberType::float32}, {"f8", NumberType::float64}, {"i1", NumberType::int8},
      {"u1", NumberType::uint8},   {"i2", NumberType::int16},   {"u2", NumberType::uint16},
      {"i4", NumberType::int32},   {"u4", NumberType::uint32},  {"i8", NumberType::int64},
      {"u8", NumberType::uint64}};
  for (const auto& [name, number] : types)
    if (type.size() == 3 && type.substr(1) == name) return number;
  throw InputError(file.name() + " holds numbers of type '" + type +
                   "', which are no plain heights; save the array as float64 with numpy.save");
}

StoredMap read(const SourceFile& file, const ReadOptions& options) {
  const NpyArray array = header_of(file);
  if (array.shape.size() != 2)
    throw InputError(file.name() + " holds an array of " + std::to_string(array.shape.size()) +
                     " dimension(s) and no map; save a two-dimensional array of heights");
  choose_channel(file, {{"heights", "", true}}, options);
  StoredGrid grid;
  grid.begin = array.begin;
  grid.type = number_type(file, array.type);
  grid.order = array.type[0] == '>' ? ByteOrder::big : ByteOrder::little;
  grid.rows = array.shape[array.columns_first ? 1 : 0];
  grid.columns = array.shape[array.columns_first ? 0 : 1];
  StoredMap map;
  const double unit = height_unit(file, "", options, map);
  std::vector<double> numbers = grid_numbers(file, grid);
  map.nx = static_cast<int>(array.shape[1]);
  map.ny = static_cast<int>(array.shape[0]);
  map.heights = array.columns_first ? transposed(numbers, map.nx, map.ny) : std::move(numbers);
  for (double& height : map.heights) height *= unit;
  map.note += "; the array's first index runs down the image";
  map.first_row = FirstRow::top;
  return map;
}

bool recognises(const SourceFile& file) { return file.bytes.compare(0, magic.size(), magic) == 0; }

}  // namespace

namespace formats {
TopographyFormat make_npy() {
  return {"NumPy array (.npy)", {".npy"}, "the mark '\\x93NUMPY'", recognises, read};
}
}  // namespace formats

}  // namespace asperity
