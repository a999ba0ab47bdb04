// Small nonlinear least-squares fits with standard errors (Levenberg 1944; Marquardt 1963; the solver is
// Ceres' for small problems).
#pragma once

#include <Eigen/Dense>
#include <functional>

namespace asperity {

/// Where a fit ended, with its errors.
struct LeastSquaresFit {
  Eigen::VectorXd parameters;
  Eigen::MatrixXd covariance;  ///< s^2 (J^T J)^-1 with s^2 from the residuals
  double rms_residual = 0;     ///< root mean square of the residuals, in their unit
};

/// Minimises |residuals(p)|^2 from `start`; residuals and parameters should be of order one.
/// Throws WorkError if there are not more residuals than parameters or no minimum is found.
LeastSquaresFit fit_least_squares(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& residuals,
                                  Eigen::VectorXd start);

}  // namespace asperity
