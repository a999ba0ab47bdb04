#include "diagnosis/fit/model_fit.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/fit/fit_residuals.h"
#include "diagnosis/fit/snaps.h"
#include "diagnosis/recording/median.h"

namespace asperity {
namespace {

using Eigen::VectorXd;

/// Where responses jump, samples between a snap and its place elsewhere outweigh all others, and hold the fit
/// where the snap is: a fit to the usual residuals, the large ones held down.
VectorXd fit_between_snaps(const std::function<VectorXd(const VectorXd&)>& residuals, VectorXd x,
                           const Coordinates& bounds) {
  constexpr int rounds = 2;
  BoundedFitOptions options;
  options.most_iterations = 8;
  for (int round = 0; round < rounds; ++round) {
    const VectorXd sizes = residuals(x).cwiseAbs();
    std::vector<double> sorted(sizes.data(), sizes.data() + sizes.size());
    const double far = huber_bend * std::max(1.0, median(sorted));
    const auto held_down = [&](const VectorXd& at) {
      return VectorXd((residuals(at) / far).array().tanh() * far);
    };
    x = fit_within_bounds(held_down, x, bounds.low, bounds.high, options).x;
  }
  return x;
}

/// Starting points: for each effect its own list (or what `near` found), in all combinations.
std::vector<std::vector<double>> starting_points(const FitProblem& problem, const Explanation& explanation,
                                                 const ModelFit* near) {
  const auto& parameters = explanation.parameters();
  std::vector<std::vector<double>> points{{}};
  const auto extend = [&](const std::vector<std::vector<double>>& options) {
    std::vector<std::vector<double>> longer;
    for (const auto& point : points)
      for (const auto& option : options) {
        longer.push_back(point);
        longer.back().insert(longer.back().end(), option.begin(), option.end());
      }
    points = std::move(longer);
  };
  std::size_t k = 0;
  for (int e = -1; e < static_cast<int>(explanation.effects().size()); ++e) {
    const std::size_t from = k;
    while (k < parameters.size() && parameters[k].effect == e) ++k;
    if (k == from) continue;
    std::vector<std::vector<double>> options;
    const bool jumps = e >= 0 && !explanation.effects()[static_cast<std::size_t>(e)]->description().is_smooth;
    // What a smaller explanation found for this effect, if it holds it.
    if (near) {
      std::vector<double> known;
      for (std::size_t i = from; i < k; ++i)
        if (const double* value = near->value_of(
                parameters[i].name, e < 0 ? nullptr : explanation.effects()[static_cast<std::size_t>(e)]))
          known.push_back(*value);
      if (known.size() == k - from) options.push_back(known);
    }
    if (options.empty() || jumps) {  // where responses jump, what was found may be a poor place to go on from
      std::vector<std::vector<double>> own{{}};
      for (std::size_t i = from; i < k; ++i) {
        std::vector<std::vector<double>> longer;
        for (const auto& option : own)
          for (const double start : parameters[i].starts) {
            longer.push_back(option);
            longer.back().push_back(start);
          }
        own = std::move(longer);
      }
      options.insert(options.end(), own.begin(), own.end());
      if (e >= 0 && !problem.baseline_residual.empty())
        for (auto& start : explanation.effects()[static_cast<std::size_t>(e)]->starts(
                 problem.samples, problem.baseline_residual))
          options.push_back(std::move(start));
    }
    extend(options);
  }
  return points;
}

}  // namespace

std::vector<double> FitProblem::residual(const Samples& samples, const std::vector<double>& simulated) {
  std::vector<double> r(simulated.size());
  for (std::size_t i = 0; i < r.size(); ++i)
    r[i] = samples.list[i].counts ? samples.list[i].response - simulated[i] : 0.0;
  forgive_a_sample_at_snaps(samples, simulated, r);
  return r;
}

std::vector<double> ModelFit::simulate(const Samples& samples) const {
  return asperity::simulate(explanation->mechanics(values), samples);
}

DiagnosedParameter ModelFit::parameter(std::size_t index, double inflation) const {
  constexpr double two_sided_95 = 1.959964;
  const FreeParameter& p = explanation->parameters()[index];
  DiagnosedParameter result{p.name, p.unit, values[index], p.low, p.high};
  if (covariance.size() == 0) return result;
  const auto i = static_cast<Eigen::Index>(index);
  const double half = two_sided_95 * std::sqrt(std::max(0.0, covariance(i, i)) * inflation),
               x = p.coordinate(values[index]);
  if (std::isfinite(half)) {
    constexpr double largest_exponent = 600;
    const double down = stretch.empty() ? 1 : stretch[index].first,
                 up = stretch.empty() ? 1 : stretch[index].second;
    result.low = std::max(p.low, p.value(std::max(x - down * half, -largest_exponent)));
    result.high = std::min(p.high, p.value(std::min(x + up * half, largest_exponent)));
  }
  return result;
}

bool ModelFit::holds_no_effect(double inflation) const {
  const auto& parameters = explanation->parameters();
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const DiagnosedParameter found = parameter(k, inflation);
    if (parameters[k].no_effect >= found.low && parameters[k].no_effect <= found.high) return true;
  }
  return false;
}

ModelFit fit_explanation(const FitProblem& problem, const std::vector<const Effect*>& effects,
                         const ModelFit* near, Freedom freedom) {
  const auto explanation =
      std::make_shared<Explanation>(problem.experiment, problem.choice, effects, problem.correction);
  // From a smaller explanation, most of the values are known. Where responses jump there are many valleys.
  constexpr std::size_t few = 2;  // a third effect mends what the pair leaves, from where the pair stands
  const bool grown = near && !near->explanation->effects().empty(),
             jumps = !explanation->is_smooth() && effects.size() <= few;
  const std::size_t searched = jumps ? 5 : grown && explanation->is_smooth() ? 2 : 3;
  ModelFit fit;
  fit.explanation = explanation;
  for (const FreeParameter& p : explanation->parameters()) {
    const Effect* owner = p.effect < 0 ? nullptr : explanation->effects()[static_cast<std::size_t>(p.effect)];
    const double* known = near ? near->value_of(p.name, owner) : nullptr;
    fit.held.push_back(known ? near->is_held(static_cast<std::size_t>(known - near->values.data()))
                             : freedom == Freedom::as_laws_need && std::isfinite(p.absent));
  }
  const auto points = starting_points(problem, *explanation, near);
  fit.values = points.front();
  const auto surface = std::make_shared<LikelySurface>(problem, near ? *near : fit, problem.thin);
  const Coordinates bounds = bounds_of(fit, *surface);
  const auto thin_residuals = residuals_of(problem, *explanation, problem.thin, surface);
  std::vector<std::pair<double, VectorXd>> starts;
  for (const auto& point : points) {
    const VectorXd x =
        coordinates_of(*explanation, point, *surface).cwiseMax(bounds.low).cwiseMin(bounds.high);
    starts.push_back({huber_sum(thin_residuals(x)), x});
  }
  std::sort(starts.begin(), starts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  BoundedFit best;
  best.cost = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::min(searched, starts.size()); ++i) {
    const VectorXd start =
        jumps ? fit_between_snaps(thin_residuals, starts[i].second, bounds) : starts[i].second;
    const BoundedFit fit = fit_within_bounds(thin_residuals, start, bounds.low, bounds.high);
    if (fit.cost < best.cost) best = fit;
  }
  if (jumps || (!explanation->is_smooth() && (!near || near->explanation->is_smooth())))
    best = search_at_random(thin_residuals, best, bounds.low, bounds.high);
  fit.surface = surface_at(*surface, best.x);
  fit.values = values_at(*explanation, best.x);
  if (!fit.surface.empty()) {
    constexpr int steps_of_own_weights = 8;  // so far those of a smaller explanation
    fit = refitted(problem, fit, problem.thin, false, steps_of_own_weights);
  }
  constexpr int last_steps = 1;  // the optimum on thinned samples is near; finish with refitted()
  return refitted(problem, fit, problem.samples, false,
                  problem.thin.list.size() == problem.samples.list.size() ? 0 : last_steps);
}

ModelFit refitted(const FitProblem& problem, const ModelFit& fit, const Samples& samples, bool covariance,
                  int iterations) {
  const Explanation& explanation = *fit.explanation;
  const auto surface = std::make_shared<LikelySurface>(problem, fit, samples);
  const Coordinates bounds = bounds_of(fit, *surface);
  const VectorXd x = coordinates_of(explanation, fit.values, *surface);
  BoundedFitOptions options;
  options.most_iterations = iterations;
  options.covariance = covariance;
  std::size_t count = 0;
  const auto inner = residuals_of(problem, explanation, samples, surface);
  const auto residuals = [&](const VectorXd& at) {
    VectorXd r = inner(at);
    count = static_cast<std::size_t>(r.size()) - (surface->is_another() ? 1 : 0);
    return r;
  };
  BoundedFit found = fit_within_bounds(residuals, x, bounds.low, bounds.high, options);
  if (covariance && !explanation.is_smooth()) {
    const Eigen::MatrixXd known = found.covariance;
    const auto thin = std::make_shared<LikelySurface>(problem, fit, problem.thin);
    found = search_at_random(residuals_of(problem, explanation, problem.thin, thin), found, bounds.low,
                             bounds.high);
    found.cost = huber_sum(residuals(found.x));
    found.covariance = known;
  }
  ModelFit result = fit;
  result.values = values_at(explanation, found.x);
  result.surface = surface_at(*surface, found.x);
  result.cost = found.cost;
  result.count = count;
  result.stretch.clear();
  if (covariance) result.covariance = found.covariance;
  return result;
}

ModelFit finished(const FitProblem& problem, const ModelFit& fit) {
  constexpr int last_steps = 3;
  return refitted(problem, fit, problem.samples, true, last_steps);
}

}  // namespace asperity
