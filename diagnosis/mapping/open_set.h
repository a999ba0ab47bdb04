// Sets of effects that were worth a solution and that stay open: the solution ended early or failed, and what
// was solved does not exclude them.
#pragma once

#include <string>

#include "diagnosis/choose/search.h"

namespace asperity {

struct OpenSet {
  ModelFit
      fit;  ///< to the part that was solved; where nothing was, by the corrected reduced law to all of it
  Samples part;         ///< the samples that the solution reached count
  double behind;        ///< log evidence by which the best of the other sets is better on that part [-]
  bool could_explain;   ///< on that part it leaves noise, and the simulation alone leaves clearly more
  std::string told_by;  ///< what would tell, as the end of a sentence

  /// What it weighs beside the best of the others: at most as much, since not all of it was compared [-].
  double weight() const;
  /// Has all effects of `other` and more.
  bool holds_more_than(const ModelFit& other) const;
};

/// A set judged on `part`, beside the best of the others and the simulation alone.
OpenSet open_set(const FitProblem& problem, const SearchResult& search, const ModelFit& fit,
                 const Samples& part, std::string told_by);

}  // namespace asperity
