#include "diagnosis/choose/law_shifts.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/choose/law_error.h"

namespace asperity {
namespace {

/// What a law may be off by at 95 %, as a part of its accuracy [-].
constexpr double off_in_scale = 0.7;
/// Of a law whose accuracy is a bound: one standard deviation of what it is off by, as a part of that [-].
constexpr double off_as_deviation = 0.5;
constexpr double two_sided_95 = 1.959964;

/// What a parameter changes in the response of samples that count, per its unit; zeros where it is held.
Eigen::VectorXd change_with(std::size_t k, const FitProblem& problem, const ModelFit& fit) {
  constexpr double step = 1e-3;  // of the value
  const auto& list = problem.samples.list;
  Eigen::VectorXd change = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(list.size()));
  const FreeParameter& p = fit.explanation->parameters()[k];
  if (fit.is_held(k) || !(p.high > p.low)) return change;
  const double value = fit.values[k], by = value != 0 ? step * std::abs(value) : step * (p.high - p.low);
  ModelFit below = fit, above = fit;
  below.values[k] = std::max(p.low, value - by);
  above.values[k] = std::min(p.high, value + by);
  const auto low = below.simulate(problem.samples), high = above.simulate(problem.samples);
  for (std::size_t i = 0; i < list.size(); ++i)
    if (list[i].counts)
      change[static_cast<Eigen::Index>(i)] = (high[i] - low[i]) / (above.values[k] - below.values[k]);
  return change;
}

/// What laws that may be off by `errors` add to the deviation of each parameter, in its unit.
std::vector<double> added_deviations(const FitProblem& problem, const ModelFit& fit,
                                     const ModelErrors& errors) {
  std::vector<double> deviations(fit.values.size(), 0.0);
  std::vector<std::size_t> free;
  Eigen::MatrixXd changes(static_cast<Eigen::Index>(problem.samples.list.size()),
                          static_cast<Eigen::Index>(fit.values.size()));
  for (std::size_t k = 0; k < fit.values.size(); ++k) {
    const Eigen::VectorXd change = change_with(k, problem, fit);
    if (!(change.squaredNorm() > 0)) continue;
    changes.col(static_cast<Eigen::Index>(free.size())) = change;
    free.push_back(k);
  }
  if (free.empty()) return deviations;
  const Eigen::MatrixXd added =
      LawErrors(problem.samples)
          .added_covariance(problem.samples, problem.noise,
                            changes.leftCols(static_cast<Eigen::Index>(free.size())), errors);
  for (std::size_t c = 0; c < free.size(); ++c) {
    const auto place = static_cast<Eigen::Index>(c);
    deviations[free[c]] = std::sqrt(std::max(0.0, added(place, place)));
  }
  return deviations;
}

}  // namespace

std::vector<double> half_widths_by_laws(const FitProblem& problem, const ModelFit& fit,
                                        const ModelFit& baseline) {
  const Explanation& explanation = *fit.explanation;
  const auto& effects = explanation.effects();
  std::vector<double> accuracies, half(fit.values.size(), 0.0);
  for (const Effect* effect : effects) accuracies.push_back(accuracy_of(*effect, problem, fit));
  if (effects.empty()) return half;
  const auto is_own = [&](std::size_t k, std::size_t e) {
    return explanation.parameters()[k].effect == static_cast<int>(e);
  };
  const auto add = [&](std::size_t k, double shift) { half[k] = std::hypot(half[k], shift); };
  for (std::size_t e = 0; e < effects.size(); ++e) {
    const std::vector<double> open = effects[e]->left_open(problem.experiment);
    for (std::size_t k = 0, own = 0; k < half.size() && own < open.size(); ++k)
      if (is_own(k, e)) add(k, open[own++]);
  }
  const auto off_by = [&](std::size_t k) { return explanation.parameters()[k].off_by; };
  for (std::size_t k = 0; k < half.size(); ++k)
    if (!std::isnan(off_by(k))) add(k, off_by(k) * fit.values[k]);
  for (std::size_t e = 0; e < effects.size(); ++e)
    for (std::size_t k = 0; k < half.size(); ++k)
      if (std::isnan(off_by(k)) && (is_own(k, e) || !explanation.is_smooth()))
        add(k, off_in_scale * accuracies[e] * fit.values[k]);
  if (!explanation.is_smooth()) return half;
  const ModelErrors errors = law_errors(problem, fit, baseline, [&](const Effect& e) {
    return is_known_exactly(e) ? fit.part_of_bound : off_as_deviation;
  });
  const std::vector<double> by_form = added_deviations(problem, fit, errors);
  for (std::size_t k = 0; k < half.size(); ++k) add(k, two_sided_95 * by_form[k]);
  return half;
}

}  // namespace asperity
