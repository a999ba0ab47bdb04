// asperity materials: the materials that have a name.
#pragma once

namespace CLI {
class App;
}

namespace asperity {

/// Adds `materials`, which prints the page of docs/materials.md.
void add_materials_command(CLI::App& app);

}  // namespace asperity
