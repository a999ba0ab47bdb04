// What is said beside an answer, in sentences.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/choose/judged_sets.h"
#include "diagnosis/outcome/diagnosis.h"

namespace asperity {

/// What limits an answer: noise that is shared or not known, outliers, samples in jumps of the probe.
std::vector<std::string> remarks_on_noise(const FitProblem& problem, std::size_t outliers,
                                          std::size_t in_jumps);
/// Which sets were rejected though they fit, and why.
std::vector<std::string> remarks_on_sets(const JudgedSets& judged);
/// Whether a fit leaves so little that the rows are points of a curve somebody fitted, and no measurements:
/// less than a thirtieth of the deviations that are given for them.
bool lies_on_the_rows(const FitProblem& problem, const ModelFit& fit);
/// What is to be said where a fit leaves less than the noise that is given, beyond chance (chi^2, p < 1e-6);
/// empty: nothing.
std::string remark_on_too_little_noise(const FitProblem& problem, const ModelFit& fit);

/// Effects that were not tried because the recording holds too few values of what they depend on.
std::vector<UntriedEffect> effects_without_data(const Experiment& experiment);

/// Of a wave that the simulation alone leaves, see wave_left(); none: empty.
std::vector<std::string> remarks_on_wave(const FitProblem& problem);
/// That what is nearest is no answer, with how far it comes.
std::vector<std::string> remarks_on_nearest(const Diagnosis& diagnosis);
/// What was not tried, and why, where something was left out.
std::vector<std::string> remarks_on_untried(const Diagnosis& diagnosis);

}  // namespace asperity
