#include "surfaces/readers/stored_numbers.h"

#include "core/error.h"
#include "surfaces/readers/text_parts.h"

namespace asperity {
namespace {

template <class T>
std::vector<double> numbers_of(const std::string& bytes, const StoredGrid& grid) {
  std::vector<double> numbers;
  numbers.reserve(static_cast<std::size_t>(grid.columns * grid.rows));
  for (std::int64_t row = 0; row < grid.rows; ++row) {
    const std::size_t begin = grid.begin + static_cast<std::uint64_t>(row) * grid.bytes_per_row();
    for (std::int64_t column = 0; column < grid.columns; ++column)
      numbers.push_back(static_cast<double>(
          stored_number<T>(bytes, begin + static_cast<std::size_t>(column) * sizeof(T), grid.order)));
  }
  return numbers;
}

}  // namespace

std::size_t bytes_of(NumberType type) {
  switch (type) {
    case NumberType::int8:
    case NumberType::uint8:
      return 1;
    case NumberType::int16:
    case NumberType::uint16:
      return 2;
    case NumberType::int32:
    case NumberType::uint32:
    case NumberType::float32:
      return 4;
    case NumberType::int64:
    case NumberType::uint64:
    case NumberType::float64:
      return 8;
  }
  return 8;
}

std::size_t HeaderReader::advance(std::size_t length) {
  const std::size_t size = file_.bytes.size();
  if (at_ > size || length > size - at_)
    throw InputError(file_.name() + " ends inside its " + format_ +
                     " header: it is cut off; copy or export it again");
  at_ += length;
  return at_ - length;
}

std::string HeaderReader::text(std::size_t length) {
  const std::string raw = file_.bytes.substr(advance(length), length);
  return trimmed_text(raw.substr(0, raw.find('\0')));
}

std::uint64_t checked_grid_bytes(const SourceFile& file, const StoredGrid& grid) {
  constexpr std::int64_t most_pixels_along = 1 << 20;
  const std::string pixels = std::to_string(grid.columns) + " x " + std::to_string(grid.rows) + " pixels";
  if (grid.columns < 1 || grid.rows < 1 || grid.columns > most_pixels_along || grid.rows > most_pixels_along)
    throw InputError(file.name() + " announces a map of " + pixels +
                     ", so it is damaged; copy or export it again");
  const std::uint64_t last_row = static_cast<std::uint64_t>(grid.columns) * bytes_of(grid.type);
  const std::uint64_t needed = static_cast<std::uint64_t>(grid.rows - 1) * grid.bytes_per_row() + last_row;
  const std::uint64_t there = file.bytes.size() > grid.begin ? file.bytes.size() - grid.begin : 0;
  if (there < needed)
    throw InputError(file.name() + " has " + std::to_string(there) + " of the " + std::to_string(needed) +
                     " bytes that " + pixels + " take: it is cut off; copy or export it again");
  return needed;
}

std::vector<double> grid_numbers(const SourceFile& file, const StoredGrid& grid) {
  checked_grid_bytes(file, grid);
  switch (grid.type) {
    case NumberType::int8:
      return numbers_of<std::int8_t>(file.bytes, grid);
    case NumberType::uint8:
      return numbers_of<std::uint8_t>(file.bytes, grid);
    case NumberType::int16:
      return numbers_of<std::int16_t>(file.bytes, grid);
    case NumberType::uint16:
      return numbers_of<std::uint16_t>(file.bytes, grid);
    case NumberType::int32:
      return numbers_of<std::int32_t>(file.bytes, grid);
    case NumberType::uint32:
      return numbers_of<std::uint32_t>(file.bytes, grid);
    case NumberType::int64:
      return numbers_of<std::int64_t>(file.bytes, grid);
    case NumberType::uint64:
      return numbers_of<std::uint64_t>(file.bytes, grid);
    case NumberType::float32:
      return numbers_of<float>(file.bytes, grid);
    case NumberType::float64:
      return numbers_of<double>(file.bytes, grid);
  }
  return {};
}

std::vector<double> transposed(const std::vector<double>& stored, std::size_t columns, std::size_t rows) {
  std::vector<double> turned(stored.size());
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column)
      turned[row * columns + column] = stored[column * rows + row];
  return turned;
}

}  // namespace asperity
