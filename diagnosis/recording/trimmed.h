// Text without the blanks and quotation marks around it.
#pragma once

#include <string>
#include <string_view>

namespace asperity {

inline std::string trimmed(std::string_view text) {
  constexpr const char* blank = " \t\r\"";
  const auto first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return "";
  return std::string(text.substr(first, text.find_last_not_of(blank) - first + 1));
}

}  // namespace asperity
