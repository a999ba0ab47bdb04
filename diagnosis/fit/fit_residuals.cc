#include "diagnosis/fit/fit_residuals.h"

#include <cmath>

namespace asperity {

using Eigen::VectorXd;

Coordinates bounds_of(const ModelFit& fit, const LikelySurface& surface) {
  constexpr double farthest_zero = 5;  // standard deviations
  const auto& parameters = fit.explanation->parameters();
  const auto count = static_cast<Eigen::Index>(parameters.size()) + (surface.is_another() ? 1 : 0);
  Coordinates b{VectorXd::Constant(count, -farthest_zero), VectorXd::Constant(count, farthest_zero)};
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const FreeParameter& p = parameters[k];
    b.low[static_cast<Eigen::Index>(k)] = p.coordinate(fit.is_held(k) ? p.absent : p.low);
    b.high[static_cast<Eigen::Index>(k)] = p.coordinate(fit.is_held(k) ? p.absent : p.high);
  }
  return b;
}

VectorXd coordinates_of(const Explanation& explanation, const std::vector<double>& values,
                        const LikelySurface& surface) {
  VectorXd x(static_cast<Eigen::Index>(values.size()) + (surface.is_another() ? 1 : 0));
  for (std::size_t k = 0; k < values.size(); ++k)
    x[static_cast<Eigen::Index>(k)] = explanation.parameters()[k].coordinate(values[k]);
  if (surface.is_another()) x[x.size() - 1] = surface.factors().back();
  return x;
}

std::vector<double> values_at(const Explanation& explanation, const VectorXd& x) {
  std::vector<double> values;
  for (std::size_t k = 0; k < explanation.parameters().size(); ++k)
    values.push_back(explanation.parameters()[k].value(x[static_cast<Eigen::Index>(k)]));
  return values;
}

std::vector<double> surface_at(const LikelySurface& surface, const VectorXd& x) {
  std::vector<double> factors = surface.factors();
  if (!factors.empty()) factors.back() = x[x.size() - 1];
  return factors;
}

std::function<VectorXd(const VectorXd&)> residuals_of(const FitProblem& problem,
                                                      const Explanation& explanation, const Samples& samples,
                                                      const std::shared_ptr<const LikelySurface>& surface) {
  const auto filter = std::make_shared<NoiseFilter>(samples, problem.noise.sd, problem.noise.shared);
  return [&samples, &explanation, filter, surface](const VectorXd& x) {
    const auto values = values_at(explanation, x);
    const double zero = surface->is_another() ? x[x.size() - 1] : 0;
    const auto simulated = surface->is_another() ? surface->simulated_at(zero, explanation, values)
                                                 : simulate(explanation.mechanics(values), samples);
    const auto list = filter->whitened(FitProblem::residual(samples, simulated));
    VectorXd white = Eigen::Map<const VectorXd>(list.data(), static_cast<Eigen::Index>(list.size()));
    constexpr double absurd = 1e6;
    for (Eigen::Index i = 0; i < white.size(); ++i)
      if (!std::isfinite(white[i])) white[i] = absurd;
    if (!surface->is_another()) return white;
    VectorXd with_zero(white.size() + 1);
    with_zero << surface->independent(white), zero;
    return with_zero;
  };
}

double huber_sum(const VectorXd& r) {
  double sum = 0;
  for (Eigen::Index i = 0; i < r.size(); ++i) sum += huber_cost(r[i]);
  return sum;
}

}  // namespace asperity
