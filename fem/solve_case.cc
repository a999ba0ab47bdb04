#include "fem/solve_case.h"

#include "core/error.h"
#include "fem/experiments/normal_experiment.h"

namespace asperity {

void solve_case(const CaseInput& input, const SolveOptions& options) {
  if (input.experiment.type != ExperimentInput::Type::normal)
    throw InputError(input.file + ": Experiment/Type: only 'normal' can be solved by finite elements so far");
  if (input.interface.friction_coefficient != 0 || input.interface.shear_strength != 0 || input.interface.work_of_adhesion != 0)
    throw InputError(input.file + ": Interface: friction and adhesion are not part of the normal experiment yet; set them to 0");
  fem::NormalExperiment(input, options).run();
}

}  // namespace asperity
