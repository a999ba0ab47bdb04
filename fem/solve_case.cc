#include "fem/solve_case.h"

#include <algorithm>

#include "core/error.h"
#include "core/motion_program.h"
#include "fem/case/case_setup.h"
#include "fem/experiments/contact_experiment.h"
#include "fem/materials/material_law.h"

namespace asperity {
namespace {

/// Why a law that knows rates cannot be told those of the motion; empty: it can.
std::string objection_to_speed(const ExperimentInput& e, const std::vector<ProgramPart>& parts,
                               const std::string& depends) {
  const bool has_speeds = std::all_of(parts.begin(), parts.end(), [](const auto& part) {
    const bool moves = part.rolls() || part.slide != 0 || part.slide_across != 0 || part.spin != 0;
    return !moves || part.speed > 0 || part.duration > 0;
  });
  if (e.speed > 0 || e.type == Motion::normal || (e.type == Motion::program && has_speeds)) return "";
  return depends + ", and the motion has no speed; set Experiment/Speed, e.g. 1 um/s";
}

/// Likewise of a body that relaxes.
std::string objection_to_times(const ExperimentInput& e, const std::vector<ProgramPart>& parts) {
  const std::string depends = "a body relaxes with time";
  if (!(e.load_time > 0))
    return depends + ", and the loading has no duration; set Experiment/Load time, e.g. 1 s";
  if (e.hold_steps > 0 && !(e.hold_time > 0))
    return depends + ", and the hold has no duration; set Experiment/Hold time, e.g. 10 s";
  return objection_to_speed(e, parts, depends);
}

/// Checks of a case that need no mesh.
void require_solvable(const CaseInput& input) {
  const auto& e = input.experiment;
  const auto refuse = [&](const std::string& why) { throw InputError(input.file + ": " + why); };
  const auto parts = e.type == Motion::program ? parse_motion_program(e.program) : std::vector<ProgramPart>{};
  const std::string objection = objection_to_program(e);
  if (!objection.empty()) refuse(objection);
  const bool rolls = e.type == Motion::rolling ||
                     std::any_of(parts.begin(), parts.end(), [](const auto& part) { return part.rolls(); });
  if (rolls && input.solver.backend != "matrix-free") refuse("rolling needs Solver/Backend = matrix-free");
  const auto& i = input.interface;
  bool rubs = false;
  try {
    const auto friction = fem::make_friction_law(i);
    rubs = friction != nullptr;
    const std::string timeless =
        friction && friction->resists_by_rate()
            ? objection_to_speed(e, parts, "the law of friction depends on the rate of slip")
            : std::string();
    if (!timeless.empty()) throw InputError(timeless);
    fem::make_adhesion_laws(i);
    if (fem::relaxes(input))
      if (const std::string no_times = objection_to_times(e, parts); !no_times.empty())
        throw InputError(no_times);
  } catch (const InputError& error) {
    refuse(error.what());
  }
  if (i.work_of_separation > 0 && i.work_of_separation < i.work_of_adhesion)
    refuse(
        "Interface/Work of adhesion on separation is below Work of adhesion, which would create energy in "
        "each cycle; raise it, or 0 for the same");
  if (i.attraction_force > 0 && e.control == ExperimentInput::Control::displacement)
    refuse(
        "Interface/Attraction force needs Control = force: it acts whatever the gap, so that nothing says "
        "where the surfaces open; give a law of adhesion to follow them apart");
  if (e.retract > 0 && e.control != ExperimentInput::Control::displacement)
    refuse("Experiment/Retract needs Control = displacement: under a given force the contact breaks at once");
  if (e.type == Motion::torsion && !rubs) {
    std::vector<std::string> entries;
    for (const auto& parameter : parameters_of(fem::friction_laws())) entries.push_back(parameter.entry);
    refuse("torsion without friction meets no resistance; set Interface/" + alternatives(entries));
  }
  if (e.type != Motion::normal && e.cycles > 1 && !e.reverse)
    refuse(
        "Experiment/Cycles above 1 need Reverse = true, so that each cycle starts where the first one did");
  if (e.return_distance > 0 &&
      (!e.reverse || e.cycles > 1 || (e.type != Motion::sliding && e.type != Motion::rolling)))
    refuse(
        "Experiment/Return distance is for one cycle of sliding or rolling with Reverse = true; set it to 0");
}

}  // namespace

void check_case(const CaseInput& input) {
  require_solvable(input);
  if (input.particle.topography.scan() || input.substrate.topography.scan())
    fem::set_up(fem::with_derived_path_length(input));
  else
    fem::check_extent(input);
}

void solve_case(const CaseInput& input, const SolveOptions& options) {
  require_solvable(input);
  fem::ContactExperiment(input, options).run();
}

}  // namespace asperity
