// Changed entries of a case as a person reads them.
#pragma once

#include <string>
#include <vector>

#include "core/printed.h"
#include "diagnosis/forward/forward_model.h"

namespace asperity {

/// "Interface/Friction coefficient = 0.3, Mesh/Interface spacing = 2e-08 m"; of none "as it is".
inline std::string in_words(const std::vector<CaseChange>& changes) {
  std::string text;
  for (const auto& change : changes) {
    text += (text.empty() ? "" : ", ") + change.entry + printed(" = %.4g", change.value) +
            (change.unit.empty() ? "" : " " + change.unit);
  }
  return text.empty() ? "as it is" : text;
}

}  // namespace asperity
