// What the laws of a fit may be off by, carried over to its parameters.
#pragma once

#include <vector>

#include "diagnosis/fit/model_fit.h"

namespace asperity {

/// Half of what a 95 % interval of each parameter gets for the laws, in the parameter's unit. A law may be
/// off by one factor on all that it changes, which its own parameters take up as a part of their values, and
/// by a factor that varies straight along the size of what it changes, or along the record. The parameters of
/// other effects move by as much as a fit does to which that is added (Kennedy & O'Hagan 2001), but by no
/// more than the residuals leave room for. Where responses jump, a fit does not move with small changes: each
/// parameter gets the factors of all laws of the set, as parts of its value.
/// baseline: the simulation by itself.
std::vector<double> half_widths_by_laws(const FitProblem& problem, const ModelFit& fit,
                                        const ModelFit& baseline);

}  // namespace asperity
