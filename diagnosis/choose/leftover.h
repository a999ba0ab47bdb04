// What an explanation leaves, and whether that may be called noise.
#pragma once

#include <cstddef>

#include "diagnosis/choose/search.h"
#include "diagnosis/locate/scan.h"

namespace asperity {

/// Probability by which each test calls noise a mismatch [-].
constexpr double significance = 0.001;
/// Largest chi^2 per sample that may be called noise, whatever laws may be off by [-]: a deviation is seldom
/// known better than to a fifth (1.5), and that of noise of `count` samples is exceeded by chance, with the
/// probability `significance`.
double largest_of_noise(std::size_t count);

/// The residual of an explanation, beyond the model error of its laws.
ScanResult remaining(const FitProblem& problem, const ModelFit& baseline, const Scanner& scanner,
                     const ModelFit& fit);
/// Whether that is noise: nowhere more than chance has it, and no more on the whole.
bool leaves_noise(const FitProblem& problem, const SearchResult& search, const Scanner& scanner,
                  const Candidate& candidate);
/// Whether the simulation alone leaves noise, with the scan of what it leaves. Steady waves look like noise
/// that neighbours share, but for their size and their line in the spectrum.
bool is_noise_as_known(const FitProblem& problem, const ScanResult& before, std::size_t count);

}  // namespace asperity
