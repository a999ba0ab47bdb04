// Residuals of an explanation over the coordinates in which a fit searches: its parameters, and last the zero
// of the displacement where another surface moves it (likely_surface.h).
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <memory>
#include <vector>

#include "diagnosis/fit/likely_surface.h"

namespace asperity {

/// Bounds of the search; the same above and below of a parameter that is held.
struct Coordinates {
  Eigen::VectorXd low, high;
};
Coordinates bounds_of(const ModelFit& fit, const LikelySurface& surface);

/// Of these values, and of the surface's zero.
Eigen::VectorXd coordinates_of(const Explanation& explanation, const std::vector<double>& values,
                               const LikelySurface& surface);
/// The values of the parameters there.
std::vector<double> values_at(const Explanation& explanation, const Eigen::VectorXd& x);
/// The factors of the surface there.
std::vector<double> surface_at(const LikelySurface& surface, const Eigen::VectorXd& x);

/// Independent residuals of unit variance, the last that of the zero. Refers to explanation and samples.
std::function<Eigen::VectorXd(const Eigen::VectorXd&)> residuals_of(
    const FitProblem& problem, const Explanation& explanation, const Samples& samples,
    const std::shared_ptr<const LikelySurface>& surface);

/// Sum of Huber's costs [-].
double huber_sum(const Eigen::VectorXd& residuals);

}  // namespace asperity
