// Solved cases sorted into parameter sets: cases of one set are of the same contact (contact_key.h: both
// bodies, roughness but for the seeds of generated surfaces, all laws at a point of the interface); they may
// differ by load, experiment, realisation and mesh. The order in which folders are named changes nothing.
// Frictionless cases of experiment normal count for every set of the same bodies: friction hardly changes a
// normal load.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/contact_key.h"

namespace asperity {

/// Cases that one record of parameters is derived from.
struct ParameterSet {
  ContactInputs inputs;           ///< what all cases agree in
  std::vector<SolvedCase> cases;  ///< by folder
};

struct ParameterSets {
  std::vector<ParameterSet> sets;  ///< by their first folder
  std::vector<std::string>
      remarks;  ///< sentences on cases that are left out, in doubt, or count for several sets
};

/// Folders are cases, studies, or hold such. Throws InputError for a folder with neither, for one that is
/// itself a case whose energy balance is refused (within others it is left out and named), and where no case
/// is complete.
ParameterSets collect_parameter_sets(const std::vector<std::filesystem::path>& folders);

/// "Particle/Radius: 5 um, 8.5 um; ..." of the inputs that are not the same in all sets; empty for a single
/// set.
std::string differences(const std::vector<ParameterSet>& sets);

}  // namespace asperity
