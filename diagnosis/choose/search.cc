#include "diagnosis/choose/search.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "diagnosis/choose/evidence.h"
#include "diagnosis/choose/off_contact.h"

namespace asperity {
namespace {

using Effects = std::vector<const Effect*>;

constexpr std::size_t widest_beam_of_singles = 8, widest_beam_of_pairs = 3, largest_set = 3;
/// With what samples off contact show.
constexpr std::size_t largest_beside_off_contact = 6;

/// In a case of finite elements only what enters there, or acts on any history.
bool has_a_form(const Effect& effect, const Experiment& experiment) {
  return !experiment.by_finite_elements || why_without_form(effect, experiment).empty();
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

/// Where the fit of a set stands; the end: it was not fitted yet.
auto place_of(SearchResult& result, const Effects& set) {
  return std::find_if(result.candidates.begin(), result.candidates.end(),
                      [&](const auto& other) { return other.fit.explanation->effects() == set; });
}

bool is_fitted(SearchResult& result, const Effects& set) {
  return place_of(result, set) != result.candidates.end();
}

/// A fit of a set that was not fitted yet, or one that ended in another valley.
void take_better(SearchResult& result, const Candidate& found) {
  constexpr double another_valley = 0.5;  // of the cost; less is how far fits are carried on
  const auto same = place_of(result, found.fit.explanation->effects());
  if (same == result.candidates.end())
    result.candidates.push_back(found);
  else if (found.cost_with_parameters() < same->cost_with_parameters() - another_valley)
    *same = found;
}

/// Of good sets with an effect that is not itself those with the simpler one, from where they stand.
void refit_in_simpler_form(SearchResult& result, const FitProblem& problem, const LawErrors& laws) {
  constexpr std::size_t most_sets = 12;
  constexpr int iterations = 30;
  std::vector<ModelFit> starts;
  for (std::size_t i = 0; i < std::min(most_sets, result.candidates.size()); ++i)
    for (ModelFit& start : result.candidates[i].fit.in_simpler_form(problem))
      starts.push_back(std::move(start));
  std::vector<Candidate> found(starts.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t i = 0; i < starts.size(); ++i) {
    found[i].fit = refitted(problem, starts[i], problem.samples, false, iterations);
    cost_explanation(found[i], problem, laws, result.alone.fit);
  }
  for (const Candidate& candidate : found) take_better(result, candidate);
  score_all(result, problem);
}

/// Smaller sets, each from where a good larger one that holds it stands: those that were fitted once more,
/// for where responses jump a fit may have ended in another valley, and what only led out of that one would
/// be named; and those whose members were too poor alone to be tried together.
void refit_within_larger(SearchResult& result, const FitProblem& problem, const LawErrors& laws) {
  constexpr std::size_t most_larger = 4;
  constexpr int iterations = 30;
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
      const auto cost = [&](ModelFit fit) {
        Candidate candidate;
        candidate.fit = std::move(fit);
        cost_explanation(candidate, problem, laws, result.alone.fit);
        return candidate;
      };
      found[i] = cost(refitted(problem, start, problem.samples, false, iterations));
      // Where responses jump one start may stay in a valley beside: all of them, if none was tried yet.
      if (start.explanation->is_smooth() || is_fitted(result, sets[i].first)) continue;
      const Candidate anew = cost(fit_explanation(problem, sets[i].first, &start));
      if (anew.cost_with_parameters() < found[i].cost_with_parameters()) found[i] = anew;
    }
    for (const Candidate& candidate : found) take_better(result, candidate);
  }
  score_all(result, problem);
}

}  // namespace

namespace {

/// The fit with parameters free that the laws can do without, where that is worth what they take of the
/// evidence; what `near` holds or has free stays so.
void free_what_is_earned(Candidate& candidate, const FitProblem& problem, const LawErrors& laws,
                         const ModelFit& baseline, const ModelFit* near) {
  const auto count = static_cast<double>(candidate.fit.count);
  const bool could_pay = candidate.fit.cost > count + std::log(count);
  const std::size_t held = candidate.fit.values.size() - candidate.fit.free_parameters();
  if (held == near->values.size() - near->free_parameters() || !could_pay) return;
  Candidate freed;
  freed.fit = fit_explanation(problem, candidate.fit.explanation->effects(), near, Freedom::all);
  cost_explanation(freed, problem, laws, baseline);
  if (freed.cost_with_parameters() < candidate.cost_with_parameters()) candidate = std::move(freed);
}

/// Sets that are not fitted yet, each with the smaller fit that it grows from by one effect.
class LargerSets {
 public:
  LargerSets(std::set<Effects>& tried, const std::vector<const Candidate*>& from) : tried_(tried) {
    for (const auto* candidate : from) grown_.push_back(candidate->fit);
  }

  void grow_by(const Effect* effect) {
    for (const ModelFit& fit : grown_) {
      Effects set = fit.explanation->effects();
      if (std::find(set.begin(), set.end(), effect) != set.end()) continue;
      set.push_back(effect);
      add(set, fit);
    }
  }
  void add(Effects set, const ModelFit& near) {
    std::sort(set.begin(), set.end());
    if (Explanation::compatible(set) && tried_.insert(set).second) sets_.push_back({set, &near});
  }

  std::vector<Candidate> fitted(const FitProblem& problem, const LawErrors& laws,
                                const ModelFit& baseline) const {
    std::vector<Candidate> fitted(sets_.size());
#pragma omp parallel for schedule(dynamic)
    for (std::size_t i = 0; i < sets_.size(); ++i) {
      fitted[i].fit = fit_explanation(problem, sets_[i].first, sets_[i].second);
      cost_explanation(fitted[i], problem, laws, baseline);
      free_what_is_earned(fitted[i], problem, laws, baseline, sets_[i].second);
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
  return size == 1 ? "effects" : size == 2 ? "pairs of effects" : "sets of three";
}

Effects admissible_effects(const Experiment& experiment) {
  Effects admissible;
  for (const auto& effect : effect_catalogue())
    if (effect->is_shown_by(experiment) && has_a_form(*effect, experiment))
      admissible.push_back(effect.get());
  return admissible;
}

class Search {
 public:
  Search(const FitProblem& problem, const ModelFit& baseline, const IsNoise& is_noise,
         const std::function<void(const std::string&)>& progress)
      : problem_(problem),
        is_noise_(is_noise),
        progress_(progress),
        laws_(problem.samples),
        admissible_(admissible_effects(problem.experiment)) {
    result_.alone.fit = baseline;
    result_.alone.cost = baseline.cost;
    if (problem.correction) cost_explanation(result_.alone, problem, laws_, baseline);
    result_.admissible = admissible_.size();
  }

  SearchResult run() {
    if (!leaves_noise_after_sets_of_three()) grow_from_what_is_off_contact();
    refit_in_simpler_form(result_, problem_, laws_);
    refit_within_larger(result_, problem_, laws_);
    return std::move(result_);
  }

 private:
  /// True where nothing more needs to be looked for.
  bool leaves_noise_after_sets_of_three() {
    bool leaves_noise = false;  // two effects do: a third is only another value of the simulation
    for (std::size_t size = 1; size <= largest_set; ++size) {
      LargerSets sets(tried_, size == 1
                                  ? std::vector<const Candidate*>{&result_.alone}
                                  : best_of_size(result_, size - 1,
                                                 size == 2 ? widest_beam_of_singles : widest_beam_of_pairs));
      for (const Effect* effect : admissible_)
        if (!leaves_noise || effect->is_another_value()) sets.grow_by(effect);
      fit(sets, sets_in_words(size));
      if (result_.candidates.empty()) return true;
      // Noise of which no effect takes anything away holds no pairs either.
      constexpr double something = 2;
      if (size == 1 && is_noise_(result_.alone.fit) &&
          result_.candidates.front().score < result_.alone.score + something)
        return true;
      // Three effects are looked for only where two leave structure.
      leaves_noise = size >= 2 && is_noise_(result_.candidates.front().fit);
    }
    return leaves_noise;
  }

  /// Up to three effects beside several of the instrument that samples off contact show by themselves: a
  /// large mismatch in contact would hide them from each other.
  void grow_from_what_is_off_contact() {
    Effects shown = shown_off_contact(problem_, result_.alone.fit, admissible_);
    if (shown.size() < 2) return;
    std::sort(shown.begin(), shown.end());
    result_.shown_off_contact = shown;
    LargerSets first(tried_, {});
    first.add(shown, result_.alone.fit);
    fit(first, "set that samples off contact show");
    const std::size_t most = std::min(largest_set, largest_beside_off_contact - shown.size());
    for (std::size_t more = 1; more <= most; ++more) {
      LargerSets sets(tried_, best_with(shown, more - 1));
      for (const Effect* effect : admissible_) sets.grow_by(effect);
      fit(sets, "sets beside what samples off contact show");
      if (more >= 2 && is_noise_(result_.candidates.front().fit)) return;
    }
  }

  /// The best sets of these and so many others.
  std::vector<const Candidate*> best_with(const Effects& shown, std::size_t others) const {
    std::vector<const Candidate*> list;
    for (const auto& candidate : result_.candidates) {
      Effects have = candidate.fit.explanation->effects();
      std::sort(have.begin(), have.end());
      if (have.size() == shown.size() + others &&
          std::includes(have.begin(), have.end(), shown.begin(), shown.end()) &&
          list.size() < widest_beam_of_pairs)
        list.push_back(&candidate);
    }
    return list;
  }

  void fit(const LargerSets& sets, const std::string& words) {
    if (progress_ && sets.count() > 0) progress_("fitting " + std::to_string(sets.count()) + " " + words);
    const std::vector<Candidate> fitted = sets.fitted(problem_, laws_, result_.alone.fit);
    result_.candidates.insert(result_.candidates.end(), fitted.begin(), fitted.end());
    score_all(result_, problem_);
  }

  const FitProblem& problem_;
  const IsNoise& is_noise_;
  const std::function<void(const std::string&)>& progress_;
  LawErrors laws_;
  Effects admissible_;
  std::set<Effects> tried_;
  SearchResult result_;
};

}  // namespace

SearchResult search_effects(const FitProblem& problem, const ModelFit& baseline, const IsNoise& is_noise,
                            const std::function<void(const std::string&)>& progress) {
  return Search(problem, baseline, is_noise, progress).run();
}

}  // namespace asperity
