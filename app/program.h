// What every program of asperity does around its commands: options of all, messages, exit status.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace asperity {

/// Reads the command line, runs the command that it names, and gives the exit status: 0 done, 1 the work
/// failed, 2 the input was refused.
int run_program(int argc, char** argv, const std::function<void(CLI::App&)>& add_commands);

}  // namespace asperity
