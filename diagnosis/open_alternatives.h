// Explanations that no solution excludes and none confirms, as a diagnosis lists them.
#pragma once

#include "diagnosis/mapping/open_set.h"
#include "diagnosis/outcome/diagnosis.h"

namespace asperity {

/// Parameters and held-out figure from the part that was solved. baseline: the simulation by itself.
/// all_weights: sum over what is listed [-].
AlternativeExplanation alternative_left_open(const FitProblem& problem, const ModelFit& baseline,
                                             const OpenSet& set, double all_weights);

/// Those that stay open beside an explanation; clean: it leaves noise, so that a set which has all of it and
/// more and is not clearly ahead is no rival of it.
std::vector<const OpenSet*> open_beside(const std::vector<OpenSet>& sets, const ModelFit& chosen, bool clean);

/// Where nothing is named: those that could explain the recording, the likeliest first; not one that has all
/// of another and more and is not clearly ahead of it.
std::vector<AlternativeExplanation> alternatives_left_open(const FitProblem& problem,
                                                           const ModelFit& baseline,
                                                           const std::vector<OpenSet>& sets);

}  // namespace asperity
