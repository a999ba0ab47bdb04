// Names in a sentence.
#pragma once

#include <string>
#include <vector>

namespace asperity {

/// "a, b, c" with the separator ", "; `none` where there are no names.
inline std::string joined(const std::vector<std::string>& names, const std::string& separator,
                          const std::string& none = "") {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : separator) + name;
  return text.empty() ? none : text;
}

}  // namespace asperity
