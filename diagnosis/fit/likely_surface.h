// The recorded surface is another realisation than the case's, where that is generated: the response of a fit
// is F(z), z_k the factors of the ways in which surfaces differ (BranchCorrection::surface_errors()),
//   recorded = F(z) + noise,   z_k ~ N(0, 1),   F(z) ~ F(z*) + sum_k S_k (z_k - z*_k),
// linear about the likely factors z* (Gauss & Newton). Whitened residuals at z = 0 then have the covariance
// C = 1 + S S^T, by which fits weigh them (generalised least squares, Aitken 1935). The last factor, of the
// displacement's zero, moves the place where force begins to rise, in which nothing is linear: fits search
// for it as for a parameter.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "diagnosis/fit/stated_errors.h"

namespace asperity {

class LikelySurface {
 public:
  /// Begins at the fit's own factors. `samples`: those that it is learned from.
  LikelySurface(const FitProblem& problem, const ModelFit& fit, const Samples& samples);

  /// S_k at each sample, in the unit of the response; none where the case has one surface only.
  const std::vector<LawError>& changes() const { return changes_; }
  /// z*, no longer than such factors are by chance.
  const std::vector<double>& factors() const { return factors_; }
  /// The same explanation on the likely surface, which is near z*.
  std::shared_ptr<const Explanation> explanation(const ModelFit& fit) const;
  /// Whether there is any.
  bool is_another() const { return !factors_.empty(); }
  /// F(z*) - sum_k S_k z*_k of an explanation with these values, at the samples of above.
  std::vector<double> simulated(const Explanation& explanation, const std::vector<double>& values) const;
  /// The same without the last term, at another last factor: `zero` [-].
  std::vector<double> simulated_at(double zero, const Explanation& explanation,
                                   const std::vector<double>& values) const;
  /// C^(-1/2) r of whitened residuals r, all but the last factor in C: independent, of unit variance.
  Eigen::VectorXd independent(const Eigen::VectorXd& whitened) const;

 private:
  /// Linear about z*, which says the likely factors.
  Eigen::VectorXd linearise(const ModelFit& fit, const NoiseFilter& filter);

  /// Axes of all changes but that of the zero, whitened.
  void weigh(const Eigen::MatrixXd& shapes);

  const Samples& samples_;
  std::vector<std::size_t> counted_;
  std::vector<LawError> changes_;
  std::vector<double> factors_;  ///< z*
  std::vector<double> likely_;   ///< z, near which z* is
  std::vector<double> shift_;    ///< sum_k S_k z*_k without the last
  Eigen::MatrixXd axes_;         ///< of S S^T, whitened
  Eigen::VectorXd shrink_;       ///< 1 - 1/sqrt(1 + its eigenvalue)
};

/// What a fit says on the surface that is likely from these samples, at all samples of the problem.
std::vector<double> simulated_on_likely_surface(const FitProblem& problem, const ModelFit& fit,
                                                const Samples& learned_from);
/// Recorded minus that, learned from all samples.
std::vector<double> residual_beyond_surfaces(const FitProblem& problem, const ModelFit& fit);

}  // namespace asperity
