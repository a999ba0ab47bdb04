#include "diagnosis/open_alternatives.h"

#include <algorithm>

#include "diagnosis/choose/members.h"
#include "diagnosis/describe.h"

namespace asperity {

AlternativeExplanation alternative_left_open(const FitProblem& problem, const ModelFit& baseline,
                                             const OpenSet& set, double all_weights) {
  FitProblem on_part = problem;
  on_part.samples = set.part;
  const ModelFit fit = finished(on_part, set.fit);
  AlternativeExplanation alternative;
  alternative.probability = set.weight() / all_weights;
  alternative.effects = described_effects(on_part, fit, baseline, alternative.probability);
  alternative.held_out_chi2_reduced = predict_held_out(on_part, fit, blocks_of(set.part)).chi2_reduced;
  alternative.told_apart_by = set.told_by;
  return alternative;
}

std::vector<const OpenSet*> open_beside(const std::vector<OpenSet>& sets, const ModelFit& chosen,
                                        bool clean) {
  std::vector<const OpenSet*> beside;
  for (const OpenSet& set : sets)
    if (!(clean && set.holds_more_than(chosen) && set.behind > -clear_evidence)) beside.push_back(&set);
  return beside;
}

std::vector<AlternativeExplanation> alternatives_left_open(const FitProblem& problem,
                                                           const ModelFit& baseline,
                                                           const std::vector<OpenSet>& sets) {
  std::vector<const OpenSet*> able;
  for (const OpenSet& set : sets)
    if (set.could_explain) able.push_back(&set);
  const std::vector<const OpenSet*> all = able;
  able.erase(std::remove_if(able.begin(), able.end(),
                            [&](const OpenSet* set) {
                              return std::any_of(all.begin(), all.end(), [&](const OpenSet* fewer) {
                                return set->holds_more_than(fewer->fit) &&
                                       set->behind > fewer->behind - clear_evidence;
                              });
                            }),
             able.end());
  double weight = 0;
  for (const OpenSet* set : able) weight += set->weight();
  std::stable_sort(able.begin(), able.end(),
                   [](const OpenSet* a, const OpenSet* b) { return a->behind < b->behind; });
  std::vector<AlternativeExplanation> list;
  for (const OpenSet* set : able) list.push_back(alternative_left_open(problem, baseline, *set, weight));
  return list;
}

}  // namespace asperity
