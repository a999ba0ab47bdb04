// Text of a file or a person on one line, for messages and comments.
#pragma once

#include <functional>
#include <string>

namespace asperity {

/// Visible ASCII as it is. Line breaks as \n and \r, other control characters and bytes that are no UTF-8 as
/// \x1b, all other characters as \u00b5 or \U0001d400: nothing ends the line, hides or turns its direction.
std::string printable(const std::string& text);

/// The same for a person at a terminal: lines and visible characters of all scripts stay; control characters,
/// those that turn the direction of writing or take no room, and bytes that are no UTF-8 are escaped.
std::string printable_lines(const std::string& text);

/// One character of a text in UTF-8.
struct CodePoint {
  char32_t value = 0;
  bool is_valid = true;  ///< else `value` is a byte that is no UTF-8
  bool is_visible_ascii() const { return is_valid && value >= 0x20 && value < 0x7f; }
};
void for_each_code_point(const std::string& text, const std::function<void(const CodePoint&)>& action);

/// \x1b, \u00b5 or \U0001d400, as C, C++ and Python write it.
std::string escape_sequence(const CodePoint& character);

}  // namespace asperity
