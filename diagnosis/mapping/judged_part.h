// A set whose solution ended early, judged on the samples that it reached.
#pragma once

#include "diagnosis/choose/search.h"

namespace asperity {

/// By how much log evidence another explanation beats this one on the samples of `part` that count, none of
/// its parameters fitted to them anew [-].
double worse_on_part(const FitProblem& problem, const Samples& part, const ModelFit& fit,
                     const ModelFit& other, double overdispersion);

/// chi^2 per sample of `part` that counts, beyond what mesh and laws may be off by [-].
double chi2_on_part(const FitProblem& problem, const Samples& part, const ModelFit& fit,
                    const ModelFit& baseline);

}  // namespace asperity
