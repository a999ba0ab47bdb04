// Solves the cases of a study, each in a process and a folder of its own, several at a time.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/study.h"
#include "app/study_summary.h"

namespace asperity {

/// Where and how many at a time.
struct StudyRunOptions {
  std::filesystem::path output;
  bool resume = false;  ///< go on with what is in `output`: keep complete cases, resume begun ones
  bool overwrite =
      false;      ///< go on, too, and solve complete cases of other inputs anew; what was there is set aside
  int cores = 1;  ///< shared by the cases that run at the same time
  std::function<bool(const std::string&)> chosen = [](const auto&) {
    return true;
  };                              ///< cases to solve now, by name; the others wait
  std::filesystem::path program;  ///< called as: program solve CASE.prm --output DIR --set Solver/Threads=n
                                  ///< [--resume | --overwrite]
  /// Why the program cannot go on with inputs of this SHA-256 in a folder where a case was begun, as the end
  /// of a sentence; such a case is solved anew. Empty: it can.
  std::function<std::string(const std::filesystem::path&, const std::string&)> objection_to_resume =
      [](const auto&, const auto&) { return std::string(); };
  /// Why a case that is being solved in a folder, for so many seconds, should not go on, as a sentence's end;
  /// it is stopped and has it as its message. Empty: it should.
  std::function<std::string(const std::filesystem::path&, double)> reason_to_stop;
  /// What a case takes on one core, roughly, by which the time that is left is told [s]; null: all alike.
  std::function<double(const StudyCase&)> expected_seconds;
  std::function<void(const std::string&)> say;  ///< receives progress, line by line
};

/// Runs all chosen cases; a failing one does not stop the others. After SIGINT or SIGTERM the running ones
/// are stopped and the rest left waiting. study.json and study.csv are up to date after each case, so that
/// the study can be killed at any time and resumed. Throws InputError if `output` holds a study and `resume`
/// is not set, and, unless `overwrite` is, if it holds a complete case of other inputs, or one that does not
/// say of which (app/inputs_hash.h).
std::vector<CaseProgress> run_study(const Study& study, const StudyRunOptions& options);

}  // namespace asperity
