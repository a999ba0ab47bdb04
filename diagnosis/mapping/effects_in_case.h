// Which effects of a set are solved by finite elements.
#pragma once

#include <vector>

#include "diagnosis/catalogue/effect.h"

namespace asperity {

inline std::vector<const Effect*> in_case(const std::vector<const Effect*>& effects,
                                          const Experiment& experiment) {
  std::vector<const Effect*> found;
  for (const Effect* effect : effects)
    if (effect->enters_by(experiment) == EntersBy::finite_elements) found.push_back(effect);
  return found;
}

}  // namespace asperity
