// asperity compare DIR...: solved cases and studies against Hertz.
#pragma once

namespace CLI {
class App;
}

namespace asperity {

void add_compare_command(CLI::App& app);

}  // namespace asperity
