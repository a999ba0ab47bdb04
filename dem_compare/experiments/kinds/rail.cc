// Free in a V-rail under the indenter: two flanks and the indenter, rolling and torsion together (Fuchs,
// Weinhart et al. 2014, fig. forces0 c).
#include <cmath>

#include "core/error.h"
#include "dem_compare/experiments/particle_experiment.h"

namespace asperity {
namespace {

using Eigen::Vector3d;

SingleParticle sphere_in_rail(const ExperimentSetup& setup) {
  const double inclination = setup.rail_angle;
  if (!(inclination > 0 && inclination < M_PI_2))
    throw InputError("a rail's inclination lies between 0 and 90 degrees; give one such as 45 deg");
  const double s = std::sin(inclination), c = std::cos(inclination), share = 1 / (2 * c);
  return {setup.substrate.normal->radius(),
          false,
          {{"left_flank", setup.substrate, Vector3d(0, s, c), false, share},
           {"right_flank", setup.substrate, Vector3d(0, -s, c), false, share},
           {"indenter", setup.indenter, -Vector3d::UnitZ(), true, 1}}};
}

}  // namespace

namespace experiment_kinds {
ParticleExperiment make_rail() { return {"rail", "V-rail under a plate", sphere_in_rail}; }
}  // namespace experiment_kinds

}  // namespace asperity
