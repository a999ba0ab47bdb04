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
  /// Diagnoses a recording against a case of finite elements, with entries that replace the case's; keeps
  /// what it solves in `folder`. None: the simulation is reduced laws, and the matrix another one.
  std::function<Diagnosis(const Recording& recording, const std::filesystem::path& case_file,
                          const std::vector<std::string>& entries, const std::filesystem::path& folder)>
      diagnose_by_case;
};

/// The matrix that these options ask for. Throws InputError where nothing has `only` in its name.
std::vector<ChallengeItem> items_of(const ChallengeOptions& options);

/// Folders output/NAME with recording, truth.json, diagnosis.json and score.json; a diagnosis that throws is
/// scored as a failure.
std::vector<ChallengeScore> run_challenge(const ChallengeOptions& options);

/// Confusion matrix, rates against their targets, parameters, location, held-out data, the user's own
/// baselines; Markdown.
std::string challenge_text(const std::vector<ChallengeScore>& scores);
std::string challenge_json(const std::vector<ChallengeScore>& scores);

}  // namespace asperity
