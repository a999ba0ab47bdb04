#include "results/surface_text.h"

#include <regex>

#include "core/quantity.h"

namespace asperity {

std::string surface_in_one_writing(const std::string& text) {
  static const std::regex blanks(R"(\s+)"), length(R"(([0-9.]+(?:e[+-]?[0-9]+)?) ?(pm|nm|um|mm|m)\b)");
  constexpr int digits = 6;
  std::string rest = std::regex_replace(text, blanks, " "), result;
  for (std::smatch found; std::regex_search(rest, found, length); rest = found.suffix().str())
    result += found.prefix().str() + format_quantity(parse_quantity(found.str(), Dimension::length), Dimension::length, digits);
  return result + rest;
}

std::string surface_without_seed(const std::string& text) {
  static const std::regex seed(R"(,?\s*seed\s*=\s*\d+)");
  return surface_in_one_writing(std::regex_replace(text, seed, ""));
}

}  // namespace asperity
