// Bytes and numbers appended to a file's content (internal). Little endian, as every machine of Debian's
// amd64.
#pragma once

#include <cstdio>
#include <string>

namespace asperity::meshing {

/// The bytes of a number as they lie in memory.
template <class Number>
void append_bytes(std::string& content, Number number) {
  content.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// 17 digits always give the same double back.
/// The number is written in its own unit.
inline void append_number(std::string& content, double number) {
  char text[32];
  content.append(text, static_cast<std::size_t>(std::snprintf(text, sizeof text, "%.17g", number)));
}

}  // namespace asperity::meshing
