// What the laws of a fit may be off by, carried over to its parameters.
#pragma once

#include <vector>

#include "diagnosis/fit/model_fit.h"

namespace asperity {

/// Half of what a 95 % interval of each parameter gets for the laws, in the parameter's unit. A law may be
/// off by one factor on all that it changes, which its own parameters take up as a part of their values, and
/// by a factor that varies along the data, as the evidence counts it (LawErrors): all parameters get what
/// that adds to the covariance of generalised least squares (Kennedy & O'Hagan 2001). Where responses jump, a
/// fit does not move with small changes: each parameter gets the factors of all laws of the set, as parts of
/// its value. Besides, parameters are known no better than the simulation's own laws
/// (Effect::left_open).
/// baseline: the simulation by itself.
std::vector<double> half_widths_by_laws(const FitProblem& problem, const ModelFit& fit,
                                        const ModelFit& baseline);

}  // namespace asperity
