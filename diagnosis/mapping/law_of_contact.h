// The reduced law of the contact that a fit is of, which its solution is set beside.
#pragma once

#include "diagnosis/fit/model_fit.h"

namespace asperity {

/// Without what measures it and without a correction.
Mechanics reduced_law(const FitProblem& problem, const ModelFit& fit);
/// The same with the values that the case was solved with (Effect::values_as_solved).
Mechanics reduced_law_as_solved(const FitProblem& problem, const ModelFit& fit);

}  // namespace asperity
