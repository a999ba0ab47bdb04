#include "dem_compare/cases/common_label.h"

#include <algorithm>

#include "core/joined.h"
#include "core/text_pieces.h"

namespace asperity {
namespace {

/// Words with which all texts begin.
std::string common_beginning(const std::vector<std::string>& texts) {
  std::vector<std::string> common = pieces_of(texts.front(), " ");
  for (const auto& text : texts) {
    const auto words = pieces_of(text, " ");
    common.erase(std::mismatch(common.begin(), common.end(), words.begin(), words.end()).first, common.end());
  }
  return joined(common, " ");
}

}  // namespace

std::string common_label(const std::vector<std::string>& labels) {
  std::string common;
  for (std::size_t i = 0; i < pieces_of(labels.front(), ", ").size(); ++i) {
    std::vector<std::string> parts;
    for (const auto& label : labels) {
      const auto own = pieces_of(label, ", ");
      parts.push_back(i < own.size() ? own[i] : "");
    }
    const std::string part = common_beginning(parts);
    if (!part.empty()) common += (common.empty() ? "" : ", ") + part;
  }
  return common.empty() ? labels.front() : common;
}

}  // namespace asperity
