// What samples far off the surface show by themselves: there is no contact, so that what is recorded there is
// the instrument's own.
#pragma once

#include <vector>

#include "diagnosis/fit/model_fit.h"

namespace asperity {

/// Those of some effects that belong to the instrument and are plain in the samples farther off than the
/// surface was pressed in; none where too few are. `baseline`: the fit without any effect.
std::vector<const Effect*> shown_off_contact(const FitProblem& problem, const ModelFit& baseline,
                                             const std::vector<const Effect*>& effects);

}  // namespace asperity
