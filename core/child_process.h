// One program started beside this one, its output in a log file; it does not outlive this one.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

class ChildProcess {
 public:
  /// Starts `arguments[0]` in `folder` (none: this process's own); output and errors are appended to `log`;
  /// `environment` entries "NAME=value" replace this process's, and what an MPI launcher left there is taken
  /// out. Throws WorkError.
  ChildProcess(const std::vector<std::string>& arguments, const std::filesystem::path& log,
               const std::vector<std::string>& environment = {}, const std::filesystem::path& folder = {});
  /// Kills it, and what it started, if it still runs.
  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Exit status once it has ended (128 + signal if a signal ended it); does not wait.
  std::optional<int> exit_status();
  /// Asks it and what it started to end (SIGTERM).
  void ask_to_stop();

 private:
  pid_t id_ = -1;
  std::optional<int> status_;
};

}  // namespace asperity
