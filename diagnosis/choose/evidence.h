// The evidence of a set that was fitted: what it leaves, what its laws may be off by, and what it may choose.
#pragma once

#include "diagnosis/choose/search.h"

namespace asperity {

/// Cost of a fitted set, with what its laws state that they may be off by. `baseline`: the fit without any
/// effect.
void cost_explanation(Candidate& candidate, const FitProblem& problem, const LawErrors& laws,
                      const ModelFit& baseline);
/// Scores all sets, tempered by what the best of them leaves; the best first.
void score_all(SearchResult& result, const FitProblem& problem);

/// Costs and scores anew, for noise that is known better.
void rescore(SearchResult& result, const FitProblem& problem);

}  // namespace asperity
