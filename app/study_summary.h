// What a study found so far: study.json and study.csv, one row per case, and the mean and scatter over
// realisations.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/study.h"

namespace asperity {

/// How far one case of a study is.
struct CaseProgress {
  enum class State { waiting, running, done, failed, stopped } state = State::waiting;
  double seconds = 0;   ///< wall time spent in this run of the study [s]
  std::string message;  ///< of a failed case: the last line of its log; of one stopped for a reason: that
};

/// True if `folder` holds a complete result.json.
bool has_result(const std::filesystem::path& folder);

/// Replaces study.json and study.csv in `output` by the state of all cases.
void write_study_summary(const Study& study, const std::vector<CaseProgress>& progress,
                         const std::filesystem::path& output);

}  // namespace asperity
