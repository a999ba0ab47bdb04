// The experiment that would separate two explanations: both are simulated under settings an instrument could
// take, and the setting is named in which they differ most in units of noise.
#pragma once

#include <string>

#include "diagnosis/fit/model_fit.h"

namespace asperity {

/// A sentence.
std::string experiment_that_tells_apart(const FitProblem& problem, const ModelFit& one,
                                        const ModelFit& other);

}  // namespace asperity
