#include "surfaces/readers/netcdf_classic.h"

#include <algorithm>
#include <vector>

namespace asperity {
namespace {

struct EndOfHeader {};

constexpr std::uint64_t beyond_any_file = std::uint64_t{1} << 62;

/// Big-endian entries of the header, one after the other.
class HeaderCursor {
 public:
  explicit HeaderCursor(const std::string& bytes) : bytes_(bytes) {
    constexpr char cdf2 = 2, cdf5 = 5;
    const char version = bytes.size() > magic_size - 1 ? bytes[magic_size - 1] : 0;
    counts_are_wide_ = version == cdf5;
    offsets_are_wide_ = version == cdf2 || version == cdf5;
    at_ = magic_size;
  }
  std::uint64_t unsigned_number(int size) {
    const std::size_t begin = advance(size);
    std::uint64_t value = 0;
    for (int i = 0; i < size; ++i) value = value << 8 | static_cast<unsigned char>(bytes_[begin + i]);
    return value;
  }
  std::uint64_t count() { return unsigned_number(counts_are_wide_ ? 8 : 4); }
  std::uint64_t offset() { return unsigned_number(offsets_are_wide_ ? 8 : 4); }
  /// Numbers of a list, whose tag may say that it is absent.
  std::uint64_t list_length() {
    unsigned_number(4);
    return count();
  }
  void skip(std::uint64_t bytes) {
    constexpr std::uint64_t alignment = 4;
    advance((bytes + alignment - 1) / alignment * alignment);
  }
  void skip_name() { skip(count()); }

 private:
  static constexpr std::size_t magic_size = 4;
  std::size_t advance(std::uint64_t size) {
    if (at_ > bytes_.size() || size > bytes_.size() - at_) throw EndOfHeader{};
    at_ += size;
    return at_ - size;
  }
  const std::string& bytes_;
  std::size_t at_ = 0;
  bool counts_are_wide_ = false, offsets_are_wide_ = false;
};

std::uint64_t type_size(std::uint64_t type) {
  static const std::vector<std::uint64_t> sizes{0, 1, 1, 2, 4, 4,
                                                8, 1, 2, 4, 8, 8};  // byte char short int float double ...
  return type < sizes.size() ? sizes[type] : 0;
}

/// Of sizes in a header, where one that overflows is beyond any file.
std::uint64_t product(std::uint64_t a, std::uint64_t b) {
  std::uint64_t result = 0;
  return __builtin_mul_overflow(a, b, &result) ? beyond_any_file : std::min(result, beyond_any_file);
}

void skip_attributes(HeaderCursor& cursor) {
  for (std::uint64_t left = cursor.list_length(); left > 0; --left) {
    cursor.skip_name();
    const std::uint64_t type = cursor.unsigned_number(4);
    cursor.skip(product(cursor.count(), type_size(type)));
  }
}

std::uint64_t end_of_variables(HeaderCursor cursor) {
  const std::uint64_t records = cursor.count();
  std::vector<std::uint64_t> dimensions;
  for (std::uint64_t left = cursor.list_length(); left > 0; --left) {
    cursor.skip_name();
    dimensions.push_back(cursor.count());
  }
  skip_attributes(cursor);
  std::uint64_t end = 0;         // of what has a fixed size
  std::uint64_t record_end = 0;  // of the first record, in which each growing variable has a part
  std::uint64_t record_size = 0;
  for (std::uint64_t left = cursor.list_length(); left > 0; --left) {
    cursor.skip_name();
    std::uint64_t points = 1;
    bool grows = false;
    for (std::uint64_t axes = cursor.count(), axis = 0; axis < axes; ++axis) {
      const std::uint64_t dimension = cursor.count();
      const std::uint64_t length = dimension < dimensions.size() ? dimensions[dimension] : 0;
      if (axis == 0 && length == 0)
        grows = true;  // one part in each record
      else
        points = product(points, length);
    }
    skip_attributes(cursor);
    const std::uint64_t size = product(points, type_size(cursor.unsigned_number(4)));
    cursor.count();  // padded size
    const std::uint64_t part_end = std::min(cursor.offset(), beyond_any_file) + size;
    (grows ? record_end : end) = std::max(grows ? record_end : end, part_end);
    if (grows) record_size += std::min(size, beyond_any_file - std::min(record_size, beyond_any_file));
  }
  if (records > 0 && record_end > 0) end = std::max(end, record_end + product(records - 1, record_size));
  return end;
}

}  // namespace

std::optional<std::uint64_t> netcdf_classic_length(const std::string& bytes) {
  try {
    return end_of_variables(HeaderCursor(bytes));
  } catch (const EndOfHeader&) {
    return std::nullopt;
  }
}

}  // namespace asperity
