// asperity characterise: from a scan to an engine's input in one command.
#pragma once

namespace CLI {
class App;
}

namespace asperity {

/// Adds `characterise` with its options.
void add_characterise_command(CLI::App& app);

}  // namespace asperity
