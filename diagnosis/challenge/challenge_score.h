// What a diagnosis got right of a concealed recording.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "diagnosis/challenge/challenge_matrix.h"
#include "diagnosis/challenge/user_baselines.h"
#include "diagnosis/outcome/diagnosis.h"

namespace asperity {

/// A parameter's true value beside its estimate and interval, all in its unit.
struct ScoredParameter {
  std::string name;  ///< "lateral_compliance/compliance"
  double truth = 0, estimate = 0, low = 0, high = 0;
  bool covered() const { return low <= truth && truth <= high; }
};

struct ChallengeScore {
  std::string name, family, mode;
  std::vector<std::string> truth, named;  ///< effects, in order of their names
  std::vector<std::vector<std::string>> alternatives;
  std::string verdict;
  double noise = 0, seconds = 0;  ///< share of the largest response; run time [s]
  std::vector<ScoredParameter>
      parameters;       ///< of effects named rightly, where truth and catalogue mean the same
  double overlap = -1;  ///< of located and true region; -1: there is nothing to locate [-]
  double held_out_before = 0, held_out_after = 0;  ///< reduced chi^2 of data held out [-]
  UserBaselines baselines;
  std::string failure;  ///< what went wrong with the diagnosis itself

  bool names_the_truth() const { return named == truth; }
  /// The truth is the answer or stands among the alternatives.
  bool holds_the_truth() const;
  /// Right as the family asks: named exactly; kept clean; admitted; said to be ambiguous with the truth among
  /// the candidates.
  bool is_right() const;
};

/// Holds a diagnosis against the truth.
ChallengeScore score_of(const ChallengeItem& item, const ConcealedRecording& concealed,
                        const Diagnosis& diagnosis);

/// Share of agreement (Dice 1945) of the samples that the diagnosis' regions hold with those where the effect
/// is larger than half the noise.
double location_overlap(const Recording& recording, const Truth& truth, const Diagnosis& diagnosis);

/// A score as JSON, and back.
nlohmann::ordered_json score_json(const ChallengeScore& score);
/// From what score_json wrote.
ChallengeScore score_from(const nlohmann::ordered_json& json);

}  // namespace asperity
