#include "surfaces/readers/text_parts.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "core/text_pieces.h"

namespace asperity {

std::string trimmed_text(const std::string& text) {
  static const std::string no_break_space = "\xC2\xA0";
  std::string plain;
  for (std::size_t from = 0; from <= text.size();) {
    const auto at = std::min(text.find(no_break_space, from), text.size());
    plain.append(text, from, at - from);
    if (at < text.size()) plain += ' ';
    from = at + no_break_space.size();
  }
  const std::string blanks(" \t\r\n\0", 5);
  return trimmed(plain, blanks);
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::optional<double> whole_number_text(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (text.empty() || end != text.c_str() + text.size()) return std::nullopt;
  return number;
}

std::optional<NumberWithUnit> number_with_unit(const std::string& text) {
  const std::string plain = trimmed_text(text);
  char* end = nullptr;
  const double number = std::strtod(plain.c_str(), &end);
  if (end == plain.c_str()) return std::nullopt;
  return NumberWithUnit{number, trimmed_text(end)};
}

std::string quoted_list(const std::vector<std::string>& names) {
  std::string list;
  for (const auto& name : names) list += (list.empty() ? "'" : ", '") + name + "'";
  return list;
}

}  // namespace asperity
