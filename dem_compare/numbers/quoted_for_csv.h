// A text as one cell of a CSV file, whatever it holds.
#pragma once

#include <string>

namespace asperity {

/// In quotation marks; those within are doubled.
inline std::string quoted_for_csv(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + "\"";
}

}  // namespace asperity
