// asperity conceal: a recording in which an effect is hidden, with its sealed truth.
#pragma once

namespace CLI {
class App;
}

namespace asperity {

void add_conceal_command(CLI::App& app);

}  // namespace asperity
