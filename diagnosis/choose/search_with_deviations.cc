#include "diagnosis/choose/search_with_deviations.h"

#include "diagnosis/choose/leftover.h"

namespace asperity {
namespace {

/// The best explanation, or the simulation alone where that is better.
const ModelFit& best_of(const SearchResult& found) {
  const bool is_better = !found.candidates.empty() && found.candidates.front().score > found.alone.score;
  return is_better ? found.best_within_bounds().fit : found.alone.fit;
}

}  // namespace

SearchResult search_with_deviations(PreparedFit& prepared, unsigned seed,
                                    const std::function<void(const std::string&)>& progress) {
  constexpr int most_rounds = 3;
  for (int round = 1;; ++round) {
    const FitProblem& problem = prepared.problem;
    const Scanner scanner(problem.samples, problem.experiment, problem.noise, seed);
    const IsNoise is_noise = [&](const ModelFit& fit) {
      return remaining(problem, prepared.baseline, scanner, fit).p_value > significance;
    };
    SearchResult found = search_effects(problem, prepared.baseline, is_noise, progress);
    if (round == most_rounds || !prepared.pass_on_deviations(best_of(found))) return found;
  }
}

}  // namespace asperity
