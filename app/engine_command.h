// asperity engine: one experiment run by LAMMPS or YADE; asperity engine-input: what a user pastes into an
// engine.
#pragma once

namespace CLI {
class App;
}

namespace asperity {

void add_engine_commands(CLI::App& app);

}  // namespace asperity
