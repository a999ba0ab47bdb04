// An experiment with one particle of somebody's own, all of it: the sphere is glued to the indenter and
// slides along a V-rail.
#include <cmath>

#include "dem_compare/experiments/particle_experiment.h"

namespace asperity {
namespace {

SingleParticle glued_in_rail(const ExperimentSetup& setup) {
  const double s = std::sin(setup.rail_angle), c = std::cos(setup.rail_angle), share = 1 / (2 * c);
  return {setup.substrate.normal->radius(),
          true,
          {{"left_flank", setup.substrate, Eigen::Vector3d(0, s, c), false, share},
           {"right_flank", setup.substrate, Eigen::Vector3d(0, -s, c), false, share}}};
}

const RegisteredExperiment entry{[] {
  return ParticleExperiment{"glued_rail", "sliding along a V-rail", glued_in_rail};
}};

}  // namespace
}  // namespace asperity
