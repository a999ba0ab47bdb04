// The two ways a command ends that is not success; app/ turns them into exit status 2 and 1.
#pragma once

#include <stdexcept>
#include <string>

namespace asperity {

/// The input was refused (exit status 2). The message is one sentence that names file, line and remedy.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The work failed (exit status 1); what was accepted before is kept. The message says what to do about it.
class WorkError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace asperity
