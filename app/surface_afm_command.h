// asperity surface afm: which Gaussian surfaces have a published RMS and peak to valley, as a microscope
// would see them.
#pragma once

namespace CLI {
class App;
}

namespace asperity {

/// Adds `afm` to the subcommand `surface`.
void add_surface_afm_command(CLI::App& surface);

}  // namespace asperity
