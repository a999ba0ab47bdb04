// Is a residual noise, and if not, where is it not? In every bin of every view the mean residual, and its
// mean square, are held against those of simulated noise with the same standard deviation and correlation;
// runs of bins that stand out together are regions, found as the segments of largest sum of (T - c) (Ruzzo &
// Tompa 1999), T the square of the bin's departure in units of its own standard deviation. The p-value of a
// region is the share of simulated noise in which any region anywhere is as large; beyond the simulated ones,
// by an exponential tail.
#pragma once

#include <vector>

#include "diagnosis/fit/noise.h"
#include "diagnosis/locate/views.h"
#include "diagnosis/outcome/diagnosis.h"

namespace asperity {

/// How far a residual is from noise, and where.
struct ScanResult {
  double p_value = 1;                   ///< that noise alone departs as much anywhere [-]
  std::vector<MismatchRegion> regions;  ///< those unlikely to be noise, the largest first
  double chi2_reduced = 0;              ///< mean of (residual/sd)^2 [-]
};

/// Mean residual over sd in a bin, and its mean square [-].
struct BinMoments {
  double mean = 0, square = 0;  ///< [-]
};

/// Noise simulated once for all scans of the same recording.
class Scanner {
 public:
  Scanner(const Samples& samples, const Experiment& experiment, const Noise& noise, unsigned seed);
  /// `tolerated`: what the laws themselves may be off by, of each sample; 0 or empty: nothing.
  ScanResult scan(const std::vector<double>& residual, const std::vector<double>& tolerated = {}) const;

 private:
  struct BinScale {
    double mean = 0;    ///< standard deviation of the mean residual over sd
    double square = 0;  ///< standard deviation of the mean square
  };
  const Samples& samples_;
  const Noise& noise_;
  std::vector<View> views_;
  std::vector<std::vector<BinScale>> scales_;
  std::vector<double> noise_scores_;  ///< largest region of each simulated noise, ascending
  double p_value(double score) const;
  /// Square of how far a bin is from noise, in deviations: of its mean, or of its mean square as a normal
  /// variable (Wilson & Hilferty 1931), so that bins of few samples stand out no more often than others.
  /// `allowed`: mean square of what laws may be off by.
  static double departure(const BinMoments& m, const BinScale& scale, double allowed);
  /// How far each bin of a view departs from noise, less the background.
  std::vector<double> excess_of_bins(std::size_t view, const std::vector<double>& ratio,
                                     const std::vector<double>& allowance) const;
};

/// chi^2 over the number of samples that count.
/// A pure number [-].
double chi2_reduced(const Samples& samples, const std::vector<double>& residual, const Noise& noise);

}  // namespace asperity
