#include "dem_compare/cases/common_label.h"

#include <algorithm>

#include "core/joined.h"

namespace asperity {
namespace {

std::vector<std::string> split(const std::string& text, const std::string& separator) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (std::size_t to = 0; (to = text.find(separator, from)) != std::string::npos;
       from = to + separator.size())
    parts.push_back(text.substr(from, to - from));
  parts.push_back(text.substr(from));
  return parts;
}

/// Words with which all texts begin.
std::string common_beginning(const std::vector<std::string>& texts) {
  std::vector<std::string> common = split(texts.front(), " ");
  for (const auto& text : texts) {
    const auto words = split(text, " ");
    common.erase(std::mismatch(common.begin(), common.end(), words.begin(), words.end()).first, common.end());
  }
  return joined(common, " ");
}

}  // namespace

std::string common_label(const std::vector<std::string>& labels) {
  std::string common;
  for (std::size_t i = 0; i < split(labels.front(), ", ").size(); ++i) {
    std::vector<std::string> parts;
    for (const auto& label : labels) {
      const auto own = split(label, ", ");
      parts.push_back(i < own.size() ? own[i] : "");
    }
    const std::string part = common_beginning(parts);
    if (!part.empty()) common += (common.empty() ? "" : ", ") + part;
  }
  return common.empty() ? labels.front() : common;
}

}  // namespace asperity
