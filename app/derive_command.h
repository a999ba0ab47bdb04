// asperity derive DIR...: from solved cases to parameters.json.
#pragma once

namespace CLI {
class App;
}

namespace asperity {

void add_derive_command(CLI::App& app);

}  // namespace asperity
