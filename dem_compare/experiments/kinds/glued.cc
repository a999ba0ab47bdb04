// Glued to the indenter: the sphere slides on the substrate and cannot turn (Fuchs, Weinhart et al. 2014,
// fig. forces0 a).
#include "dem_compare/experiments/particle_experiment.h"

namespace asperity {
namespace {

using Eigen::Vector3d;

SingleParticle glued_sphere(const ExperimentSetup& setup) {
  return {
      setup.substrate.normal->radius(), true, {{"substrate", setup.substrate, Vector3d::UnitZ(), false, 1}}};
}

}  // namespace

namespace experiment_kinds {
ParticleExperiment make_glued() { return {"glued", "sliding loop", glued_sphere}; }
}  // namespace experiment_kinds

}  // namespace asperity
