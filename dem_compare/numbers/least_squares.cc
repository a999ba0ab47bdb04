#include "dem_compare/numbers/least_squares.h"

#include <ceres/tiny_solver.h>

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

/// The residuals as Ceres asks for them.
struct ResidualFunction {
  using Scalar = double;
  enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = Eigen::Dynamic };

  bool operator()(const double* p, double* r, double* J) const {
    const Eigen::VectorXd at = Eigen::Map<const Eigen::VectorXd>(p, parameters);
    Eigen::Map<Eigen::VectorXd>(r, rows) = residuals(at);
    if (J) Eigen::Map<Eigen::MatrixXd>(J, rows, parameters) = jacobian(residuals, at, rows);
    return true;
  }
  int NumResiduals() const { return static_cast<int>(rows); }
  int NumParameters() const { return static_cast<int>(parameters); }

  const Residuals& residuals;
  Eigen::Index rows, parameters;
};

}  // namespace

LeastSquaresFit fit_least_squares(const Residuals& residuals, Eigen::VectorXd p) {
  const Eigen::Index rows = residuals(p).size();
  if (rows <= p.size())
    throw WorkError("a fit of " + std::to_string(p.size()) + " numbers needs more than " +
                    std::to_string(rows) + " points; take more load steps");
  using Solver = ceres::TinySolver<ResidualFunction>;
  Solver solver;
  solver.options.max_num_iterations = 200;
  solver.options.parameter_tolerance = 1e-12;
  solver.options.gradient_tolerance = solver.options.function_tolerance = solver.options.cost_threshold =
      0;  // to the last digits
  if (solver.Solve({residuals, rows, p.size()}, &p).status == Solver::HIT_MAX_ITERATIONS)
    throw WorkError("a fit did not converge in " + std::to_string(solver.options.max_num_iterations) +
                    " iterations");
  const Eigen::VectorXd r = residuals(p);
  const Eigen::MatrixXd at_minimum = jacobian(residuals, p, rows);
  const double variance = r.squaredNorm() / static_cast<double>(rows - p.size());
  return {p, variance * (at_minimum.transpose() * at_minimum).inverse(),
          std::sqrt(r.squaredNorm() / static_cast<double>(rows))};
}

}  // namespace asperity
