// Which effects of a set are solved by finite elements.
#pragma once

#include <algorithm>
#include <vector>

#include "diagnosis/catalogue/effect.h"

namespace asperity {

/// Those whose values are entries of the case.
inline std::vector<const Effect*> in_case(const std::vector<const Effect*>& effects,
                                          const Experiment& experiment) {
  std::vector<const Effect*> found;
  for (const Effect* effect : effects)
    if (effect->enters_by(experiment) == EntersBy::finite_elements) found.push_back(effect);
  return found;
}

/// Whether two sets change the same entries of the case.
inline bool have_same_entries(const std::vector<const Effect*>& one, const std::vector<const Effect*>& other,
                              const Experiment& experiment) {
  const auto of_one = in_case(one, experiment), of_other = in_case(other, experiment);
  return std::is_permutation(of_one.begin(), of_one.end(), of_other.begin(), of_other.end());
}

}  // namespace asperity
