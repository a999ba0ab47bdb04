// How much of a residual is noise: standard deviation of each sample, and how much of it neighbours share.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/fit/shared_noise.h"

namespace asperity {

/// A driving channel whose noise the recorded response does not follow: it enters the simulation only.
struct NoiseOfControl {
  std::string channel, response;
  std::size_t table = 0;
  bool by_row = false;     ///< of a series, nothing of which is smoothed
  double sd = 0;           ///< of that channel, as given or as it scatters over neighbours at most [SI]
  double of_response = 0;  ///< what it adds after smoothing, root mean square [unit of the response]
};

struct Noise {
  std::vector<double> sd;           ///< of each sample
  std::vector<SharedNoise> shared;  ///< by run
  std::vector<std::string>
      from;  ///< by table: "given by row", "given", "repeats", "high frequencies", "residuals"
  std::vector<NoiseOfControl> of_control;
  bool is_absolute =
      true;  ///< false where the residuals themselves were taken as noise: no absolute test then
};

/// Standard deviation and correlation of AR(1) noise under a signal that is smooth over a few samples, from
/// second differences at distances of k = 1, 2 and 3 samples: their variance is sigma^2 (6 - 8 rho^k + 2
/// rho^(2k)). Means of the lowest 60 % bear with outliers and with a signal that jumps now and then.
struct ShortScaleNoise {
  double sd = 0, correlation = 0;  ///< sigma in the unit of the residual, rho [-]
  std::size_t count = 0;           ///< of second differences
};
ShortScaleNoise short_scale_noise(const std::vector<std::vector<double>>& blocks);

/// Values of the traces of one table in blocks of contiguous samples that count, of one part each; in the
/// unit of the values.
std::vector<std::vector<double>> blocks_of(const Samples& samples, const std::vector<double>& values,
                                           std::size_t table);

/// From what is given, from repeats, else from the high frequencies of the residuals.
Noise estimate_noise(const Recording& recording, const Samples& samples, const std::vector<double>& residual);

/// What an estimate from second differences may be off by, as a ratio of deviations [-]: where neighbours
/// share a fifth or two of the variance, and where they share most of it.
constexpr double may_be_off = 1.25, most_off = 1.7;
/// With what the residuals of a fit say of it where they are noise: where what they scatter over neighbours
/// is no more than the estimate may be `off` by, deviation and memory by maximum likelihood (the latter alone
/// where the deviation is given). `off`: ratio of deviations [-]. False if nothing changes.
bool refine_noise(const Samples& samples, const std::vector<double>& residual, Noise& noise,
                  double off = may_be_off);

/// What came before a record is not known: a run begins under the lateral force recorded first, and where it
/// reverses later, its samples up to the first sliding do not count (they depend on that force, and all they
/// can tell comes again).
void mark_beginnings(Samples& samples, const Noise& noise);

/// Residuals over noise with what each shares with the one before it taken out: independent, of unit
/// variance.
std::vector<double> whitened(const Samples& samples, const std::vector<double>& residual, const Noise& noise);

/// How much of the variance of a mean the whitened residuals still share with their neighbours: 1 + 2 sum (1
/// - k/(K + 1)) r_k, r_k their autocorrelation at a distance of k (Bartlett 1946; Newey & West 1987); at
/// least 1. What AR(1) does not describe.
double shared_variance(const Samples& samples, const std::vector<double>& residual, const Noise& noise);

/// Whether that is no more than chance leaves in so many samples: three deviations of the sum.
bool neighbours_share_no_more(const Samples& samples, const std::vector<double>& residual, const Noise& noise,
                              std::size_t count);

}  // namespace asperity
