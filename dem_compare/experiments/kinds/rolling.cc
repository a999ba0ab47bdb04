// Free between substrate and indenter: the sphere rolls, at half the indenter's speed (Fuchs, Weinhart et al.
// 2014, fig. forces0 b).
#include "dem_compare/experiments/particle_experiment.h"

namespace asperity {
namespace {

using Eigen::Vector3d;

SingleParticle rolling_sphere(const ExperimentSetup& setup) {
  return {setup.substrate.normal->radius(),
          false,
          {{"substrate", setup.substrate, Vector3d::UnitZ(), false, 1},
           {"indenter", setup.indenter, -Vector3d::UnitZ(), true, 1}}};
}

}  // namespace

namespace experiment_kinds {
ParticleExperiment make_rolling() { return {"rolling", "under a plate", rolling_sphere}; }
}  // namespace experiment_kinds

}  // namespace asperity
