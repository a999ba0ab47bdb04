// asperity import: an instrument's own text as a recording.
#pragma once

namespace CLI {
class App;
}

namespace asperity {

void add_import_command(CLI::App& app);

}  // namespace asperity
