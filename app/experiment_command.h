// `asperity experiment`: one of the paper's experiments with one particle, by the reduced laws; `asperity
// laws`: their manual.
#pragma once

namespace CLI {
class App;
}

namespace asperity {

void add_experiment_commands(CLI::App& app);

}  // namespace asperity
