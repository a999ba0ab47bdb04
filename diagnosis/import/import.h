// Instruments' own text as a recording: asperity import.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/recording/recording.h"

namespace asperity {

/// What the text itself does not say.
struct ImportOptions {
  std::string format;  ///< "hysitron", "optics11", "fischer", "csv"; "": recognised from the text
  std::string title;
  Motion mode = Motion::normal;
  std::optional<double> radius;  ///< of the particle or tip [m]
  std::optional<double> particle_modulus,
      particle_poisson;  ///< default: diamond, or the sphere of the instrument
  std::optional<double> substrate_modulus, substrate_poisson;
  std::optional<double> spring_constant;  ///< of a cantilever, in place of the file's own [N/m]
  std::optional<int> run;                 ///< take this experiment of the file alone, from 1
  std::vector<std::string> control;       ///< in place of the format's own
  std::string response;
  /// Of format csv: "normal_force [mN] = load_mN", "lateral_force:backward [N] = lateral_bwd_V * 1e-9",
  /// "normal_force [nN] = 20".
  std::vector<std::string> columns;
};

/// Formats by name.
std::vector<std::string> import_formats();

/// Throws InputError: one sentence with file, line where there is one, and remedy.
Recording import_recording(const std::filesystem::path& file, const ImportOptions& options);

}  // namespace asperity
