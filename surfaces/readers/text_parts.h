// Small pieces of text and little-endian numbers that several readers need.
#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// Without blanks, tabs, line ends and no-break spaces at both ends.
std::string trimmed_text(const std::string& text);

/// ASCII letters in lower case.
std::string lower_case(std::string text);

/// The whole text as one number ("nan" is one); empty if it is not.
std::optional<double> whole_number_text(const std::string& text);

/// "2.5" and "um" out of "2.5 um"; empty if it does not begin with a number.
struct NumberWithUnit {
  double number = 0;  ///< in the unit of the text
  std::string unit;
};
std::optional<NumberWithUnit> number_with_unit(const std::string& text);

/// Names in quotes with commas: "'a', 'b'".
std::string quoted_list(const std::vector<std::string>& names);

/// Value of type T stored little-endian at `offset`; the caller has checked that it lies inside `bytes`.
template <class T>
T little_endian(const std::string& bytes, std::size_t offset) {
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "asperity runs on little-endian machines");
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

}  // namespace asperity
