// Whether a solved contact outgrew its mesh.
#pragma once

#include <string>

#include "results/solved_case.h"

namespace asperity {

/// "its contact came to the edge of the finely meshed region: ..."; "" where it did not.
inline std::string region_edge_words(const SolvedCase& solved) {
  if (!solved.finished() || !solved.result->reaches_rim) return "";
  return "its contact came to the edge of the finely meshed region, beyond which nothing touches: it is too "
         "small and too soft at its largest load; solve it again with a larger Mesh/Contact region";
}

}  // namespace asperity
