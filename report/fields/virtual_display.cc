#include "report/fields/virtual_display.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cctype>
#include <csignal>
#include <cstdlib>

namespace asperity::report {
namespace {

constexpr int start_timeout_ms = 15000;

/// The display number the server writes when it is ready; empty if it ends or does not answer.
std::string read_display_number(int pipe) {
  std::string number;
  for (;;) {
    pollfd waiting{pipe, POLLIN, 0};
    if (poll(&waiting, 1, start_timeout_ms) <= 0) return "";
    char c = 0;
    if (read(pipe, &c, 1) <= 0) return "";
    if (c == '\n') return number;
    if (std::isdigit(static_cast<unsigned char>(c))) number += c;
  }
}

}  // namespace

VirtualDisplay::VirtualDisplay() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) {
    problem_ = "no pipe to the display server could be opened";
    return;
  }
  server_ = fork();
  if (server_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGTERM);  // the server must not outlive us, however we end
    constexpr int server_end = 3;
    if (ends[1] == server_end)
      fcntl(server_end, F_SETFD, 0);
    else
      dup2(ends[1], server_end);
    const int silence = open("/dev/null", O_RDWR);
    dup2(silence, STDOUT_FILENO);
    dup2(silence, STDERR_FILENO);
    execlp("Xvfb", "Xvfb", "-displayfd", "3", "-screen", "0", "1600x1200x24", "-nolisten", "tcp", nullptr);
    _exit(127);
  }
  close(ends[1]);
  const std::string number = server_ > 0 ? read_display_number(ends[0]) : "";
  close(ends[0]);
  if (!number.empty()) {
    name_ = ":" + number;
    return;
  }
  if (server_ > 0) {
    kill(server_, SIGKILL);
    waitpid(server_, nullptr, 0);
    server_ = -1;
  }
  const char* display = std::getenv("DISPLAY");
  if (display && *display)
    name_ = display;
  else
    problem_ = "there is no display to draw on; install the package xvfb and run 'asperity report' again";
}

VirtualDisplay::~VirtualDisplay() {
  if (server_ <= 0) return;
  kill(server_, SIGTERM);
  waitpid(server_, nullptr, 0);
}

}  // namespace asperity::report
