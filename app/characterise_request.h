// What the arguments of `asperity characterise` ask for, in SI units.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/materials.h"
#include "core/hertz.h"
#include "core/topography_spec.h"

namespace asperity {

/// What is typed.
struct CharacteriseArguments {
  std::vector<std::string> scans;  ///< of the substrate, and of the particle if there are two
  std::string particle, substrate, loads, engine = "lammps", output;
  std::string friction, adhesion;
  std::string accuracy = "15%", time = "20 min";
  std::string level = "plane", size, height_unit, channel, surface = "auto";
  bool quick = false, plan = false, overwrite = false;
};

/// Attraction of the surfaces.
struct AdhesionRequest {
  double work = 0;   ///< of adhesion [J/m^2]
  double range = 0;  ///< of the attraction [m]
};

/// How a scan becomes the surface of a body.
enum class SurfaceFrom {
  automatic,  ///< spectrum where the heights are Gaussian, else the scan
  scan,       ///< heights as measured, one place
  spectrum    ///< realisations with the measured spectrum
};

/// What is asked for.
struct CharacteriseRequest {
  ScanParameters substrate_scan;
  std::optional<ScanParameters> particle_scan;
  SurfaceFrom surface = SurfaceFrom::automatic;
  ParticleText particle;
  Material substrate;
  std::vector<double> loads;  ///< [N] ends of the range, rising; one or two
  std::vector<double>
      friction;  ///< local coefficients; two where they bracket what is not known (quick: their middle)
  bool friction_is_known = true;
  std::optional<AdhesionRequest> adhesion;
  double accuracy = 0.15;  ///< asked for, half a 95 % interval over the value [-]
  double time = 1200;      ///< for solving [s]
  bool quick = false;
};

/// The particle on the substrate, both smooth.
Hertz smooth_contact(const CharacteriseRequest& request);

/// Throws InputError naming the argument that cannot be meant.
CharacteriseRequest request_of(const CharacteriseArguments& arguments);

}  // namespace asperity
