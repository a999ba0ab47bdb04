// Bytes of UTF-16 for tests.
#pragma once

#include <string>

namespace asperity::test {

enum class Order { little, big };

/// The mark of the byte order, then the characters, none of them beyond U+FFFF.
inline std::string utf16_bytes(const std::u16string& text, Order order) {
  std::string bytes;
  for (const char16_t unit : u'\xFEFF' + text) {
    const char low = static_cast<char>(unit & 0xff), high = static_cast<char>(unit >> 8);
    bytes += order == Order::little ? std::string{low, high} : std::string{high, low};
  }
  return bytes;
}

}  // namespace asperity::test
