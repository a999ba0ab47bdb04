// Numbers of binary formats: a header entry by entry, and grids of numbers of any type, counted against the
// bytes that are there before memory is asked for.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "surfaces/readers/format.h"

namespace asperity {

/// Which byte of a number is stored first: the lowest or the highest.
enum class ByteOrder { little, big };

/// How one number is stored.
enum class NumberType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

/// Bytes of one number.
std::size_t bytes_of(NumberType type);

/// Value of type T stored at `offset`; the caller has checked that it lies inside `bytes`.
template <class T>
T stored_number(const std::string& bytes, std::size_t offset, ByteOrder order) {
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "asperity runs on little-endian machines");
  char raw[sizeof(T)];
  std::memcpy(raw, bytes.data() + offset, sizeof(T));
  if (order == ByteOrder::big) std::reverse(raw, raw + sizeof(T));
  T value;
  std::memcpy(&value, raw, sizeof(T));
  return value;
}

/// Goes through the entries of a binary header.
class HeaderReader {
 public:
  HeaderReader(const SourceFile& file, std::string format, ByteOrder order, std::size_t begin = 0)
      : file_(file), format_(std::move(format)), order_(order), at_(begin) {}

  /// The next entry. Throws InputError where the file ends before it, as do the others.
  template <class T>
  T next() {
    return stored_number<T>(file_.bytes, advance(sizeof(T)), order_);
  }
  /// A text of that many bytes, up to its first NUL, without blanks around it.
  std::string text(std::size_t length);
  void skip(std::size_t length) { advance(length); }
  void go_to(std::size_t offset) { at_ = offset; }
  std::size_t at() const { return at_; }

 private:
  std::size_t advance(std::size_t length);
  const SourceFile& file_;
  std::string format_;
  ByteOrder order_;
  std::size_t at_;
};

/// Where and how the heights of a map lie in a file, before any of it is believed.
struct StoredGrid {
  std::int64_t columns = 0, rows = 0;
  std::uint64_t begin = 0;  ///< byte where the first number lies
  NumberType type = NumberType::float32;
  ByteOrder order = ByteOrder::little;
  std::uint64_t row_bytes = 0;  ///< from one row to the next; 0: rows follow each other without a gap

  std::uint64_t bytes_per_row() const {
    return row_bytes ? row_bytes : static_cast<std::uint64_t>(columns) * bytes_of(type);
  }
};

/// Bytes that the grid takes. Throws InputError for sides that are no numbers of pixels, and where the file
/// ends before the grid does.
std::uint64_t checked_grid_bytes(const SourceFile& file, const StoredGrid& grid);

/// The numbers of the grid row by row as they are stored. Throws what checked_grid_bytes() throws.
std::vector<double> grid_numbers(const SourceFile& file, const StoredGrid& grid);

/// Row by row what is stored column by column: columns and rows are those of the map that is returned.
std::vector<double> transposed(const std::vector<double>& stored, std::size_t columns, std::size_t rows);

}  // namespace asperity
