#include "diagnosis/choose/law_shifts.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/choose/law_error.h"

namespace asperity {
namespace {

/// What a law may be off by at 95 %, as parts of its accuracy [-]: with these 97 % of the intervals of
/// challenge 142500 hold the truth, and 99 % of blind bench 83 (docs/diagnosis.md).
constexpr double off_in_scale = 0.7, off_in_form = 1;
/// Over the root mean square of the parts of its accuracy by which a law is off, where data do not tell them
/// [-].
constexpr double undecided = 2;
constexpr int steps = 6;  ///< of a refit, whose optimum is near

/// Straight from -1 to 1 in the part of the sum of squares that lies before a sample, of mean square 1.
std::vector<double> straight_along(const std::vector<double>& contribution,
                                   const std::vector<std::size_t>& order) {
  double sum = 0, before = 0;
  for (const std::size_t i : order) sum += contribution[i] * contribution[i];
  std::vector<double> line(contribution.size(), 0.0);
  for (const std::size_t i : order) {
    const double own = contribution[i] * contribution[i];
    line[i] = std::sqrt(3.0) * (2 * (before + own / 2) / sum - 1);
    before += own;
  }
  return line;
}

/// The forms in which a law may be off, each as what it adds to the response.
std::vector<std::vector<double>> forms_of(const std::vector<double>& contribution, const Samples& samples) {
  std::vector<std::size_t> recorded;
  for (std::size_t i = 0; i < contribution.size(); ++i)
    if (samples.list[i].counts && contribution[i] != 0) recorded.push_back(i);
  std::vector<std::vector<double>> forms;
  if (recorded.empty()) return forms;
  double largest = 0;
  for (const double part : contribution) largest = std::max(largest, std::abs(part));
  const auto size = [&](std::size_t i) {
    constexpr double beyond_rounding = 1e9;
    return std::round(beyond_rounding * std::abs(contribution[i]) / largest);
  };
  std::vector<std::size_t> by_size = recorded;
  std::stable_sort(by_size.begin(), by_size.end(),
                   [&](std::size_t a, std::size_t b) { return size(a) < size(b); });
  for (const auto& order : {by_size, recorded}) {
    std::vector<double> form = straight_along(contribution, order);
    for (std::size_t i = 0; i < form.size(); ++i) form[i] *= off_in_form * contribution[i];
    forms.push_back(std::move(form));
  }
  return forms;
}

/// From where a fit stands, with this added to the recorded response.
std::vector<double> moved_by(const FitProblem& problem, const ModelFit& at, const std::vector<double>& added,
                             double factor) {
  Samples samples = problem.thin;
  for (std::size_t i = 0; i < added.size(); ++i) samples.list[i].response += factor * added[i];
  std::vector<double> moved = refitted(problem, at, samples, false, steps).values;
  for (std::size_t k = 0; k < moved.size(); ++k) moved[k] -= at.values[k];
  return moved;
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
  const ModelFit at = explanation.is_smooth() && effects.size() > 1
                          ? refitted(problem, fit, problem.thin, false, steps)
                          : fit;
  const std::vector<double> with = at.simulate(problem.thin);
  for (std::size_t e = 0; e < effects.size(); ++e) {
    if (accuracies[e] == 0) continue;
    const double scale = off_in_scale * accuracies[e];
    for (std::size_t k = 0; k < half.size(); ++k)
      if (is_own(k, e) || !explanation.is_smooth()) add(k, scale * fit.values[k]);
    if (!explanation.is_smooth() || effects.size() == 1) continue;
    const auto contribution = contribution_of(*effects[e], problem, problem.thin, at, with, baseline);
    auto ways = forms_of(contribution, problem.thin);
    ways.push_back(contribution);
    for (double& part : ways.back()) part *= off_in_scale;
    // A form that the fit would leave in its residuals is no larger than these show.
    const double shown = undecided * fit.part_of_bound * effects[e]->description().accuracy;
    for (const auto& way : ways) {
      const auto moved = moved_by(problem, at, way, std::min(accuracies[e], shown));
      for (std::size_t k = 0; k < half.size(); ++k)
        if (!is_own(k, e)) add(k, moved[k]);
    }
  }
  return half;
}

}  // namespace asperity
