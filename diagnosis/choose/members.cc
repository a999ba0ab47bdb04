#include "diagnosis/choose/members.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "diagnosis/choose/judged_sets.h"
#include "diagnosis/choose/leftover.h"

namespace asperity {
namespace {

using Effects = std::vector<const Effect*>;

/// Log evidence by which a set must be better than one with a member less.
constexpr double evidence_for_another = 4;
/// Log evidence by which a set is too far behind for a rival, and one layer for one of another.
constexpr double far = 4 * as_good, far_of_layers = 6 * as_good;
/// Log evidence by which an effect of the instrument is named however small its part is.
constexpr double plain_evidence = 25;
/// Part of the mismatch that a further effect must explain, where the set then leaves noise and where it does
/// not: less is what laws of this kind are off by.
constexpr double least_part = 0.03, least_part_of_incomplete = 0.1;
/// Part of what is left without it that is enough, too: next to an effect that explains nearly all of a large
/// mismatch, a second one that is plain to see is a small part of the whole.
constexpr double part_of_rest = 0.5;

double excess(const FitProblem& problem, const Candidate& candidate) {
  return std::max(0.0, candidate.left(problem) - static_cast<double>(candidate.fit.count));
}

/// A layer on the surface, of asperities or a film: real ones follow its published laws to some per cent,
/// which a second effect takes up.
bool has_layer(const Effects& effects) {
  return std::any_of(effects.begin(), effects.end(),
                     [](const Effect* effect) { return effect->description().takes("layer"); });
}

bool has_asperities(const Effects& effects) {
  return std::any_of(effects.begin(), effects.end(),
                     [](const Effect* effect) { return effect->id() == "roughness_compliance"; });
}

/// Mean square of values about their means in groups of samples at nearly the same displacement, or force
/// where that is driven, over their mean square [-]: 0 of what depends on it alone.
double share_with_history(const Samples& samples, const std::vector<double>& values) {
  constexpr std::size_t groups = 32, fewest_in_group = 4;
  double within = 0, all = 0;
  for (const SampleRun& run : samples.runs) {
    std::vector<std::size_t> order;
    for (std::size_t i = run.begin; i < run.end; ++i)
      if (samples.list[i].counts) order.push_back(i);
    const auto driven = [&](std::size_t i) {
      return run.response_is_displacement ? samples.list[i].normal_force
                                          : samples.list[i].normal_displacement;
    };
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return driven(a) < driven(b); });
    const std::size_t in_group = std::max(fewest_in_group, order.size() / groups);
    for (std::size_t from = 0; from < order.size(); from += in_group) {
      const std::size_t to = std::min(order.size(), from + in_group);
      double sum = 0, squares = 0;
      for (std::size_t k = from; k < to; ++k)
        sum += values[order[k]], squares += std::pow(values[order[k]], 2);
      within += squares - sum * sum / static_cast<double>(to - from);
      all += squares;
    }
  }
  return all > 0 ? within / all : 0;
}

/// Whether what a member changes beside the others differs at the same load, as nothing does that the law of
/// a layer may be off by.
bool has_history(const FitProblem& problem, const SearchResult& search, const Candidate& candidate,
                 const Effects& others) {
  constexpr double enough = 0.05;
  if (problem.experiment.mode != Motion::normal) return false;
  auto change = candidate.fit.simulate(problem.samples);
  const auto without = candidate.fit.only(problem, others, search.alone.fit).simulate(problem.samples);
  for (std::size_t i = 0; i < change.size(); ++i) change[i] -= without[i];
  return share_with_history(problem.samples, change) > enough;
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

enum class Place { earned, mends_a_layer, none };

/// Of member `k`, beside a set `smaller` of the others; `complete`: together they leave noise.
Place place_of(const FitProblem& problem, const SearchResult& search, const Scanner& scanner,
               const Candidate& candidate, std::size_t k, const Candidate& smaller, bool complete) {
  const Effect& member = *candidate.fit.explanation->effects()[k];
  const auto& others = smaller.fit.explanation->effects();
  const double enough = others.empty() ? clear_evidence : evidence_for_another;
  const double muted = by_stating_less(smaller, candidate) / search.overdispersion;
  if (candidate.score < smaller.score + enough) return Place::none;
  // What the law of a layer may be off by at the bound that it states is mended all the more.
  if (candidate.score_as_stated - muted < smaller.score_as_stated + enough)
    return complete && has_layer(others) && !has_history(problem, search, candidate, others)
               ? Place::mends_a_layer
               : Place::none;
  if (others.empty() || member.is_another_value()) return Place::earned;
  const double gained = (smaller.cost - candidate.cost) / search.overdispersion,
               least_gained = (smaller.least_cost() - candidate.least_cost()) / search.overdispersion,
               whole = excess(problem, search.alone) / search.overdispersion;
  // In the same terms as what is gained: beyond what the laws of the smaller set may be off by.
  const double rest = std::min(excess(problem, smaller),
                               std::max(0.0, smaller.least_cost() - static_cast<double>(smaller.fit.count))) /
                      search.overdispersion;
  if (!complete)
    return least_gained < std::min(least_part_of_incomplete * whole, part_of_rest * rest) ? Place::none
                                                                                          : Place::earned;
  if (gained >= least_part * whole) return Place::earned;
  if (has_layer(others) && !has_history(problem, search, candidate, others)) return Place::mends_a_layer;
  // What an instrument adds is known in form; a second law of the contact may only mend the first one's.
  const double evidence = candidate.score_as_stated - smaller.score_as_stated;
  if (evidence > plain_evidence && member.description().kind == EffectKind::instrument) return Place::earned;
  return evidence > clear_evidence && !leaves_noise(problem, search, scanner, smaller) ? Place::earned
                                                                                       : Place::none;
}

}  // namespace

Members members_of(const FitProblem& problem, const SearchResult& search, const Scanner& scanner,
                   const Candidate& candidate) {
  const auto& effects = candidate.fit.explanation->effects();
  const bool complete = effects.size() > 1 && leaves_noise(problem, search, scanner, candidate);
  Members members;
  for (std::size_t k = 0; k < effects.size(); ++k) {
    if (search.is_shown_off_contact(effects[k])) continue;
    Effects without = effects;
    without.erase(without.begin() + static_cast<long>(k));
    const Candidate* smaller = without.empty() ? &search.alone : find(search, without);
    if (!smaller) continue;
    const Place place = place_of(problem, search, scanner, candidate, k, *smaller, complete);
    if (place == Place::none) return {false, nullptr};
    if (place == Place::mends_a_layer) members = {false, smaller};
  }
  return members;
}

bool is_layer(const ModelFit& fit) { return has_layer(fit.explanation->effects()); }

bool are_layers(const ModelFit& one, const ModelFit& other) { return is_layer(one) && is_layer(other); }

bool would_be_ahead(const Candidate& candidate, const Candidate& best) {
  return !candidate.where_mended && candidate.score_as_stated > best.score_as_stated;
}

bool is_far_behind(const Candidate& candidate, const Candidate& best) {
  const bool looks_alike = would_be_ahead(candidate, best) && are_layers(candidate.fit, best.fit);
  return candidate.score < best.score - (looks_alike ? far_of_layers : far);
}

void credit_layers(const FitProblem& problem, const Scanner& scanner, SearchResult& search) {
  if (search.candidates.empty()) return;
  struct Credit {
    const Candidate* mended;
    const Candidate* by;
  };
  std::vector<Credit> credits;
  for (const Candidate& candidate : search.candidates) {
    const Candidate& best = search.candidates.front();
    if (is_far_behind(candidate, best)) continue;
    if (!has_layer(candidate.fit.explanation->effects()) || !candidate.fit.is_itself()) continue;
    const Members members = members_of(problem, search, scanner, candidate);
    if (members.count && candidate.score > best.score - far &&
        leaves_noise(problem, search, scanner, candidate))
      return;  // by its own law
    if (!members.mended || members.mended->score >= candidate.score) continue;
    // A film follows its law; of asperities each surface is another.
    if (!has_asperities(members.mended->fit.explanation->effects())) continue;
    credits.push_back({members.mended, &candidate});
  }
  for (const Credit& credit : credits) {
    Candidate& mended = search.candidates[static_cast<std::size_t>(credit.mended - search.candidates.data())];
    if (mended.score >= credit.by->score) continue;
    mended.score = credit.by->score;
    mended.score_as_stated = std::max(mended.score_as_stated, credit.by->score_as_stated);
    mended.where_mended = std::make_shared<const ModelFit>(credit.by->fit);
  }
  std::stable_sort(search.candidates.begin(), search.candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
}

}  // namespace asperity
