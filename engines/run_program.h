// A program run to its end in a folder, its output in a log file there.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// Where a program stands in PATH (or the path itself, if it holds a '/'); empty if there is none.
std::filesystem::path find_program(const std::string& name);

/// How it ended.
struct ProgramRun {
  int status = 0;        ///< exit status; 128 + signal if a signal ended it
  double wall_time = 0;  ///< [s]
};

/// Runs `arguments[0]` in `folder` with output and errors in `folder/log`, without input; entries
/// "NAME=value" of `environment` replace this process's. It is killed, with what it started, after the time
/// limit (throws WorkError) and does not outlive this program.
ProgramRun run_program(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                       const std::string& log, std::chrono::seconds limit,
                       const std::vector<std::string>& environment = {});

}  // namespace asperity
