// asperity mesh CASE.prm --output DIR: the meshes of a case, their quality, and the surfaces for other
// programs.
#pragma once

namespace CLI {
class App;
}

namespace asperity {

void add_mesh_command(CLI::App& app);

}  // namespace asperity
