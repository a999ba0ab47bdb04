#include "diagnosis/fit/likely_surface.h"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

bool has_other_surfaces(const ModelFit& fit) {
  const auto& correction = fit.explanation->correction();
  return correction && !correction->surface_errors().empty();
}

std::vector<double> to_list(const VectorXd& v) { return {v.data(), v.data() + v.size()}; }

}  // namespace

LikelySurface::LikelySurface(const FitProblem& problem, const ModelFit& fit, const Samples& samples)
    : samples_(samples) {
  if (!has_other_surfaces(fit)) return;
  factors_ = fit.surface;
  factors_.resize(fit.explanation->correction()->surface_errors().size(), 0.0);
  for (std::size_t i = 0; i < samples.list.size(); ++i)
    if (samples.list[i].counts) counted_.push_back(i);
  const NoiseFilter filter(samples, problem.noise.sd, problem.noise.shared);
  constexpr int most_rounds = 4;
  constexpr double stays = 0.3;
  for (int round = 0; round < most_rounds; ++round) {
    const VectorXd likely = of_likely_length(linearise(fit, filter));
    likely_ = to_list(likely);
    const VectorXd before = Eigen::Map<const VectorXd>(factors_.data(), likely.size());
    if ((likely - before).cwiseAbs().maxCoeff() < stays || round + 1 == most_rounds) break;
    factors_ = likely_;
  }
}

VectorXd LikelySurface::linearise(const ModelFit& fit, const NoiseFilter& filter) {
  const auto at = asperity::simulate(on_surface(*fit.explanation, factors_)->mechanics(fit.values), samples_);
  changes_.clear();
  shift_.assign(at.size(), 0.0);
  for (std::size_t k = 0; k < factors_.size(); ++k) {
    std::vector<double> beside = factors_;
    // Towards none, where the curve is known best.
    const double step = factors_[k] > 0 ? -1 : 1;
    beside[k] += step;
    const auto off =
        asperity::simulate(on_surface(*fit.explanation, beside)->mechanics(fit.values), samples_);
    LawError change(at.size(), 0.0);
    for (const std::size_t i : counted_)
      if (std::isfinite(off[i] - at[i])) change[i] = (off[i] - at[i]) / step;
    if (k + 1 < factors_.size())
      for (std::size_t i = 0; i < at.size(); ++i) shift_[i] += change[i] * factors_[k];
    changes_.push_back(std::move(change));
  }
  MatrixXd S(static_cast<Eigen::Index>(counted_.size()), static_cast<Eigen::Index>(changes_.size()));
  for (std::size_t k = 0; k < changes_.size(); ++k)
    for (std::size_t row = 0; row < counted_.size(); ++row)
      S(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(k)) = changes_[k][counted_[row]];
  filter.whiten(counted_, S);
  weigh(S.leftCols(S.cols() - 1));
  const auto white = filter.whitened(FitProblem::residual(samples_, simulated(*fit.explanation, fit.values)));
  return likely_part(S, Eigen::Map<const VectorXd>(white.data(), S.rows())).coefficients;
}

void LikelySurface::weigh(const MatrixXd& shapes) {
  constexpr double nothing = 1e-6;  // of a variance of one: such directions have no axis
  shrink_.resize(0);
  if (shapes.size() == 0) return;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(shapes.transpose() * shapes);
  const Eigen::Index some = (eigen.eigenvalues().array() > nothing).count();
  const VectorXd sizes = eigen.eigenvalues().tail(some);
  axes_ = shapes * eigen.eigenvectors().rightCols(some) * sizes.cwiseSqrt().cwiseInverse().asDiagonal();
  shrink_ = 1 - (1 + sizes.array()).sqrt().inverse();
}

std::shared_ptr<const Explanation> LikelySurface::explanation(const ModelFit& fit) const {
  return likely_.empty() ? fit.explanation : on_surface(*fit.explanation, likely_);
}

std::vector<double> LikelySurface::simulated_at(double zero, const Explanation& explanation,
                                                const std::vector<double>& values) const {
  std::vector<double> factors = factors_;
  factors.back() = zero;
  auto response = asperity::simulate(on_surface(explanation, factors)->mechanics(values), samples_);
  for (std::size_t i = 0; i < response.size(); ++i) response[i] -= shift_[i];
  return response;
}

std::vector<double> LikelySurface::simulated(const Explanation& explanation,
                                             const std::vector<double>& values) const {
  if (factors_.empty()) return asperity::simulate(explanation.mechanics(values), samples_);
  auto response = simulated_at(factors_.back(), explanation, values);
  for (std::size_t i = 0; i < response.size(); ++i) response[i] -= changes_.back()[i] * factors_.back();
  return response;
}

VectorXd LikelySurface::independent(const VectorXd& whitened) const {
  if (shrink_.size() == 0) return whitened;
  return whitened - axes_ * shrink_.cwiseProduct(axes_.transpose() * whitened);
}

std::vector<double> simulated_on_likely_surface(const FitProblem& problem, const ModelFit& fit,
                                                const Samples& learned_from) {
  const LikelySurface surface(problem, fit, learned_from);
  return asperity::simulate(surface.explanation(fit)->mechanics(fit.values), problem.samples);
}

std::vector<double> residual_beyond_surfaces(const FitProblem& problem, const ModelFit& fit) {
  if (!has_other_surfaces(fit)) return fit.residual(problem.samples);
  return FitProblem::residual(problem.samples, simulated_on_likely_surface(problem, fit, problem.samples));
}

}  // namespace asperity
