#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnosis/fit/bounded_least_squares.h"
#include "diagnosis/fit/fit_residuals.h"
#include "diagnosis/fit/model_fit.h"

namespace asperity {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Residuals = std::function<VectorXd(const VectorXd&)>;

constexpr double rise = 4;      // cost at two standard deviations
constexpr double nearly = 1.3;  // a parabola's width within this factor is believed
constexpr double found = 1.1;   // ends are bracketed to this factor
constexpr double widest = 64;

/// The cost about a fit, as one of its parameters moves away from it.
class Valley {
 public:
  /// Refers to all but the last two. along: how the others follow that parameter, by one of its deviations.
  Valley(const Residuals& residuals, const Coordinates& bounds, const VectorXd& fit, double least,
         double inflation, Index moved, VectorXd along)
      : residuals_(residuals),
        bounds_(bounds),
        fit_(fit),
        least_(least),
        inflation_(inflation),
        moved_(moved),
        along_(std::move(along)),
        floor_(fit) {}

  /// Rise of the cost [-] that many deviations away, the others following.
  double straight(double deviations) const {
    return rise_of(huber_sum(residuals_(within(fit_ + deviations * along_))));
  }

  /// The same with the others fitted anew, from where they were at the last call.
  double along_floor(double deviations) {
    const VectorXd straight = within(fit_ + deviations * along_);
    if (fit_.size() == 1) return rise_of(huber_sum(residuals_(straight)));
    const double so_far = floor_[moved_] - fit_[moved_], to = straight[moved_] - fit_[moved_];
    const VectorXd onward = so_far == 0 ? straight : within(fit_ + (to / so_far) * (floor_ - fit_));
    BoundedFit best = refitted(straight);
    if (so_far != 0) {
      BoundedFit other = refitted(onward);
      if (other.cost < best.cost) best = std::move(other);
    }
    floor_ = best.x;
    return rise_of(best.cost);
  }

 private:
  VectorXd within(const VectorXd& x) const { return x.cwiseMax(bounds_.low).cwiseMin(bounds_.high); }
  double rise_of(double cost) const { return (cost - least_) / inflation_; }

  /// From there on, with the parameter held.
  BoundedFit refitted(const VectorXd& from) const {
    const auto without = [&](const VectorXd& x) {
      VectorXd rest(x.size() - 1);
      rest << x.head(moved_), x.tail(x.size() - 1 - moved_);
      return rest;
    };
    const auto with = [&](const VectorXd& rest) {
      VectorXd x(rest.size() + 1);
      x << rest.head(moved_), from[moved_], rest.tail(rest.size() - moved_);
      return x;
    };
    BoundedFitOptions options;
    options.most_iterations = 4;
    BoundedFit found = fit_within_bounds([&](const VectorXd& rest) { return residuals_(with(rest)); },
                                         without(from), without(bounds_.low), without(bounds_.high), options);
    found.x = with(found.x);
    return found;
  }

  const Residuals& residuals_;
  const Coordinates& bounds_;
  const VectorXd& fit_;
  double least_, inflation_;
  Index moved_;
  VectorXd along_, floor_;
};

/// Whether other parameters make up for nearly all that one changes: such a valley can wind, and the cost
/// along a straight way says little of its floor. Squared multiple correlation, 1 - 1/(C_kk (C^-1)_kk).
bool can_wind(const Eigen::MatrixXd& covariance, Index moved) {
  constexpr double made_up_for = 0.9;
  std::vector<Index> free;
  for (Index k = 0; k < covariance.rows(); ++k)
    if (covariance(k, k) > 0) free.push_back(k);
  if (free.size() < 2) return false;
  Eigen::MatrixXd correlation(free.size(), free.size());
  Index own = 0;
  for (std::size_t i = 0; i < free.size(); ++i) {
    if (free[i] == moved) own = static_cast<Index>(i);
    for (std::size_t j = 0; j < free.size(); ++j)
      correlation(static_cast<Index>(i), static_cast<Index>(j)) =
          covariance(free[i], free[j]) /
          std::sqrt(covariance(free[i], free[i]) * covariance(free[j], free[j]));
  }
  const double left = 1 / correlation.completeOrthogonalDecomposition().pseudoInverse()(own, own);
  return !(left > 1 - made_up_for);
}

/// Of two standard deviations, how much of them the cost takes to rise as much as a parabola does in two.
double stretch_of(Valley valley, int side, bool is_smooth, bool winds) {
  double by_parabola = valley.straight(2 * side);
  // A straight way crosses a snap that a small change of the others keeps where it is.
  if (!is_smooth && by_parabola >= rise) return 1;
  if (is_smooth && winds) by_parabola = std::min(by_parabola, valley.along_floor(2 * side));
  if (is_smooth && by_parabola < rise * nearly * nearly && by_parabola > rise / (nearly * nearly)) return 1;
  const auto rise_at = [&](double factor) {
    return is_smooth ? valley.along_floor(2 * side * factor) : valley.straight(2 * side * factor);
  };
  double low = 1, high = 1;
  if (rise_at(1) < rise) {
    while (high < widest && rise_at(high) < rise) low = high, high *= 2;
  } else {
    while (low > 1 / widest && rise_at(low) >= rise) high = low, low /= 2;
  }
  while (high > found * low) {
    const double middle = std::sqrt(low * high);
    (rise_at(middle) < rise ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

}  // namespace

ModelFit with_intervals(const FitProblem& problem, const ModelFit& fit) {
  ModelFit result = fit;
  const Explanation& explanation = *fit.explanation;
  const auto surface = std::make_shared<LikelySurface>(problem, fit, problem.samples);
  const Coordinates bounds = bounds_of(fit, *surface);
  const Residuals residuals = residuals_of(problem, explanation, problem.samples, surface);
  const double inflation = std::max(1.0, fit.cost / static_cast<double>(std::max<std::size_t>(1, fit.count)));
  const VectorXd x = coordinates_of(explanation, fit.values, *surface);
  const double least = huber_sum(residuals(x));
  for (Index k = 0; k < static_cast<Index>(fit.values.size()); ++k) {
    const double sd = std::sqrt(std::max(0.0, fit.covariance(k, k)));
    std::pair<double, double> stretch{1, 1};
    if (sd > 0) {
      const Valley valley(residuals, bounds, x, least, inflation, k, fit.covariance.col(k) / sd);
      const bool winds = can_wind(fit.covariance, k);
      stretch = {stretch_of(valley, -1, explanation.is_smooth(), winds),
                 stretch_of(valley, 1, explanation.is_smooth(), winds)};
    }
    result.stretch.push_back(stretch);
  }
  return result;
}

}  // namespace asperity
