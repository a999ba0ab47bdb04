#include "diagnosis/mapping/open_set.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnosis/choose/leftover.h"
#include "diagnosis/choose/members.h"
#include "diagnosis/mapping/judged_part.h"

namespace asperity {

double OpenSet::weight() const { return std::exp(-std::max(0.0, behind)); }

bool OpenSet::holds_more_than(const ModelFit& other) const {
  const auto& own = fit.explanation->effects();
  const auto& others = other.explanation->effects();
  return own.size() > others.size() && std::all_of(others.begin(), others.end(), [&](const Effect* effect) {
           return std::find(own.begin(), own.end(), effect) != own.end();
         });
}

OpenSet open_set(const FitProblem& problem, const SearchResult& search, const ModelFit& fit,
                 const Samples& part, std::string told_by) {
  const ModelFit& alone = search.alone.fit;
  const ModelFit& best = search.explains() ? search.candidates.front().fit : alone;
  const auto behind = [&](const ModelFit& other) {
    return worse_on_part(problem, part, fit, other, search.overdispersion);
  };
  const auto counted =
      std::count_if(part.list.begin(), part.list.end(), [](const Sample& sample) { return sample.counts; });
  const bool leaves_noise =
      chi2_on_part(problem, part, fit, alone) < largest_of_noise(static_cast<std::size_t>(counted));
  return {fit, part, behind(best), leaves_noise && behind(alone) < -clear_evidence, std::move(told_by)};
}

}  // namespace asperity
