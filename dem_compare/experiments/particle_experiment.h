// The experiments with one particle that asperity knows. Each is a file NAME.cc of kinds/ that defines
//   namespace asperity::experiment_kinds { ParticleExperiment make_NAME(); }
// The build finds the files; nothing else names them.
#pragma once

#include <string>
#include <vector>

#include "core/registry.h"
#include "dem_compare/experiments/single_particle.h"

namespace asperity {

/// What an experiment is made from.
struct ExperimentSetup {
  ContactModel substrate, indenter;
  double rail_angle = 0;  ///< inclination of the flanks against the horizontal [rad]
};

struct ParticleExperiment {
  std::string name;     ///< "glued"
  std::string meaning;  ///< in a few words
  SingleParticle (*make)(const ExperimentSetup&) = nullptr;
};

/// All experiments, by name.
const std::vector<ParticleExperiment>& particle_experiments();
/// The particle and its contacts; throws InputError for an unknown name, naming what was meant, and for what
/// the setup cannot be.
SingleParticle make_particle(const std::string& experiment, const ExperimentSetup& setup);

/// Registers an experiment from elsewhere, as a constant outside of all functions.
using RegisteredExperiment = Registered<ParticleExperiment (*)()>;

}  // namespace asperity
