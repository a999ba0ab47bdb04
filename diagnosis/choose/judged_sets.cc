#include "diagnosis/choose/judged_sets.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "diagnosis/choose/law_error.h"

namespace asperity {
namespace {

using Effects = std::vector<const Effect*>;

/// Log evidence by which an effect must be better than none, and a set than one with a member less.
constexpr double clear_evidence = 8, evidence_for_another = 4;
/// Log evidence by which an effect of the instrument is named however small its part is.
constexpr double plain_evidence = 25;
/// Part of the mismatch that a further effect must explain, where the set then leaves noise and where it does
/// not: less is what laws of this kind are off by.
constexpr double least_part = 0.03, least_part_of_incomplete = 0.1;
/// Part of what is left without it that is enough, too: next to an effect that explains nearly all of a large
/// mismatch, a second one that is plain to see is a small part of the whole.
constexpr double part_of_rest = 0.5;
constexpr std::size_t most_judged = 6;

double excess(const FitProblem& problem, const Candidate& candidate) {
  return std::max(0.0, candidate.left(problem) - static_cast<double>(candidate.fit.count));
}

/// A layer on the surface, of asperities or a film: real ones follow its published laws to some per cent,
/// which a second effect takes up.
bool has_layer(const Effects& effects) {
  return std::any_of(effects.begin(), effects.end(), [](const Effect* effect) {
    const auto& slots = effect->description().slots;
    return std::find(slots.begin(), slots.end(), "layer") != slots.end();
  });
}

const Candidate* find(const SearchResult& search, const Effects& effects) {
  const std::set<const Effect*> wanted(effects.begin(), effects.end());
  for (const auto& candidate : search.candidates) {
    const auto& have = candidate.fit.explanation->effects();
    if (std::set<const Effect*>(have.begin(), have.end()) == wanted) return &candidate;
  }
  return nullptr;
}

/// Log evidence that a set only has because the laws of a smaller one change less in it and so state less;
/// none where the smaller one does not fit well within what its laws state.
double by_stating_less(const Candidate& smaller, const Candidate& larger) {
  constexpr double well_within = 0.2;
  if (smaller.fit.part_of_bound > well_within) return 0;
  return 0.5 * std::max(0.0, smaller.room - larger.room);
}

/// How far two fits are apart in all samples that count together, in deviations of their noise.
double apart(const FitProblem& problem, const ModelFit& one, const ModelFit& other) {
  const std::vector<double> a = one.simulate(problem.samples), b = other.simulate(problem.samples);
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (problem.samples.list[i].counts) sum += std::pow((a[i] - b[i]) / problem.noise.sd[i], 2);
  return std::sqrt(sum);
}

/// Every member earns its place, but for what samples off contact show by themselves: without it the evidence
/// is clearly less, and a part of the mismatch comes back that is either large or more than the laws of the
/// others may be off by.
bool every_member_counts(const FitProblem& problem, const SearchResult& search, const Scanner& scanner,
                         const Candidate& candidate) {
  const auto leaves_noise = [&](const Candidate& of) {
    return of.chi2(problem) < largest_of_noise &&
           remaining(problem, search.alone.fit, scanner, of.fit).p_value > significance;
  };
  const auto& effects = candidate.fit.explanation->effects();
  const bool complete = effects.size() > 1 && leaves_noise(candidate);
  for (std::size_t k = 0; k < effects.size(); ++k) {
    if (search.is_shown_off_contact(effects[k])) continue;
    Effects without = effects;
    without.erase(without.begin() + static_cast<long>(k));
    const Candidate* smaller = without.empty() ? &search.alone : find(search, without);
    if (!smaller) continue;
    const double enough = without.empty() ? clear_evidence : evidence_for_another;
    const double muted = by_stating_less(*smaller, candidate) / search.overdispersion;
    if (candidate.score < smaller->score + enough ||
        candidate.score_as_stated - muted < smaller->score_as_stated + enough)
      return false;
    const double gained = (smaller->cost - candidate.cost) / search.overdispersion;
    if (without.empty() || effects[k]->is_another_value()) continue;
    const double least_gained = (smaller->least_cost() - candidate.least_cost()) / search.overdispersion;
    const double whole = excess(problem, search.alone) / search.overdispersion;
    // In the same terms as what is gained: beyond what the laws of the smaller set may be off by.
    const double rest =
        std::min(excess(problem, *smaller),
                 std::max(0.0, smaller->least_cost() - static_cast<double>(smaller->fit.count))) /
        search.overdispersion;
    if (!complete && least_gained < std::min(least_part_of_incomplete * whole, part_of_rest * rest))
      return false;
    // What an instrument adds is known in form; a second law of the contact may only mend the first one's.
    const bool is_plain = effects[k]->description().kind == EffectKind::instrument &&
                          candidate.score_as_stated > smaller->score_as_stated + plain_evidence;
    const bool is_unsure = !is_plain && leaves_noise(*smaller);
    if (complete && gained < least_part * whole && (is_unsure || has_layer(without))) return false;
  }
  return true;
}

}  // namespace

ScanResult remaining(const FitProblem& problem, const ModelFit& baseline, const Scanner& scanner,
                     const ModelFit& fit) {
  const LawError tolerated = law_error(problem, fit, baseline);
  if (!has_shared_error(problem)) return scanner.scan(fit.residual(problem.samples), tolerated);
  const Misfit shared = shared_misfit(problem, fit);
  const LawErrors errors(problem.samples);
  return scanner.scan(
      errors.without_shared_error(problem.samples, problem.noise, shared.residual, shared.errors), tolerated);
}

bool JudgedSet::is_part_of(const JudgedSet& other) const {
  const auto& have = other.candidate->fit.explanation->effects();
  const auto& own = candidate->fit.explanation->effects();
  return std::all_of(own.begin(), own.end(), [&](const Effect* effect) {
    return std::find(have.begin(), have.end(), effect) != have.end();
  });
}

std::vector<const JudgedSet*> JudgedSets::rivals_of(const JudgedSet& chosen) const {
  std::vector<const JudgedSet*> rivals;
  for (const JudgedSet& other : list)
    if (!other.is_part_of(chosen) && !chosen.is_part_of(other)) rivals.push_back(&other);
  return rivals;
}

Rivalry rivalry(const FitProblem& problem, const JudgedSet& chosen, const JudgedSet& other) {
  constexpr double equal = 1.05;  // of held-out cost, which is noise below 1
  constexpr double same = 2;      // deviations by which all samples together would tell them apart
  const double difference = chosen.candidate->score - other.candidate->score;
  const bool predicts_as_well = other.held_out.cost <= equal * std::max(1.0, chosen.held_out.cost);
  const bool would_be_ahead = other.candidate->score_as_stated > chosen.candidate->score_as_stated;
  // One of more parameters that imitates the chosen one is no rival of it.
  const bool is_same = difference < 2 * as_good && other.fit.values.size() <= chosen.fit.values.size() &&
                       apart(problem, chosen.fit, other.fit) < same;
  return {difference, (difference < as_good && predicts_as_well) || is_same || would_be_ahead,
          (difference < 2 * as_good && predicts_as_well) || is_same || would_be_ahead};
}

JudgedSets judged_sets(const FitProblem& problem, const SearchResult& search, const Scanner& scanner,
                       const Blocks& blocks, const HeldOut& baseline_held_out,
                       const std::function<bool(const ModelFit&)>& is_no_effect) {
  JudgedSets judged;
  for (const auto& candidate : search.candidates) {
    if (judged.list.size() == most_judged) break;
    if (candidate.score < search.alone.score + clear_evidence) break;
    if (!judged.list.empty() && candidate.score < judged.list.front().candidate->score - 4 * as_good) break;
    if (!search.holds_what_is_off_contact(candidate.fit)) continue;
    if (!candidate.fit.is_itself() || !every_member_counts(problem, search, scanner, candidate)) continue;
    JudgedSet set{&candidate, finished(problem, candidate.fit), {}};
    if (const std::string parameter = set.fit.stopped_at(); !parameter.empty()) {
      judged.stopped.push_back(candidate.fit.explanation->name() + " (" + parameter + ")");
      continue;
    }
    if (set.fit.holds_no_effect(search.overdispersion) || (is_no_effect && is_no_effect(set.fit))) continue;
    set.held_out = predict_held_out(problem, set.fit, blocks);
    if (!set.held_out.consistent)
      judged.inconsistent.push_back(candidate.fit.explanation->name());
    else if (set.held_out.cost < baseline_held_out.cost)
      judged.list.push_back(std::move(set));
  }
  return judged;
}

}  // namespace asperity
