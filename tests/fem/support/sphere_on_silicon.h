// The case that tests of whole meshes start from.
#pragma once

#include <string>

#include "core/case.h"

namespace asperity::test {

/// The paper's sphere on silicon.
inline CaseInput sphere_on_silicon(const std::string& particle, const std::string& substrate, double spacing,
                                   double region) {
  CaseInput input;
  input.file = "test.prm";
  input.radius = 8.5e-6;
  input.particle.youngs_modulus = 71e9;
  input.particle.poisson_ratio = 0.17;
  input.particle.topography = particle;
  input.substrate.youngs_modulus = 179e9;
  input.substrate.poisson_ratio = 0.25;
  input.substrate.topography = substrate;
  input.experiment.normal_load = 100e-6;
  input.mesh.interface_spacing = spacing;
  input.mesh.contact_region = region;
  return input;
}

/// size: of the periodic square, where a test needs one that is not the default.
inline std::string generated(double rms_nm, double cutoff_nm, int seed, const std::string& size = "") {
  return "generated(rms=" + std::to_string(rms_nm) +
         " nm, hurst=0.8, rolloff=200 nm, cutoff=" + std::to_string(cutoff_nm) + " nm, " +
         (size.empty() ? "" : "size=" + size + ", ") + "seed=" + std::to_string(seed) + ")";
}

}  // namespace asperity::test
