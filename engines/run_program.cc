#include "engines/run_program.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <thread>

#include "core/child_process.h"
#include "core/error.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

}  // namespace

fs::path find_program(const std::string& name) {
  const auto is_executable = [](const fs::path& path) {
    return fs::is_regular_file(path) && ::access(path.c_str(), X_OK) == 0;
  };
  if (name.find('/') != std::string::npos) return is_executable(name) ? fs::absolute(name) : fs::path();
  const char* path = ::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (is_executable(fs::path(folder) / name)) return fs::absolute(fs::path(folder) / name);
  return {};
}

ProgramRun run_program(const std::vector<std::string>& arguments, const fs::path& folder,
                       const std::string& log, std::chrono::seconds limit,
                       const std::vector<std::string>& environment) {
  const auto began = Clock::now();
  fs::remove(folder / log);
  ChildProcess program(arguments, fs::absolute(folder / log), environment, folder);
  constexpr auto first_pause = std::chrono::milliseconds(5), longest_pause = std::chrono::milliseconds(50);
  for (auto pause = first_pause;; pause = std::min(2 * pause, longest_pause)) {
    if (const auto status = program.exit_status())
      return {*status, std::chrono::duration<double>(Clock::now() - began).count()};
    if (Clock::now() - began > limit)
      throw WorkError("'" + arguments.front() + "' did not end within " + std::to_string(limit.count()) +
                      " s and was stopped; take a smaller amplitude, or --time-limit");
    std::this_thread::sleep_for(pause);
  }
}

}  // namespace asperity
