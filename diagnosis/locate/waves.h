// A wave of one frequency in what a fit leaves. Of noise that neighbours share, differences between samples
// look the same; its spectrum is smooth, and that of a wave has a line.
#pragma once

#include <vector>

#include "diagnosis/fit/noise.h"

namespace asperity {

/// Period, in samples, of the line that stands out most of the spectrum of the whitened residual (mean of
/// periodograms, Welch 1967) over the median of what lies about it; 0: noise has such lines more often than
/// once in a million recordings, or the runs are too short. Looked for from 3 to 40 samples. [samples]
double wave_left(const Samples& samples, const std::vector<double>& residual, const Noise& noise);

}  // namespace asperity
