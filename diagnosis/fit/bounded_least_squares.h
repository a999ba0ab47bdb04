// Nonlinear least squares within bounds, robust against single bad residuals (Levenberg 1944; Marquardt 1963;
// Huber 1964).
#pragma once

#include <Eigen/Dense>
#include <functional>

namespace asperity {

/// Residuals in units of noise beyond which a residual counts linearly instead of squared.
constexpr double huber_bend = 3;

/// r^2, or 2 k |r| - k^2 beyond the bend k.
/// A residual over its sd [-].
double huber_cost(double residual);

/// Where the search ended.
struct BoundedFit {
  Eigen::VectorXd x;
  double cost = 0;             ///< sum of Huber's costs [-]
  Eigen::MatrixXd covariance;  ///< (J^T W J)^-1; empty if it was not asked for
};

/// When it ends, and what is asked of it.
struct BoundedFitOptions {
  int most_iterations = 15;
  bool covariance = false;
};

/// Minimises the sum of Huber's costs of residuals(x) from `start` with low <= x <= high; x should be of
/// order one.
BoundedFit fit_within_bounds(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& residuals,
                             Eigen::VectorXd start, const Eigen::VectorXd& low, const Eigen::VectorXd& high,
                             const BoundedFitOptions& options = {});

/// Search without derivatives, for residuals that jump as x moves: random steps (Rastrigin 1963) spread as
/// the parabola between the jumps is, from thirty of its standard deviations down to a third. The steps are
/// the same in every call.
BoundedFit search_at_random(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& residuals,
                            const BoundedFit& start, const Eigen::VectorXd& low, const Eigen::VectorXd& high);

}  // namespace asperity
