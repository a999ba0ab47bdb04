// Noise of which neighbouring samples share a part: white noise plus a first-order autoregression, as
// amplifiers and filters leave it,
//   y = x + e,   x_k+1 = rho x_k + ...,   var x = share,  var e = 1 - share (in units of the sample's
//   variance),
// so that samples k apart correlate by share rho^k. Whitening is the innovation of Kalman's (1960) filter
// over its standard deviation.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "diagnosis/recording/samples.h"

namespace asperity {

struct SharedNoise {
  double share = 0;                                     ///< of the variance [-]
  double memory = 0;                                    ///< rho [-]
  double neighbours() const { return share * memory; }  ///< correlation of two samples next to each other [-]
};

/// The filter along every run, gaps and samples that do not count included.
class NoiseFilter {
 public:
  /// `sd` by Sample::index, `shared` by run.
  NoiseFilter(const Samples& samples, const std::vector<double>& sd, const std::vector<SharedNoise>& shared);

  /// Independent residuals of unit variance, of the samples that count in their order.
  std::vector<double> whitened(const std::vector<double>& residual) const;
  /// The same of columns; a row for each of these samples, which follow each other in one run.
  void whiten(const std::vector<std::size_t>& samples, Eigen::MatrixXd& columns) const;
  /// Of a sample that counts, among the whitened ones.
  Eigen::Index place(std::size_t sample) const { return place_[sample]; }
  /// Sum of the logarithms of the innovations' variances, over the samples' own.
  /// A pure number [-].
  double log_determinant() const { return log_determinant_; }

 private:
  std::vector<std::size_t> counted_;
  std::vector<Eigen::Index> place_;
  std::vector<double> sd_, decay_, gain_, deviation_;  ///< of each sample
  double log_determinant_ = 0;
};

/// By maximum likelihood from residuals over their noise: what part is shared, over how many samples, and the
/// standard deviation in units of that noise. Memory is at most `largest_memory`: what is correlated over
/// longer is structure. White if that is as likely.
struct MeasuredNoise {
  double sd = 1;
  SharedNoise shared;
};
MeasuredNoise measured_noise(const Samples& samples, const std::vector<double>& residual,
                             const std::vector<double>& sd, std::size_t table);
constexpr double largest_memory = 0.8;

}  // namespace asperity
