#include "dem_compare/experiments/particle_experiment.h"

namespace asperity {
namespace experiment_kinds {
std::vector<ParticleExperiment> make_all();  // generated from the files of kinds/
}
namespace {
std::string name_of(const ParticleExperiment& experiment) { return experiment.name; }
}  // namespace

const std::vector<ParticleExperiment>& particle_experiments() {
  static const auto list = with_registered_makers(experiment_kinds::make_all(), name_of);
  return list;
}

SingleParticle make_particle(const std::string& experiment, const ExperimentSetup& setup) {
  return entry_named(particle_experiments(), experiment, name_of, "there is no experiment").make(setup);
}

}  // namespace asperity
