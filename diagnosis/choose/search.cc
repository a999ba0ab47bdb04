#include "diagnosis/choose/search.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "diagnosis/choose/law_error.h"

namespace asperity {
namespace {

using Effects = std::vector<const Effect*>;

constexpr std::size_t widest_beam_of_singles = 8, widest_beam_of_pairs = 3, largest_set = 3;
/// With samples off contact, which show what an instrument adds apart from the contact.
constexpr std::size_t largest_set_off_contact = 6;

/// Log odds against each effect that other causes look like in these data: less than as_good, so that it
/// stays a candidate beside its equals.
constexpr double not_shown = 1.5;

/// The likelihood's mean over what the laws may be off by, and what of that is likely then.
struct OverLaws {
  double log_likelihood, part_of_bound;  ///< [-]
};
OverLaws over_laws(const Candidate& candidate, double overdispersion) {
  if (candidate.costs.empty()) return {-0.5 * candidate.cost / overdispersion, 1};
  const double least = *std::min_element(candidate.costs.begin(), candidate.costs.end());
  if (!std::isfinite(least)) return {-least, 1};
  double sum = 0, squares = 0;
  for (std::size_t k = 0; k < candidate.costs.size(); ++k) {
    const double likely = std::exp(-0.5 * (candidate.costs[k] - least) / overdispersion);
    sum += likely, squares += likely * parts_of_bound[k] * parts_of_bound[k];
  }
  return {-0.5 * least / overdispersion + std::log(sum / static_cast<double>(candidate.costs.size())),
          std::sqrt(squares / sum)};
}

void score(Candidate& candidate, const Experiment& experiment, std::size_t admissible,
           double overdispersion) {
  const auto parameters = static_cast<double>(candidate.fit.explanation->parameters().size());
  const Effects& members = candidate.fit.explanation->effects();
  double effects = 0;
  for (const Effect* effect : members)
    if (!effect->is_another_value()) effects += effect->effects_held();
  const auto count = static_cast<double>(std::max<std::size_t>(2, candidate.fit.count));
  double prior = -0.5 * parameters * std::log(count) -
                 effects * std::log(std::max<double>(2, static_cast<double>(admissible)));
  // A number read off a part of the recording is told by the samples of that part alone.
  if (const double read_off = candidate.fit.numbers_read_off(experiment); read_off > 0)
    prior -= 0.5 * read_off * std::log(std::max(2.0, count / read_off));
  for (const Effect* effect : members)
    if (!effect->not_recorded(experiment).empty()) prior -= not_shown;
  candidate.score_as_stated = prior - 0.5 * candidate.cost / overdispersion;
  const OverLaws likely = over_laws(candidate, overdispersion);
  candidate.score = prior + likely.log_likelihood;
  candidate.fit.part_of_bound = likely.part_of_bound;
}

void score_all(SearchResult& result, const FitProblem& problem) {
  const Experiment& experiment = problem.experiment;
  // Of what is left, not of the room that a mesh or the bounds of laws have.
  const auto misfit = [&](const Candidate& of) {
    if (has_shared_error(problem)) return of.left(problem);
    return of.costs.empty() ? of.cost : *std::min_element(of.costs.begin(), of.costs.end());
  };
  double least = misfit(result.alone);
  for (const auto& candidate : result.candidates) least = std::min(least, misfit(candidate));
  result.overdispersion =
      std::max(1.0, least / static_cast<double>(std::max<std::size_t>(1, result.alone.fit.count)));
  score(result.alone, experiment, result.admissible, result.overdispersion);
  for (auto& candidate : result.candidates)
    score(candidate, experiment, result.admissible, result.overdispersion);
  std::stable_sort(result.candidates.begin(), result.candidates.end(),
                   [](const auto& a, const auto& b) { return a.score > b.score; });
}

void cost_explanation(Candidate& candidate, const FitProblem& problem, const LawErrors& laws,
                      const ModelFit& baseline) {
  const Misfit misfit = misfit_of(problem, candidate.fit, baseline);
  const LawErrors::Cost cost = laws.cost(problem.samples, problem.noise, misfit.residual, misfit.errors);
  candidate.cost = cost.sum();
  candidate.room = cost.log_determinant;
  candidate.costs.clear();
  if (misfit.errors.of_laws.empty() && misfit.errors.of_curves.empty()) return;
  for (const double part : parts_of_bound)
    candidate.costs.push_back(part == 1 ? candidate.cost
                                        : laws.cost(problem.samples, problem.noise, misfit.residual,
                                                    laws_off_by(part, misfit.errors))
                                              .sum());
}

/// In a case of finite elements only what enters there, or acts on any history.
bool has_a_form(const Effect& effect, const Experiment& experiment) {
  return !experiment.by_finite_elements || effect.enters_by(experiment) != EntersBy::reduced_law_only;
}

/// The best sets of one size.
std::vector<const Candidate*> best_of_size(const SearchResult& result, std::size_t size, std::size_t most) {
  std::vector<const Candidate*> list;
  for (const auto& candidate : result.candidates)
    if (candidate.fit.explanation->effects().size() == size && list.size() < most) list.push_back(&candidate);
  return list;
}

std::size_t largest_size(const SearchResult& result) {
  std::size_t size = 0;
  for (const auto& candidate : result.candidates)
    size = std::max(size, candidate.fit.explanation->effects().size());
  return size;
}

/// Smaller sets, each from where a good larger one that holds it stands: those that were fitted once more,
/// for where responses jump a fit may have ended in another valley, and what only led out of that one would
/// be named; and those whose members were too poor alone to be tried together.
void refit_within_larger(SearchResult& result, const FitProblem& problem, const LawErrors& laws) {
  constexpr std::size_t most_larger = 4;
  constexpr int iterations = 30;
  constexpr double another_valley = 0.5;  // of the cost; less is how far fits are carried on
  for (std::size_t size = largest_size(result); size > 1; --size) {
    std::vector<std::pair<Effects, const ModelFit*>> sets;  // and the larger fit that each is taken from
    std::vector<ModelFit> larger_fits;
    for (const auto* larger : best_of_size(result, size, most_larger)) larger_fits.push_back(larger->fit);
    for (const ModelFit& larger : larger_fits)
      for (const Effect* left_out : larger.explanation->effects()) {
        Effects fewer = larger.explanation->effects();
        fewer.erase(std::find(fewer.begin(), fewer.end(), left_out));
        if (Explanation::compatible(fewer)) sets.emplace_back(std::move(fewer), &larger);
      }
    std::vector<Candidate> found(sets.size());
#pragma omp parallel for schedule(dynamic)
    for (std::size_t i = 0; i < sets.size(); ++i) {
      const ModelFit start = sets[i].second->only(problem, sets[i].first, result.alone.fit);
      found[i].fit = refitted(problem, start, problem.samples, false, iterations);
      cost_explanation(found[i], problem, laws, result.alone.fit);
    }
    for (std::size_t i = 0; i < sets.size(); ++i) {
      const auto same =
          std::find_if(result.candidates.begin(), result.candidates.end(), [&](const auto& other) {
            return other.fit.explanation->effects() == found[i].fit.explanation->effects();
          });
      if (same == result.candidates.end())
        result.candidates.push_back(found[i]);
      else if (found[i].cost < same->cost - another_valley)
        *same = found[i];
    }
  }
  score_all(result, problem);
}

}  // namespace

namespace {

/// Sets of one size that are not fitted yet, each with the smaller fit that it grows from.
class SetsOfSize {
 public:
  SetsOfSize(const SearchResult& result, std::set<Effects>& tried, std::size_t size) : tried_(tried) {
    const std::size_t beam = size == 2             ? widest_beam_of_singles
                             : size <= largest_set ? widest_beam_of_pairs
                                                   : 1;
    for (const auto* candidate : best_of_size(result, size - 1, beam)) grown_.push_back(candidate->fit);
    if (size == 1) grown_.push_back(result.alone.fit);
  }

  /// With one effect more.
  void grow_by(const Effect* effect) {
    for (const ModelFit& fit : grown_) {
      Effects set = fit.explanation->effects();
      if (std::find(set.begin(), set.end(), effect) != set.end()) continue;
      set.push_back(effect);
      std::sort(set.begin(), set.end());
      if (Explanation::compatible(set) && tried_.insert(set).second) sets_.push_back({set, &fit});
    }
  }

  std::vector<Candidate> fitted(const FitProblem& problem, const LawErrors& laws,
                                const ModelFit& baseline) const {
    std::vector<Candidate> fitted(sets_.size());
#pragma omp parallel for schedule(dynamic)
    for (std::size_t i = 0; i < sets_.size(); ++i) {
      fitted[i].fit = fit_explanation(problem, sets_[i].first, sets_[i].second);
      cost_explanation(fitted[i], problem, laws, baseline);
    }
    return fitted;
  }
  std::size_t count() const { return sets_.size(); }

 private:
  std::set<Effects>& tried_;
  std::vector<ModelFit> grown_;
  std::vector<std::pair<Effects, const ModelFit*>> sets_;
};

std::string sets_in_words(std::size_t size) {
  static const char* const words[] = {"effects", "pairs of effects", "sets of three"};
  return size <= std::size(words) ? words[size - 1] : "sets of " + std::to_string(size);
}

Effects admissible_effects(const Experiment& experiment) {
  Effects admissible;
  for (const auto& effect : effect_catalogue())
    if (effect->is_shown_by(experiment) && has_a_form(*effect, experiment))
      admissible.push_back(effect.get());
  return admissible;
}

/// Whether larger sets are looked for: only where those of this size leave structure, and those of more than
/// three only as long as each further member is plain.
bool is_worth_growing(const SearchResult& result, std::size_t size, bool leaves_noise) {
  if (size < largest_set) return true;
  constexpr double plain_evidence = 25;
  const auto best = best_of_size(result, size, 1), smaller = best_of_size(result, size - 1, 1);
  return !leaves_noise && !best.empty() && !smaller.empty() &&
         best.front()->score > smaller.front()->score + plain_evidence;
}

}  // namespace

SearchResult search_effects(const FitProblem& problem, const ModelFit& baseline, const IsNoise& is_noise,
                            const std::function<void(const std::string&)>& progress) {
  SearchResult result;
  result.alone.fit = baseline;
  const LawErrors laws(problem.samples);
  result.alone.cost = baseline.cost;
  if (problem.correction) cost_explanation(result.alone, problem, laws, baseline);
  const Effects admissible = admissible_effects(problem.experiment);
  result.admissible = admissible.size();
  std::set<Effects> tried;
  bool leaves_noise = false;  // two effects do: a third is only another value of the simulation
  const std::size_t largest = problem.experiment.has_off_contact ? largest_set_off_contact : largest_set;
  for (std::size_t size = 1; size <= largest; ++size) {
    SetsOfSize sets(result, tried, size);
    for (const Effect* effect : admissible) {
      if (leaves_noise && !effect->is_another_value()) continue;
      if (size > largest_set && effect->description().kind != EffectKind::instrument) continue;
      sets.grow_by(effect);
    }
    if (progress && sets.count() > 0)
      progress("fitting " + std::to_string(sets.count()) + " " + sets_in_words(size));
    const std::vector<Candidate> fitted = sets.fitted(problem, laws, baseline);
    result.candidates.insert(result.candidates.end(), fitted.begin(), fitted.end());
    score_all(result, problem);
    if (result.candidates.empty()) break;
    // Noise of which no effect takes anything away holds no pairs either.
    constexpr double something = 2;
    if (size == 1 && is_noise(baseline) && result.candidates.front().score < result.alone.score + something)
      break;
    // Three effects are looked for only where two leave structure.
    leaves_noise = size >= 2 && is_noise(result.candidates.front().fit);
    if (!is_worth_growing(result, size, leaves_noise)) break;
  }
  refit_within_larger(result, problem, laws);
  return result;
}

void rescore(SearchResult& result, const FitProblem& problem) {
  const LawErrors laws(problem.samples);
  result.alone.fit = refitted(problem, result.alone.fit, problem.samples, false, 0);
  result.alone.cost = result.alone.fit.cost;
  if (problem.correction) cost_explanation(result.alone, problem, laws, result.alone.fit);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t i = 0; i < result.candidates.size(); ++i) {
    Candidate& candidate = result.candidates[i];
    candidate.fit = refitted(problem, candidate.fit, problem.samples, false, 0);
    cost_explanation(candidate, problem, laws, result.alone.fit);
  }
  score_all(result, problem);
}

}  // namespace asperity
