// Which effects: sets of up to three, by evidence, from the best of each size (a beam, so that a pair may win
// whose members do little alone), and of up to three beside what samples off contact show of the instrument;
// each set with what leaving one of its members out again would cost.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "diagnosis/choose/law_error.h"
#include "diagnosis/fit/model_fit.h"

namespace asperity {

/// A set that was fitted.
struct Candidate {
  ModelFit fit;
  double cost = 0;  ///< -2 log likelihood, with what the laws state that they may be off by (law_error.h) [-]
  double room = 0;  ///< the part of it that is the log determinant of what they may be off by [-]
  std::vector<double> costs;  ///< the same for each of parts_of_bound; empty: laws state nothing [-]
  /// Log evidence (Schwarz 1978) with a prior of one in the number of effects for each effect; of laws that
  /// are off by what they state, or by any part of it [-].
  double score_as_stated = 0, score = 0;
  /// Of a layer: a set in which another effect mends what its law is off by, if the scores are of that (see
  /// credit_layers()); null: they are its own.
  std::shared_ptr<const ModelFit> where_mended;

  /// With what each free parameter takes of the evidence (Schwarz 1978) [-].
  double cost_with_parameters() const {
    return cost + static_cast<double>(fit.free_parameters()) *
                      std::log(static_cast<double>(std::max<std::size_t>(2, fit.count)));
  }
  /// The least of the costs over what the laws may be off by [-].
  double least_cost() const { return costs.empty() ? cost : *std::min_element(costs.begin(), costs.end()); }
  /// -2 log likelihood of what is left: of a case that was slid beyond what its mesh may be off by, which the
  /// cost of every set allows for [-].
  double left(const FitProblem& problem) const { return has_shared_error(problem) ? cost - room : fit.cost; }
  /// The same for each sample [-].
  double chi2(const FitProblem& problem) const {
    return left(problem) / static_cast<double>(std::max<std::size_t>(1, fit.count));
  }
};

/// All sets, and how much they explain.
struct SearchResult {
  Candidate alone;                    ///< the simulation without any effect
  std::vector<Candidate> candidates;  ///< all sets that were fitted, the best first
  std::size_t admissible = 0;         ///< effects that these data could show
  /// What samples off contact show of the instrument, where it is more than one effect and sets of three
  /// leave structure.
  std::vector<const Effect*> shown_off_contact;
  /// chi^2 of the best fit per sample, with what its laws are likely off by, at least 1: by it evidence is
  /// tempered [-].
  double overdispersion = 1;

  bool is_shown_off_contact(const Effect* effect) const {
    return std::find(shown_off_contact.begin(), shown_off_contact.end(), effect) != shown_off_contact.end();
  }
  /// How many of a set's effects are not shown off contact [-].
  std::size_t others_in(const ModelFit& fit) const {
    const auto& effects = fit.explanation->effects();
    return static_cast<std::size_t>(std::count_if(
        effects.begin(), effects.end(), [&](const Effect* effect) { return !is_shown_off_contact(effect); }));
  }
  /// Whether a set has all that is shown off contact, without which it is no answer.
  bool holds_what_is_off_contact(const ModelFit& fit) const {
    return fit.explanation->effects().size() == shown_off_contact.size() + others_in(fit);
  }
  /// The best set none of whose parameters ended at a bound, or else the best.
  const Candidate& best_within_bounds() const {
    const auto found = std::find_if(candidates.begin(), candidates.end(), [](const Candidate& candidate) {
      return candidate.fit.stopped_at().empty();
    });
    return found == candidates.end() ? candidates.front() : *found;
  }
  /// Whether a set is better than none.
  bool explains() const { return !candidates.empty() && candidates.front().score > alone.score; }
};

/// True if the residual of an explanation is noise.
using IsNoise = std::function<bool(const ModelFit&)>;

/// baseline: the fit without any effect; progress is told what is being done.
SearchResult search_effects(const FitProblem& problem, const ModelFit& baseline, const IsNoise& is_noise,
                            const std::function<void(const std::string&)>& progress);

}  // namespace asperity
