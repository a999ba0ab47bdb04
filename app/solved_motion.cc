#include "app/solved_motion.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.h"

namespace asperity {

namespace fs = std::filesystem;

void refuse_outgrown(const fs::path& folder) {
  throw WorkError("'" + folder.string() + "': " + at_the_rim +
                  "; give the case a larger Mesh/Contact region");
}

std::size_t steps_within_region(const History& history) {
  const auto& rim = history.reaches_rim;
  return static_cast<std::size_t>(
      std::find_if(rim.begin(), rim.end(), [](double reached) { return reached > 0; }) - rim.begin());
}

namespace {

/// Lateral force with its standard deviation, and how much of it the mesh may have made [N].
struct Resistance {
  double value = 0, sd = 0, of_mesh = 0;
};

Resistance sliding_resistance(const SolvedCase& solved, double normal_force) {
  const EffectiveNumber friction = solved.effective("sliding_friction");
  return {friction.value * normal_force, friction.sd * normal_force};
}

/// Of the energy that rolling loses per angle. Below what the mesh makes of smooth elastic bodies all of it,
/// or nothing, may be the mesh's.
Resistance rolling_resistance(const SolvedCase& solved) {
  const EffectiveNumber lost = solved.effective("rolling_dissipation"),
                        floor = solved.effective("rolling_noise_floor");
  const double radius = solved.hertz().radius;
  Resistance resistance{lost.value / radius, lost.sd / radius};
  if (!std::isfinite(lost.value) || lost.value > floor.value) return resistance;
  constexpr double least_part = 1e-3;  // of the floor: a law that is corrected by a factor needs one
  resistance.of_mesh = std::max(0.0, lost.value) / radius;
  resistance.value = std::max(lost.value / 2, least_part * floor.value) / radius;
  resistance.sd = std::max({resistance.sd, resistance.value, std::abs(lost.value) / (2 * radius)});
  return resistance;
}

Resistance torsion_resistance(const SolvedCase& solved) {
  const EffectiveNumber moment = solved.effective("torsion_moment");
  const double radius = solved.hertz().radius;
  return {moment.value / radius, moment.sd / radius};
}

Resistance resistance_of(const SolvedCase& solved, const MotionProtocol& protocol) {
  if (protocol.motion == Motion::rolling) return rolling_resistance(solved);
  if (protocol.motion == Motion::torsion) return torsion_resistance(solved);
  return sliding_resistance(solved, protocol.normal_force);
}

}  // namespace

SolvedMotion motion_of(const fs::path& folder, const MotionProtocol& protocol) {
  const SolvedCase solved = read_solved_case(folder);
  if (steps_within_region(solved.history) < solved.history.size()) refuse_outgrown(folder);
  const EffectiveNumber stiffness = solved.effective("lateral_stiffness");
  SolvedMotion motion;
  motion.normal_force = protocol.normal_force;
  motion.substrate_rms = protocol.substrate_rms;
  const Resistance resistance = resistance_of(solved, protocol);
  motion.resistance = resistance.value;
  motion.resistance_error = resistance.sd;
  motion.of_mesh = resistance.of_mesh;
  motion.lateral_stiffness = std::isfinite(stiffness.value) ? stiffness.value : 0;
  motion.lateral_stiffness_error = std::isfinite(stiffness.sd) ? stiffness.sd : 0;
  motion.source = folder.string();
  return motion;
}

SolvedResponse response_of(const fs::path& folder, const std::string& ended_early) {
  const SolvedCase solved = read_solved_case(folder);
  SolvedResponse response;
  const std::size_t steps = steps_within_region(solved.history);
  const bool is_at_rim = steps < solved.history.size();
  if (is_at_rim && steps < least_steps_of_curve) refuse_outgrown(folder);
  const auto within = [&](const std::vector<double>& column) {
    return std::vector<double>(column.begin(), column.begin() + static_cast<std::ptrdiff_t>(steps));
  };
  response.displacement = within(solved.history.normal_displacement);
  response.force = within(solved.history.normal_force);
  const auto peak = std::max_element(response.force.begin(), response.force.end());
  response.peak = static_cast<std::size_t>(peak - response.force.begin());
  response.displacement_error = solved.effective("approach_from_first_touch").sd;
  if (ended_early.empty() && !std::isfinite(response.displacement_error))
    throw WorkError(
        "'" + folder.string() +
        "' does not state the error of its approach, without which a mismatch cannot be told from "
        "the mesh's; solve it with this version");
  if (const double sd = solved.effective("pull_off_force").sd; std::isfinite(sd))
    response.pull_off_error = sd;
  response.source = folder.string();
  response.ended_early = is_at_rim && ended_early.empty() ? at_the_rim : ended_early;
  return response;
}

bool tells_loading_up_to(const fs::path& folder, double force) {
  constexpr int least_steps = 6;
  try {
    const SolvedResponse response = response_of(folder, "");
    const auto end = response.force.begin() + static_cast<std::ptrdiff_t>(response.peak) + 1;
    return response.ended_early.empty() && std::count_if(response.force.begin(), end, [&](double f) {
                                             return f > 0 && f < force;
                                           }) >= least_steps;
  } catch (const WorkError&) {  // it outgrew its mesh, or does not state its error
    return false;
  }
}

}  // namespace asperity
