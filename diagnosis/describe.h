// What a diagnosis says, put together from its fits: parameters with intervals, qualities, curves, remarks,
// sentences.
#pragma once

#include "diagnosis/choose/held_out.h"
#include "diagnosis/outcome/diagnosis.h"

namespace asperity {

/// Effects of a fit with what their laws may be off by in the intervals. baseline: the simulation by itself.
/// probability [-].
std::vector<DiagnosedEffect> described_effects(const FitProblem& problem, const ModelFit& fit,
                                               const ModelFit& baseline, double probability);

/// Whether an interval that described_effects() gives holds the value with which there is no effect; not
/// asked of those that are `known` to be there.
bool is_described_as_no_effect(const FitProblem& problem, const ModelFit& fit, const ModelFit& baseline,
                               const std::vector<const Effect*>& known);

/// Numbers of what a fit leaves, and of what was held out: deviations as they are, chi-square beyond what is
/// likely of another surface of the case.
FitQuality quality_of(const FitProblem& problem, const ModelFit& fit, const HeldOut& held_out);

/// The deviation of a sample by response channel: the median of its table.
std::map<std::string, NoiseEstimate> described_noise(const FitProblem& problem);

/// Curves for the report.
std::vector<ComparedTable> compared_tables(const Recording& recording, const FitProblem& problem,
                                           const ModelFit& before, const ModelFit& after);

/// The same for every row of every table, those that do not count included.
std::vector<SimulatedRows> simulated_rows(const Recording& recording, const FitProblem& problem,
                                          const ModelFit& before, const ModelFit& after);

/// The verdict in a sentence or two.
std::string in_words(const Diagnosis& diagnosis);

}  // namespace asperity
