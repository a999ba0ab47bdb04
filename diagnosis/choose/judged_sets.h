// Which of the sets that were fitted may be named at all: each member earns its place, the parameters hold
// everywhere, and data kept out of the fit are predicted better than by the simulation alone.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "diagnosis/choose/held_out.h"
#include "diagnosis/choose/leftover.h"
#include "diagnosis/choose/search.h"
#include "diagnosis/locate/scan.h"

namespace asperity {

/// Log evidence within which two explanations are as good: odds of ten to one.
constexpr double as_good = 2.3;
/// A set of effects whose members were judged.
struct JudgedSet {
  const Candidate* candidate;
  ModelFit fit;
  HeldOut held_out;

  /// Its effects are all among those of the other.
  bool is_part_of(const JudgedSet& other) const;
};

/// How another set stands beside the chosen one.
struct Rivalry {
  double difference;  ///< of log evidence: how much better the chosen one is [-]
  /// Within odds of ten to one and predicts data kept out as well; or within their square, of no more
  /// parameters and the same in these data but for their noise, so that priors alone decide; or ahead if all
  /// laws were off by what they state, so that it depends on how exact they are.
  bool is_as_good;
  bool is_near;  ///< within the square of these odds, or as good
};
Rivalry rivalry(const FitProblem& problem, const JudgedSet& chosen, const JudgedSet& other);

struct JudgedSets {
  std::vector<JudgedSet> list;  ///< the best first
  std::vector<std::string>
      inconsistent;  ///< would fit only with other parameters in different parts of the data
  std::vector<std::string>
      stopped;  ///< would fit best with a parameter beyond its bounds: "NAME (PARAMETER)"

  /// Other sets, none of which is the chosen one with something added or left out.
  std::vector<const JudgedSet*> rivals_of(const JudgedSet& chosen) const;
};

/// Credits layers in `search` first, see credit_layers(). is_no_effect: whether what would be said of a fit
/// holds "no effect"; null: its own interval decides.
JudgedSets judged_sets(const FitProblem& problem, SearchResult& search, const Scanner& scanner,
                       const Blocks& blocks, const HeldOut& baseline_held_out,
                       const std::function<bool(const ModelFit&)>& is_no_effect = nullptr);

}  // namespace asperity
