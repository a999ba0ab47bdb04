// Solved cases sorted into parameter sets: cases of one set share the bodies (materials, radius, roughness
// but for the seeds of generated surfaces) and the laws at a point of the interface; they may differ by load,
// experiment, realisation and mesh. Frictionless cases of experiment normal count for every set of the same
// bodies: friction hardly changes a normal load.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "dem_compare/solved_case.h"

namespace asperity {

struct ParameterSet {
  /// What all cases agree in: entry of the case file and its value.
  std::vector<std::pair<std::string, std::string>> inputs;
  std::vector<SolvedCase> cases;
};

struct ParameterSets {
  std::vector<ParameterSet> sets;
  std::vector<std::string> remarks;  ///< sentences on cases that are left out, or count for several sets
};

/// Folders are cases, studies, or hold such. Throws InputError for a folder with neither, and where no case
/// is complete.
ParameterSets collect_parameter_sets(const std::vector<std::filesystem::path>& folders);

/// "Particle/Radius: 5 um, 8.5 um; ..." of the inputs that are not the same in all sets; empty for a single
/// set.
std::string differences(const std::vector<ParameterSet>& sets);

/// What `solve` did: normal, sliding, rolling or torsion.
std::string experiment_of(const SolvedCase& solved);
/// The same for the same surfaces, seeds included.
std::string realisation_of(const SolvedCase& solved);

}  // namespace asperity
