// asperity preview CASE.prm: stiffness, area, pressure and the mesh that a case needs, in seconds.
#pragma once

namespace CLI {
class App;
}

namespace asperity {

void add_preview_command(CLI::App& app);

}  // namespace asperity
