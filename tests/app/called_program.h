// Calls the program as a person or a script does.
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace asperity::test {

struct Outcome {
  int status;
  std::string output;  ///< and errors
};

inline Outcome call_program(const std::string& program, const std::string& arguments) {
  FILE* pipe = ::popen((program + " " + arguments + " 2>&1").c_str(), "r");
  Outcome outcome{-1, ""};
  if (!pipe) return outcome;
  std::array<char, 4096> buffer;
  while (std::fgets(buffer.data(), buffer.size(), pipe)) outcome.output += buffer.data();
  const int status = ::pclose(pipe);
  if (WIFEXITED(status)) outcome.status = WEXITSTATUS(status);
  return outcome;
}
inline Outcome call(const std::string& arguments) { return call_program(ASPERITY_EXECUTABLE, arguments); }

}  // namespace asperity::test
