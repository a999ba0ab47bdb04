// Where a solve writes, what it goes on from, and how it tells of its steps.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace asperity {

struct SolveOptions {
  std::filesystem::path output;
  bool resume = false;
  std::string inputs_sha256;  ///< of the case (app/inputs_hash.h), written into checkpoint and result
  std::function<void()>
      before_writing;  ///< called by the first rank once the case is meshed, before the first file is written
  std::function<void(const std::string&)> progress;  ///< one line per accepted step
  bool says_iterations = false;  ///< progress: a line per Newton step and per update of the tractions as well
};

}  // namespace asperity
