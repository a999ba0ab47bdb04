// A case that slides, rolls or spins as it was recorded.
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/printed.h"
#include "core/quantity.h"
#include "dem_compare/laws/hertzian_torsion.h"
#include "diagnosis/mapping/changes_in_words.h"
#include "diagnosis/mapping/motion_protocols.h"
#include "diagnosis/mapping/solved_case_mapping.h"

namespace asperity {
namespace {

/// A case has one particle, and one surface unless its RMS roughness can follow the recording.
void refuse_several_surfaces(const Recording& recording, double substrate_rms) {
  std::vector<const char*> fixed{"radius", "humidity"};
  if (!(substrate_rms > 0)) fixed.push_back("rms_roughness");
  for (const char* channel : fixed) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const auto& table : recording.tables) {
      if (!table.has(channel)) continue;
      for (const double value : table.column(channel)) {
        if (!std::isfinite(value)) continue;
        least = std::min(least, value), most = std::max(most, value);
      }
    }
    constexpr double rounding = 1e-3;
    if (most - least > rounding * std::abs(most))
      throw InputError(std::string("the recording varies ") + channel +
                       ", and a case has one; diagnose each part with a case of its own, " +
                       (channel == std::string("rms_roughness")
                            ? "give it Substrate/Topography = generated(...), which follows, "
                            : "") +
                       "or leave out --case");
  }
}

/// The local friction that the case states, which is not fitted before physics is added.
void take_friction(Recording& recording, double of_case, std::vector<std::string>& remarks) {
  SimulationChoice& simulation = recording.simulation;
  if (!(of_case > 0))
    throw InputError("--case needs a law of friction with a coefficient for a recording of " +
                     name_of(recording.mode) + "; give the case Interface/Friction coefficient");
  if (recording.mode == Motion::torsion) {
    simulation.parameters["torsion_friction"] = {full_slip_torsion_coefficient(of_case), false};
    remarks.push_back(printed("the case resists torsion as its local friction, %.4g, is solved", of_case));
    return;
  }
  const auto given = simulation.parameters.find("sliding_friction");
  constexpr double rounding = 1e-3;
  if (given != simulation.parameters.end() &&
      (given->second.calibrate || std::abs(given->second.value - of_case) > rounding * of_case))
    remarks.push_back(
        printed("local friction is the case's, %.4g, and not what the recording says of sliding_friction; "
                "where it is another, friction_coefficient is named",
                of_case));
  simulation.parameters["sliding_friction"] = {of_case, false};
}

/// No law of rolling is an input of a case: it rolls as its bodies and their interface let it.
void leave_rolling_to_case(Recording& recording, std::vector<std::string>& remarks) {
  SimulationChoice& simulation = recording.simulation;
  constexpr const char* name = "rolling_friction";
  constexpr double until_solved = 1e-3;
  const auto given = simulation.parameters.find(name);
  if (given != simulation.parameters.end() && !given->second.calibrate)
    remarks.push_back(
        printed("the case rolls as it is solved, and not by rolling_friction = %.4g", given->second.value));
  simulation.parameters[name] = {until_solved, false};
  const std::optional<RecordedBody>& plate = recording.indenter;
  const bool is_other = plate && (plate->youngs_modulus != recording.substrate.youngs_modulus ||
                                  plate->poissons_ratio != recording.substrate.poissons_ratio);
  remarks.push_back(
      "the case is one contact that rolls; of a sphere under a plate, the lateral force is the mean of two "
      "contacts, and the case stands for both" +
      std::string(is_other ? ", though the plate is another body than the substrate: half of the resistance "
                             "is that of a contact which was not solved"
                           : ""));
}

}  // namespace

void SolvedCaseMapping::prepare_lateral(Recording& recording, const SimulatedBodies& bodies) {
  refuse_several_surfaces(recording, bodies.substrate_rms);
  resistance_ = recording.mode == Motion::sliding ? "friction" : name_of(recording.mode) + " resistance";
  if (recording.mode == Motion::rolling)
    leave_rolling_to_case(recording, remarks_);
  else
    take_friction(recording, bodies.friction_coefficient, remarks_);
}

void SolvedCaseMapping::correct_lateral(FitProblem& problem) {
  motions_ = at_solved_loads(motion_protocols_of(problem, problem.experiment.case_is_smooth),
                             model_.solved_motions(problem.experiment.mode));
  if (motions_.front().substrate_rms)
    remarks_.push_back(
        "the recording is of several surfaces: the case is solved with its substrate scaled to the RMS "
        "roughness of each, spectrum and seed as they are");
  const auto moved = move(problem.experiment, nullptr);
  for (const SolvedMotion& motion : moved) of_mesh_.push_back(motion.of_mesh);
  before_ = moved.front().source;
  error_ = resistance_error(moved);
  const auto law = [&] { return Explanation(problem.experiment, problem.choice, {}).mechanics({}); };
  if (problem.experiment.mode == Motion::rolling)
    problem.choice.parameters["rolling_friction"] = {rolling_coefficient(moved, law()), false};
  problem.correction = resistance_difference_to(moved, law());
}

/// Of a case that has come to resist by more, what its mesh made of it before is half taken out, give or take
/// that half.
void SolvedCaseMapping::take_mesh_out(std::vector<SolvedMotion>& moved) const {
  for (std::size_t i = 0; i < moved.size() && i < of_mesh_.size(); ++i) {
    SolvedMotion& motion = moved[i];
    const double half = of_mesh_[i] / 2;
    if (motion.of_mesh > 0 || motion.resistance <= half) continue;
    motion.resistance -= half;
    motion.resistance_error = std::hypot(motion.resistance_error, half);
  }
}

std::vector<SolvedMotion> SolvedCaseMapping::move(const Experiment& experiment, const ModelFit* fit) {
  std::vector<SolvedMotion> all;
  for (std::size_t from = 0, to = 0; from < motions_.size(); from = to) {
    const std::optional<double> rms = motions_[from].substrate_rms;
    Experiment of_surface = experiment;
    if (rms) of_surface.case_rms = *rms;
    std::string loads;
    std::vector<MotionProtocol> protocols;
    for (; to < motions_.size() && motions_[to].substrate_rms == rms; ++to) {
      protocols.push_back(motions_[to]);
      loads += (loads.empty() ? "" : ", ") + format_quantity(motions_[to].normal_force, Dimension::force);
    }
    const auto changes = fit ? changes_of(of_surface, *fit) : std::vector<CaseChange>();
    say(name_of(experiment.mode) + " the case, " + in_words(changes) +
        (rms ? ", on " + format_quantity(*rms, Dimension::length) + " RMS" : "") + ", under " + loads);
    const auto moved = model_.move(changes, protocols, !fit);
    all.insert(all.end(), moved.begin(), moved.end());
  }
  solves_ += static_cast<int>(all.size());
  if (fit) take_mesh_out(all);
  return all;
}

}  // namespace asperity
