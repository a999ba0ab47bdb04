// Experiments of the finite-element solver that files of their own add: a program of motions
// (core/motion_program.h) made from entries of the case. A file NAME.cc of experiments/ defines
//   namespace asperity::experiments { ExperimentDeclaration make_NAME(); }
// and nothing else names it; from elsewhere a RegisteredExperimentDeclaration. A case asks for it by
// Experiment/Type, and is meshed, moved and reported as the program says.
#pragma once

#include <string>
#include <vector>

#include "core/case.h"
#include "core/law_declaration.h"

namespace asperity {

/// Its name is the word of Experiment/Type, its equation the program with the symbols of its parameters,
/// which are entries of the section Experiment.
struct ExperimentDeclaration : LawDeclaration {
  /// The program as people write it; values: of all of its parameters.
  std::string (*program)(const ExperimentInput& experiment, const LawValues& values);
};

/// All of them, by name. Throws std::logic_error if one has the name of a motion, or two the same.
const std::vector<ExperimentDeclaration>& declared_experiments();
bool is_declared_experiment(const std::string& name);

/// Writes the program of a declared experiment, if it is one. Throws InputError where it lacks an entry, has
/// one of another experiment, or a program already.
void write_declared_program(ExperimentInput& experiment);

/// Registers an experiment from elsewhere, as a constant outside of all functions.
using RegisteredExperimentDeclaration = Registered<ExperimentDeclaration (*)()>;

}  // namespace asperity
