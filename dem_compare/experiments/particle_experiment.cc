#include "dem_compare/experiments/particle_experiment.h"

#include <algorithm>

#include "core/error.h"
#include "core/nearest_name.h"

namespace asperity {
namespace experiment_kinds {
std::vector<ParticleExperiment> make_all();  // generated from the files of kinds/
}
namespace {

using Maker = ParticleExperiment (*)();

std::vector<Maker>& experiments_from_elsewhere() {
  static std::vector<Maker>
      makers;  // in a function: filled while other files' constants are still being set up
  return makers;
}

}  // namespace

RegisteredExperiment::RegisteredExperiment(Maker make) { experiments_from_elsewhere().push_back(make); }

const std::vector<ParticleExperiment>& particle_experiments() {
  static const std::vector<ParticleExperiment> list = [] {
    auto all = experiment_kinds::make_all();
    for (const Maker make : experiments_from_elsewhere()) all.push_back(make());
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    return all;
  }();
  return list;
}

SingleParticle make_particle(const std::string& experiment, const ExperimentSetup& setup) {
  std::vector<std::string> names;
  std::string list;
  for (const auto& known : particle_experiments()) {
    if (known.name == experiment) return known.make(setup);
    names.push_back(known.name);
    list += (list.empty() ? "" : ", ") + known.name;
  }
  const std::string meant = nearest_name(experiment, names);
  throw InputError("there is no experiment '" + experiment + "'; " +
                   (meant.empty() ? "there are " + list : "did you mean '" + meant + "'?"));
}

}  // namespace asperity
