// Whether each effect of a set that was fitted earns its place in it.
#pragma once

#include "diagnosis/choose/search.h"
#include "diagnosis/locate/scan.h"

namespace asperity {

/// Log evidence by which an effect must be better than none, and a set than none for each of its members.
constexpr double clear_evidence = 8;

struct Members {
  /// Without any of them the evidence is clearly less, and a part of the mismatch comes back that is either
  /// large or more than the laws of the others may be off by. What samples off contact show by themselves
  /// need not earn it.
  bool count = true;
  /// The set without the member that only mends what the law of a layer is off by, where nothing else is
  /// against the set; null: there is none.
  const Candidate* mended = nullptr;
};
/// Looks at each member of a set, whose scores are those of `search`.
Members members_of(const FitProblem& problem, const SearchResult& search, const Scanner& scanner,
                   const Candidate& candidate);

/// Counts for a layer, of asperities or a film, what sets say in which a second effect mends its law: real
/// layers follow it to some per cent, by which others would overtake it that are nothing of the kind. Not
/// where a layer, in a set that is not far behind the best, fits by its own law.
void credit_layers(const FitProblem& problem, const Scanner& scanner, SearchResult& search);

/// Whether it holds a layer on the surface, of asperities or a film.
bool is_layer(const ModelFit& fit);
/// Whether both hold one: these look alike, whatever their laws say.
bool are_layers(const ModelFit& one, const ModelFit& other);
/// Ahead if all laws were off by what they state; not said of a layer whose score is of a set that mends it.
bool would_be_ahead(const Candidate& candidate, const Candidate& best);
/// Too far behind the best for a rival: odds of 10^4, or of 10^6 of one layer to another that would be ahead
/// if all laws were off by what they state.
bool is_far_behind(const Candidate& candidate, const Candidate& best);

}  // namespace asperity
