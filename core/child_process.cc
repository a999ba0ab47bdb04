#include "core/child_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "core/error.h"

extern char** environ;

namespace asperity {
namespace {

/// This process's environment with `replaced` entries, without the variables of an MPI launcher (a child that
/// found them would take itself for one of this launch's ranks).
std::vector<std::string> environment_of_child(const std::vector<std::string>& replaced) {
  std::vector<std::string> entries = replaced;
  for (char** entry = environ; *entry; ++entry) {
    const std::string text = *entry;
    const std::string name = text.substr(0, text.find('=') + 1);
    bool keep = name.rfind("OMPI_", 0) != 0 && name.rfind("PMIX_", 0) != 0 && name.rfind("PMI_", 0) != 0;
    for (const auto& other : replaced) keep = keep && other.rfind(name, 0) != 0;
    if (keep) entries.push_back(text);
  }
  return entries;
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (auto& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& arguments, const std::filesystem::path& log,
                           const std::vector<std::string>& environment, const std::filesystem::path& folder) {
  std::vector<std::string> argument_texts = arguments, environment_texts = environment_of_child(environment);
  const std::vector<char*> argv = pointers_to(argument_texts), envp = pointers_to(environment_texts);
  const int log_file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (log_file < 0) throw WorkError("cannot write '" + log.string() + "': " + std::strerror(errno));
  const pid_t parent = ::getpid();
  id_ = ::fork();
  if (id_ == 0) {
    // Only calls that are safe after fork from here on.
    ::setpgid(0, 0);  // Ctrl-C reaches this program alone, which stops its children in order
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(1);
    if (!folder.empty() && ::chdir(folder.c_str()) != 0) ::_exit(126);
    const int no_input = ::open("/dev/null", O_RDONLY);
    if (no_input >= 0) ::dup2(no_input, STDIN_FILENO);
    ::dup2(log_file, STDOUT_FILENO);
    ::dup2(log_file, STDERR_FILENO);
    ::execve(argv[0], argv.data(), envp.data());
    const char message[] = "cannot start the program\n";
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, message, sizeof message - 1);
    ::_exit(127);
  }
  ::close(log_file);
  if (id_ > 0) ::setpgid(id_, id_);  // whichever of the two comes first
  if (id_ < 0) throw WorkError(std::string("cannot start another process: ") + std::strerror(errno));
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept : id_(other.id_), status_(other.status_) {
  other.id_ = -1;
}

ChildProcess::~ChildProcess() {
  if (id_ < 0 || status_) return;
  ::kill(-id_, SIGKILL);
  ::waitpid(id_, nullptr, 0);
}

std::optional<int> ChildProcess::exit_status() {
  if (status_) return status_;
  int status = 0;
  if (::waitpid(id_, &status, WNOHANG) == id_)
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return status_;
}

void ChildProcess::ask_to_stop() {
  if (!exit_status()) ::kill(-id_, SIGTERM);
}

}  // namespace asperity
