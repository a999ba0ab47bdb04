// asperity surface measure | generate | afm: topographies measured, made, and judged as a microscope would
// see them.
#pragma once

namespace CLI {
class App;
}

namespace asperity {

void add_surface_command(CLI::App& app);

}  // namespace asperity
