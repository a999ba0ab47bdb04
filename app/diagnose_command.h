// asperity diagnose RECORDING: where recording and simulation part, and what was left out.
#pragma once

namespace CLI {
class App;
}

namespace asperity {

void add_diagnose_command(CLI::App& app);

}  // namespace asperity
