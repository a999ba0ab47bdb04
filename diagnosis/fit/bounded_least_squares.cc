#include "diagnosis/fit/bounded_least_squares.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace asperity {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Residuals = std::function<VectorXd(const VectorXd&)>;

double cost_of(const VectorXd& r) {
  double sum = 0;
  for (Eigen::Index i = 0; i < r.size(); ++i) sum += huber_cost(r[i]);
  return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
}

/// Of simulations with corners (begin of slip, of contact): a step that is too small sees rounding and single
/// samples.
constexpr double smallest_step = 1e-4, largest_step = 0.05;

MatrixXd jacobian(const Residuals& residuals, const VectorXd& x, const VectorXd& r, const VectorXd& low,
                  const VectorXd& high, const VectorXd& steps) {
  MatrixXd J(r.size(), x.size());
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    VectorXd other = x;
    if (low[k] == high[k]) {
      J.col(k).setZero();
      continue;
    }
    const double h = steps[k] * std::max(1.0, std::abs(x[k]));
    other[k] = x[k] + h <= high[k] ? x[k] + h : std::max(low[k], x[k] - h);
    J.col(k) = (residuals(other) - r) / (other[k] - x[k]);
  }
  return J;
}

/// Rows beyond Huber's bend count less.
MatrixXd weighted(const MatrixXd& J, const VectorXd& r) {
  MatrixXd W = J;
  for (Eigen::Index i = 0; i < r.size(); ++i)
    if (std::abs(r[i]) > huber_bend) W.row(i) *= huber_bend / std::abs(r[i]);
  return W;
}

/// Levenberg's step from x down the gradient g; what is at a bound and pushed beyond it stays there.
VectorXd damped_step(const MatrixXd& H, const VectorXd& g, double damping, const VectorXd& x,
                     const VectorXd& low, const VectorXd& high) {
  const auto is_held = [&](Eigen::Index k) {
    return (x[k] <= low[k] && g[k] > 0) || (x[k] >= high[k] && g[k] < 0);
  };
  MatrixXd damped = H;
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    damped(k, k) += damping * H(k, k) + 1e-12;
    if (is_held(k)) {
      damped.row(k).setZero();
      damped.col(k).setZero();
      damped(k, k) = 1;
    }
  }
  VectorXd step = damped.ldlt().solve(-g);
  for (Eigen::Index k = 0; k < x.size(); ++k)
    if (is_held(k)) step[k] = 0;
  return step;
}

/// Once with small steps, then with steps of the size of the standard deviations: the curvature that matters
/// for intervals.
MatrixXd covariance_at(const Residuals& residuals, const VectorXd& x, const VectorXd& r, const VectorXd& low,
                       const VectorXd& high) {
  MatrixXd covariance;
  VectorXd steps = VectorXd::Constant(x.size(), smallest_step);
  for (int round = 0; round < 2; ++round) {
    const MatrixXd J = jacobian(residuals, x, r, low, high, steps);
    MatrixXd H = J.transpose() * weighted(J, r);
    H.diagonal().array() += 1e-12;
    covariance = H.ldlt().solve(MatrixXd::Identity(x.size(), x.size()));
    for (Eigen::Index k = 0; k < x.size(); ++k)
      if (low[k] == high[k]) covariance(k, k) = 0;  // held, and of zero columns: apart from the others
    for (Eigen::Index k = 0; k < x.size(); ++k)
      steps[k] = std::clamp(std::sqrt(std::max(0.0, covariance(k, k))) / std::max(1.0, std::abs(x[k])),
                            smallest_step, largest_step);
  }
  return covariance;
}

}  // namespace

double huber_cost(double r) {
  const double size = std::abs(r);
  return size <= huber_bend ? r * r : 2 * huber_bend * size - huber_bend * huber_bend;
}

BoundedFit fit_within_bounds(const Residuals& residuals, VectorXd x, const VectorXd& low,
                             const VectorXd& high, const BoundedFitOptions& options) {
  constexpr double enough = 1e-5, first_damping = 1e-3, stiffer = 8, softer = 0.2, largest_damping = 1e8;
  x = x.cwiseMax(low).cwiseMin(high);
  VectorXd r = residuals(x);
  double cost = cost_of(r), damping = first_damping;
  if (x.size() == 0) return {x, cost, {}};
  const VectorXd small_steps = VectorXd::Constant(x.size(), smallest_step);
  for (int iteration = 0; iteration < options.most_iterations; ++iteration) {
    const MatrixXd J = jacobian(residuals, x, r, low, high, small_steps);
    const MatrixXd W = weighted(J, r), H = J.transpose() * W;
    const VectorXd g = W.transpose() * r;
    bool moved = false;
    double gained = 0;
    for (; damping < largest_damping; damping *= stiffer) {
      const VectorXd tried = (x + damped_step(H, g, damping, x, low, high)).cwiseMax(low).cwiseMin(high);
      const VectorXd r_tried = residuals(tried);
      const double cost_tried = cost_of(r_tried);
      if (!(cost_tried < cost)) continue;
      gained = cost - cost_tried;
      x = tried;
      r = r_tried;
      cost = cost_tried;
      damping = std::max(1e-9, damping * softer);
      moved = true;
      break;
    }
    if (!moved || gained < enough * std::max(1.0, 1e-3 * cost)) break;
  }
  return {x, cost, options.covariance ? covariance_at(residuals, x, r, low, high) : MatrixXd()};
}

BoundedFit search_at_random(const Residuals& residuals, const BoundedFit& start, const VectorXd& low,
                            const VectorXd& high) {
  constexpr int random_steps = 250;
  constexpr double widest = 30, narrowest = 0.3;  // standard deviations
  BoundedFit best = start;
  if (best.x.size() == 0) return best;
  const VectorXd r = residuals(best.x);
  best.cost = cost_of(r);
  // Between jumps each residual changes smoothly: the middle of what the columns say is not moved by the few
  // that jump.
  const MatrixXd J =
      jacobian(residuals, best.x, r, low, high, VectorXd::Constant(best.x.size(), smallest_step));
  MatrixXd smooth = J;
  for (Eigen::Index k = 0; k < J.cols(); ++k) {
    std::vector<double> sizes(static_cast<std::size_t>(J.rows()));
    for (Eigen::Index i = 0; i < J.rows(); ++i) sizes[static_cast<std::size_t>(i)] = std::abs(J(i, k));
    const auto high_part = sizes.begin() + static_cast<long>(0.9 * static_cast<double>(sizes.size()));
    std::nth_element(sizes.begin(), high_part, sizes.end());
    const double usual = 3 * *high_part;
    smooth.col(k) = J.col(k).cwiseMax(-usual).cwiseMin(usual);
  }
  MatrixXd H = smooth.transpose() * smooth;
  H.diagonal().array() += 1e-9 * std::max(1e-9, H.trace());
  const Eigen::LLT<MatrixXd> factor(H);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int i = 0; i < random_steps; ++i) {
    const double size = widest * std::pow(narrowest / widest, static_cast<double>(i) / random_steps);
    VectorXd by(best.x.size());
    for (Eigen::Index k = 0; k < by.size(); ++k) by[k] = size * normal(random);
    const VectorXd x = (best.x + factor.matrixU().solve(by)).cwiseMax(low).cwiseMin(high);
    const double cost = cost_of(residuals(x));
    if (!(cost < best.cost)) continue;
    best.x = x;
    best.cost = cost;
  }
  return best;
}

}  // namespace asperity
