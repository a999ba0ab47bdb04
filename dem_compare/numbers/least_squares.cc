#include "dem_compare/numbers/least_squares.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace asperity {
namespace {

using Residuals = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

Eigen::MatrixXd jacobian(const Residuals& residuals, const Eigen::VectorXd& at, Eigen::Index rows) {
  Eigen::MatrixXd J(rows, at.size());
  for (Eigen::Index i = 0; i < at.size(); ++i) {
    // Central difference: rounding and truncation balance at the cube root of the precision.
    const double h = std::cbrt(std::numeric_limits<double>::epsilon()) * std::max(1.0, std::abs(at[i]));
    Eigen::VectorXd up = at, down = at;
    up[i] += h;
    down[i] -= h;
    J.col(i) = (residuals(up) - residuals(down)) / (2 * h);
  }
  return J;
}

}  // namespace

LeastSquaresFit fit_least_squares(const Residuals& residuals, Eigen::VectorXd p) {
  constexpr int most_iterations = 200;
  constexpr double step_tolerance = 1e-12, first_damping = 1e-3, stiffer = 10, softer = 0.1,
                   largest_damping = 1e12;
  Eigen::VectorXd r = residuals(p);
  if (r.size() <= p.size())
    throw WorkError("a fit of " + std::to_string(p.size()) + " numbers needs more than " +
                    std::to_string(r.size()) + " points; take more load steps");
  double damping = first_damping;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Eigen::MatrixXd J = jacobian(residuals, p, r.size());
    const Eigen::MatrixXd normal = J.transpose() * J;
    Eigen::VectorXd step;
    for (;; damping *= stiffer) {
      Eigen::MatrixXd damped = normal;
      damped.diagonal() *= 1 + damping;
      step = damped.ldlt().solve(-J.transpose() * r);
      const Eigen::VectorXd tried = residuals(p + step);
      if (tried.allFinite() && tried.squaredNorm() <= r.squaredNorm()) {
        p += step;
        r = tried;
        damping *= softer;
        break;
      }
      if (damping > largest_damping) {
        step.setZero();  // no way down is left: rounding
        break;
      }
    }
    if (step.norm() <= step_tolerance * (1 + p.norm())) {
      const double variance = r.squaredNorm() / static_cast<double>(r.size() - p.size());
      const Eigen::MatrixXd at_minimum = jacobian(residuals, p, r.size());
      return {p, variance * (at_minimum.transpose() * at_minimum).inverse(),
              std::sqrt(r.squaredNorm() / static_cast<double>(r.size()))};
    }
  }
  throw WorkError("a fit did not converge in " + std::to_string(most_iterations) + " iterations");
}

}  // namespace asperity
