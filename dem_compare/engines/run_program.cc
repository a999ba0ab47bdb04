#include "dem_compare/engines/run_program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <sstream>
#include <thread>

#include "core/error.h"

extern char** environ;

namespace asperity {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Without what an MPI launcher left: an engine that found it would take itself for one of this launch's ranks.
std::vector<std::string> environment_without_mpi() {
  std::vector<std::string> entries;
  for (char** entry = environ; *entry; ++entry) {
    const std::string text = *entry;
    const bool is_launcher = text.rfind("OMPI_COMM", 0) == 0 || text.rfind("PMIX_", 0) == 0 || text.rfind("PMI_", 0) == 0;
    if (!is_launcher) entries.push_back(text);
  }
  return entries;
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (auto& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

pid_t start(std::vector<std::string> arguments, const fs::path& folder, const fs::path& log) {
  std::vector<std::string> environment = environment_without_mpi();
  const std::vector<char*> argv = pointers_to(arguments), envp = pointers_to(environment);
  const int log_file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (log_file < 0) throw WorkError("cannot write '" + log.string() + "': " + std::strerror(errno));
  const pid_t parent = ::getpid(), id = ::fork();
  if (id == 0) {
    // Only calls that are safe after fork from here on.
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent || ::chdir(folder.c_str()) != 0) ::_exit(126);
    const int no_input = ::open("/dev/null", O_RDONLY);
    if (no_input >= 0) ::dup2(no_input, STDIN_FILENO);
    ::dup2(log_file, STDOUT_FILENO);
    ::dup2(log_file, STDERR_FILENO);
    ::execve(argv[0], argv.data(), envp.data());
    ::_exit(127);
  }
  ::close(log_file);
  if (id < 0) throw WorkError(std::string("cannot start another process: ") + std::strerror(errno));
  return id;
}

}  // namespace

fs::path find_program(const std::string& name) {
  const auto is_executable = [](const fs::path& path) { return fs::is_regular_file(path) && ::access(path.c_str(), X_OK) == 0; };
  if (name.find('/') != std::string::npos) return is_executable(name) ? fs::absolute(name) : fs::path();
  const char* path = ::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (is_executable(fs::path(folder) / name)) return fs::absolute(fs::path(folder) / name);
  return {};
}

ProgramRun run_program(const std::vector<std::string>& arguments, const fs::path& folder, const std::string& log,
                       std::chrono::seconds limit) {
  const auto began = Clock::now();
  const pid_t id = start(arguments, folder, fs::absolute(folder / log));
  constexpr auto first_pause = std::chrono::milliseconds(5), longest_pause = std::chrono::milliseconds(50);
  for (auto pause = first_pause;; pause = std::min(2 * pause, longest_pause)) {
    int status = 0;
    if (::waitpid(id, &status, WNOHANG) == id)
      return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
              std::chrono::duration<double>(Clock::now() - began).count()};
    if (Clock::now() - began > limit) {
      ::kill(-id, SIGKILL);
      ::waitpid(id, nullptr, 0);
      throw WorkError("'" + arguments.front() + "' did not end within " + std::to_string(limit.count()) +
                      " s and was stopped; take a smaller amplitude, or --time-limit");
    }
    std::this_thread::sleep_for(pause);
  }
}

}  // namespace asperity
