// Solves the cases of a study, each in a process and a folder of its own, several at a time.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/study.h"
#include "app/study_summary.h"

namespace asperity {

struct StudyRunOptions {
  std::filesystem::path output;
  bool resume = false;            ///< go on with what is in `output`: keep complete cases, resume begun ones
  int cores = 1;                  ///< shared by the cases that run at the same time
  std::function<bool(const std::string&)> chosen = [](const auto&) { return true; };  ///< cases to solve now, by name; the others wait
  std::filesystem::path program;  ///< called as: program solve CASE.prm --output DIR --set Solver/Threads=n [--resume]
  /// Whether the program can go on with a case begun in a folder; one that it cannot is solved anew.
  std::function<bool(const std::filesystem::path&)> can_resume = [](const auto&) { return true; };
  std::function<void(const std::string&)> say;  ///< receives progress, line by line
};

/// Runs all chosen cases; a failing one does not stop the others. After SIGINT or SIGTERM the running ones are stopped and the
/// rest left waiting. study.json and study.csv are up to date after each case, so that the study can be killed at any
/// time and resumed. Throws InputError if `output` holds a study and `resume` is not set.
std::vector<CaseProgress> run_study(const Study& study, const StudyRunOptions& options);

}  // namespace asperity
