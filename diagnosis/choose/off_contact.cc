#include "diagnosis/choose/off_contact.h"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

using Effects = std::vector<const Effect*>;

/// Only what is farther off than any contact counts; how many samples do.
std::size_t keep_off_contact(Samples& samples, double distance) {
  std::size_t count = 0;
  for (Sample& s : samples.list) {
    s.counts = s.counts && s.normal_displacement < -distance;
    count += s.counts;
  }
  return count;
}

/// A surface that adheres is drawn out about as far as it was pressed in; a quarter of the way back is beyond
/// that, too.
double far_off(const FitProblem& problem) {
  double farthest = 0;
  for (const Sample& s : problem.samples.list) farthest = std::max(farthest, -s.normal_displacement);
  return std::max(2 * problem.experiment.largest_displacement, 0.25 * farthest);
}

}  // namespace

Effects shown_off_contact(const FitProblem& problem, const ModelFit& baseline, const Effects& effects) {
  constexpr std::size_t fewest = 40, most_shown = 4;
  constexpr double plain_evidence = 25;
  if (problem.experiment.mode != Motion::normal || !problem.experiment.has_off_contact) return {};
  FitProblem far = problem;
  const double distance = far_off(problem);
  if (keep_off_contact(far.samples, distance) < fewest || keep_off_contact(far.thin, distance) == 0)
    return {};
  ModelFit best = refitted(far, baseline, far.samples, false, 0);
  Effects shown;
  while (shown.size() < most_shown) {
    ModelFit better = best;
    for (const Effect* effect : effects) {
      Effects set = shown;
      if (effect->description().kind != EffectKind::instrument ||
          std::find(set.begin(), set.end(), effect) != set.end())
        continue;
      set.push_back(effect);
      if (!Explanation::compatible(set)) continue;
      const ModelFit fit = fit_explanation(far, set, &best);
      if (fit.cost < better.cost) better = fit;
    }
    const auto count = static_cast<double>(std::max<std::size_t>(2, better.count));
    const double evidence =
        0.5 * (best.cost - better.cost) / std::max(1.0, better.cost / count) - 0.5 * std::log(count);
    if (evidence < plain_evidence) break;
    best = better;
    shown = best.explanation->effects();
  }
  return shown;
}

}  // namespace asperity
