// Which sets are worth solutions by finite elements, and in which order.
#include <algorithm>

#include "core/printed.h"
#include "diagnosis/mapping/effects_in_case.h"
#include "diagnosis/mapping/solved_case_mapping.h"

namespace asperity {
namespace {

using Effects = std::vector<const Effect*>;

/// Log evidence over the simulation alone from which a single effect is worth solutions of its own.
constexpr double worth_solving = 8;
constexpr std::size_t most_survivors = 3;
/// Log evidence by which another must be better for a set not to be solved, by reduced laws and what they may
/// be off by.
constexpr double excluded_by_law = 50;
/// Log evidence within which reduced laws, and the mesh's error that they are corrected with, do not tell.
constexpr double undecided = 8;

/// Null: none of these effects.
const Candidate* candidate_of(const SearchResult& search, const Effects& effects) {
  for (const Candidate& candidate : search.candidates)
    if (const Effects& its = candidate.fit.explanation->effects();
        std::is_permutation(its.begin(), its.end(), effects.begin(), effects.end()))
      return &candidate;
  return nullptr;
}

/// Those that are wanted, the best first; of sets with the same entries of the case, which one solution may
/// serve, the smallest first.
std::vector<Candidate> in_order(const SearchResult& search, const Experiment& experiment,
                                const std::set<std::set<const Effect*>>& wanted) {
  std::vector<std::vector<Candidate>> groups;
  for (const Candidate& candidate : search.candidates) {
    const Effects& effects = candidate.fit.explanation->effects();
    if (!wanted.count({effects.begin(), effects.end()})) continue;
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const std::vector<Candidate>& of) {
      return have_same_entries(of.front().fit.explanation->effects(), effects, experiment);
    });
    if (group == groups.end())
      groups.push_back({candidate});
    else
      group->push_back(candidate);
  }
  std::vector<Candidate> ordered;
  for (auto& group : groups) {
    std::stable_sort(group.begin(), group.end(), [](const Candidate& a, const Candidate& b) {
      return a.fit.explanation->effects().size() < b.fit.explanation->effects().size();
    });
    ordered.insert(ordered.end(), group.begin(), group.end());
  }
  return ordered;
}

}  // namespace

std::vector<Candidate> SolvedCaseMapping::worth_solutions(const SearchResult& search,
                                                          const FitProblem& problem,
                                                          const std::vector<const Candidate*>& survivors) {
  std::set<std::set<const Effect*>> wanted;
  const auto want = [&](const Effects& effects) {
    if (!in_case(effects, problem.experiment).empty()) wanted.insert({effects.begin(), effects.end()});
  };
  std::set<std::string> said;
  const auto is_excluded = [&](const Candidate& candidate) {
    const Candidate& best = search.candidates.front();
    const std::string name = candidate.fit.explanation->name();
    if (candidate.score >= best.score - excluded_by_law) return false;
    if (said.insert(name).second)
      remarks_.push_back(name + " was not solved: by its reduced law and what that may be off by, " +
                         best.fit.explanation->name() +
                         printed(" is better by %.0f in log evidence", best.score - candidate.score));
    return true;
  };
  // What survived, with one member less too: a member must earn its place.
  for (std::size_t i = 0; i < std::min(most_survivors, survivors.size()); ++i) {
    const Effects& effects = survivors[i]->fit.explanation->effects();
    want(effects);
    for (const Effect* left_out : effects) {
      Effects fewer = effects;
      fewer.erase(std::find(fewer.begin(), fewer.end(), left_out));
      const Candidate* candidate = candidate_of(search, fewer);
      if (in_case(fewer, problem.experiment).empty() || wanted.count({fewer.begin(), fewer.end()})) continue;
      if (!candidate || (candidate->fit.is_itself() && !is_excluded(*candidate))) want(fewer);
    }
  }
  // The same beside another value of what the case states: the mesh's error may hide it until both are
  // solved.
  const std::set<std::set<const Effect*>> surviving = wanted;
  for (const Candidate& candidate : search.candidates) {
    if (candidate.score < search.candidates.front().score - undecided) continue;
    const Effects& effects = candidate.fit.explanation->effects();
    for (const Effect* value : effects) {
      if (!value->is_another_value()) continue;
      std::set<const Effect*> others(effects.begin(), effects.end());
      others.erase(value);
      if (surviving.count(others)) want(effects);
    }
  }
  // The best by reduced laws, even where a member changes little: finite elements may say otherwise.
  if (search.explains()) want(search.candidates.front().fit.explanation->effects());
  // What stands for a simpler effect is solved in that one's name.
  for (const auto& candidate : search.candidates) {
    const Effects& effects = candidate.fit.explanation->effects();
    const bool helps = effects.size() == 1 && candidate.score > search.alone.score + worth_solving;
    if (helps && !in_case(effects, problem.experiment).empty() && !wanted.count({effects.front()}) &&
        candidate.fit.is_itself() && !is_excluded(candidate))
      want(effects);
  }
  return in_order(search, problem.experiment, wanted);
}

}  // namespace asperity
