// asperity challenge: conceals, diagnoses and scores a whole matrix of recordings; resumable, one folder for
// each.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "diagnosis/challenge/challenge_score.h"

namespace asperity {

/// Where, and how much of it.
struct ChallengeOptions {
  std::filesystem::path output;
  bool quick = false;
  unsigned seed = 0;    ///< added to the seeds of all recordings
  std::string only;     ///< recordings whose name holds this text
  int jobs = 1;         ///< recordings diagnosed side by side
  std::string program;  ///< changes when the program does: scores of another program are made anew
  std::function<void(const std::string&)> progress;
};

/// Folders output/NAME with recording, truth.json, diagnosis.json and score.json; a diagnosis that throws is
/// scored as a failure.
std::vector<ChallengeScore> run_challenge(const ChallengeOptions& options);

/// Confusion matrix, rates against their targets, parameters, location, held-out data, the user's own
/// baselines; Markdown.
std::string challenge_text(const std::vector<ChallengeScore>& scores);
std::string challenge_json(const std::vector<ChallengeScore>& scores);

}  // namespace asperity
