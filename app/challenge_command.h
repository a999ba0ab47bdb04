// asperity challenge: the proof of the diagnosis on concealed effects.
#pragma once

namespace CLI {
class App;
}

namespace asperity {

void add_challenge_command(CLI::App& app);

}  // namespace asperity
