#include "fem/solve_case.h"

#include "core/error.h"
#include "fem/experiments/contact_experiment.h"

namespace asperity {
namespace {

/// What can be said of a case before it is meshed.
void require_solvable(const CaseInput& input) {
  const auto& e = input.experiment;
  using Type = ExperimentInput::Type;
  const auto refuse = [&](const std::string& why) { throw InputError(input.file + ": " + why); };
  if (e.type == Type::rolling) refuse("Experiment/Type: rolling cannot be solved by finite elements yet; use normal, sliding or torsion");
  if (input.interface.work_of_adhesion != 0) refuse("Interface/Work of adhesion: adhesion cannot be solved by finite elements yet; set it to 0");
  if (e.type == Type::sliding && e.distance == 0) refuse("Experiment/Distance is 0: give the way to slide, e.g. Distance = 1 um");
  if (e.type == Type::torsion && e.angle == 0) refuse("Experiment/Angle is 0: give the angle to spin, e.g. Angle = 0.02 rad");
  if (e.type != Type::normal && input.interface.friction_coefficient == 0 && input.interface.shear_strength == 0 && e.type == Type::torsion)
    refuse("torsion without friction meets no resistance; set Interface/Friction coefficient or Shear strength");
  if (e.type != Type::normal && e.cycles > 1 && !e.reverse)
    refuse("Experiment/Cycles above 1 need Reverse = true, so that each cycle starts where the first one did");
}

}  // namespace

void solve_case(const CaseInput& input, const SolveOptions& options) {
  require_solvable(input);
  fem::ContactExperiment(input, options).run();
}

}  // namespace asperity
