// One solve of ContactSolver: Newton steps for fixed multipliers within updates of these.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.h"
#include "fem/contact/contact_solver.h"
#include "fem/contact/line_search.h"

namespace asperity::fem {
namespace {

// Unbalanced force, relative, of the first solution and of those after an update of the multipliers.
constexpr double first_goal = 1e-3, fraction_of_change = 0.03;
// The same at the quick pace, where it is compared with what an update would change now.
constexpr double largest_goal = 0.1, fraction_of_present_change = 0.5;
// Bounds of the residual that conjugate gradients leave of a Newton direction: closer ones save hardly a
// Newton step.
constexpr double accurate_direction = 1e-2, rough_direction = 1e-1;

// Conjugate gradients need a few tens of iterations; many times that indicate an indefinite matrix.
constexpr int iterations_of_definite = 200, convex_steps = 3;

// Steps without progress before the line search locates the minimum accurately: full steps soon alternate
// between stick and slip, and between two places of the edge of attraction, where rounding decides how often.
constexpr int patience_without = 3, patience_with_attraction = 1, patience_with_friction = 0;

}  // namespace

struct ContactSolver::Iteration {
  Iteration(Pace at_pace, ContactState& start, double aim, TangentField* tangents, const MeshLevel& level,
            int patience)
      : pace(at_pace), state(start), target(aim), tangent(tangents), search(0, patience) {
    for (auto* v : {&residual, &direction}) level.initialise(*v);
  }

  Pace pace;
  ContactState& state;
  double target;          ///< load [N] or approach [m]
  TangentField* tangent;  ///< null: the bodies are elastic
  Vector<double> residual, direction;
  double error = 0;  ///< unbalanced force as evaluated last, relative
  LineSearch search;
  /// Changes by the last two updates, updates in a row that changed no less than the one before the last, and
  /// the share of a change that an update takes on.
  double last_change = std::numeric_limits<double>::infinity(), change_before = last_change;
  int stalls = 0;
  double share = 1;
  bool closed = false;  ///< whether another update of the multipliers would change less than the tolerances
  SolveReport report;
};

SolveReport ContactSolver::solve(ContactState& state, double target, const RigidMotion& motion,
                                 double time_step) {
  ContactState accepted = state;
  SolveReport report;
  if (!options_.cautious) {
    try {
      report = solve_at(Pace::quick, state, target, motion, time_step);
    } catch (const StepFailure&) {
    }
    if (!report.converged) state = accepted;
  }
  if (!report.converged) {
    const SolveReport quick = report;
    report = solve_at(Pace::cautious, state, target, motion, time_step);
    report.newton += quick.newton, report.linear += quick.linear;
    report.restarts = options_.cautious ? 0 : 1;
  }
  if (report.converged && !options_.cautious) prediction_.remember(accepted, state, target);
  return report;
}

SolveReport ContactSolver::solve_at(Pace pace, ContactState& state, double target, const RigidMotion& motion,
                                    double time_step) {
  Iteration at(pace, state, target, system_.bodies().are_inelastic() ? &tangent_ : nullptr, system_.level(),
               tractions_.has_friction()   ? patience_with_friction
               : tractions_.has_adhesion() ? patience_with_attraction
                                           : patience_without);
  begin_step(at, motion, time_step);
  SolveReport& report = at.report;
  for (report.updates = 0; report.updates <= options_.largest_updates; ++report.updates) {
    balance(at);
    measure_change(at);
    if (at.closed && at.error <= std::max(options_.residual_tolerance, rounding_)) {
      report.converged = true;
      break;
    }
    if (report.newton >= options_.largest_newton) break;
    if (!at.closed) update_multipliers(at);
  }
  finish(at);
  return report;
}

void ContactSolver::begin_step(Iteration& at, const RigidMotion& motion, double time_step) {
  ContactState& state = at.state;
  // The surfaces have moved with their frames and in them: by the mean over the pressure, and what differs
  // from it is small. A failed step or a restart may have left the interfaces coupled elsewhere.
  if (!(system_.coupling() == state.coupling)) system_.couple_at(state.coupling, state.displacement);
  const std::vector<double> gaps_before = gaps(state);
  constexpr double growth = 1.001;  // steps at the same load meet it within their tolerance
  const bool load_grows = force_control() ? at.target > growth * tractions_.carried_load(state, gaps_before)
                                          : at.target > state.approach;
  const double share = at.pace == Pace::quick ? prediction_.share_of_last_step(state, motion, at.target) : 0;
  system_.couple_at({motion, mean_displacement(state)}, state.displacement);
  state.coupling = system_.coupling();
  system_.bodies().begin_step({state.time + time_step, time_step}, state.displacement);
  tractions_.begin_step(state, motion, gaps_before, gaps(state), load_grows, time_step);
  state.motion = motion;
  if (share > 0) predict(at, share);
  if (!force_control() && share == 0) {
    advance_to(state, at.target, at.report);
  } else {
    if (!force_control()) state.approach = at.target;
    complete(state.displacement, state.approach);
  }
  // First guess of the stick-slip state: nodes that slipped keep slipping if the motion continues in their
  // direction; at the start and after a reversal all nodes stick.
  if (tractions_.has_friction()) {
    tractions_.hold_unless_slipping_on(state);
    step_with_held_rows(at);
  }
  at.error = evaluate(state, at.target, at.residual, at.tangent);
  slip_stiffness_ = SlipStiffness::tangent;
  at.search.restart(at.error);
}

void ContactSolver::predict(Iteration& at, double share) {
  prediction_.move_on(at.state, share);
  if (tractions_.has_friction()) tractions_.update_limits(at.state);
}

double ContactSolver::goal(const Iteration& at) const {
  // The residual after a multiplier update is about as large as the change of the multipliers: each update
  // is followed by a solution more accurate than that, the last one by a solution to the full tolerance.
  double wanted = 0;
  if (!at.closed && at.pace == Pace::quick)
    wanted = std::min(largest_goal, fraction_of_present_change * force_of(tractions_.change(at.state)));
  else if (!at.closed)
    wanted = at.report.updates == 0 ? first_goal
                                    : std::min(first_goal, fraction_of_change * at.report.penetration);
  // Rounding is that of the last evaluation.
  return std::max({options_.residual_tolerance, rounding_, wanted});
}

void ContactSolver::balance(Iteration& at) {
  for (;;) {
    const double wanted = goal(at);
    if (at.error <= wanted || at.report.newton >= options_.largest_newton) return;
    newton_step(at, wanted);
  }
}

void ContactSolver::newton_step(Iteration& at, double goal) {
  // Without active contact nodes a spring with the stiffness of one contact regularises the system: the
  // direction is still one of descent.
  const bool open = !tractions_.any_closed();
  const double spring = open && force_control()
                            ? system_.reduced_modulus() * system_.options().mesh.sizes.spacing_particle
                            : 0.0;
  const double accuracy = std::clamp(0.1 * goal / at.error, accurate_direction, rough_direction);
  at.report.linear += newton_direction(at.tangent, spring, accuracy, at.residual, at.direction);
  ++at.report.newton;

  // The slope along the direction changes sign where the convex energy is lowest.
  const double slope = at.residual * at.direction;
  const Vector<double> start = at.state.displacement;
  at.direction.zero_out_ghost_values();
  const auto slope_at = [&](double step) {
    at.state.displacement = start;
    at.state.displacement.zero_out_ghost_values();
    at.state.displacement.add(step, at.direction);
    at.state.displacement.update_ghost_values();
    at.error = evaluate(at.state, at.target, at.residual, at.tangent);
    return at.residual * at.direction;
  };
  const double error_before = at.error;
  const double step = at.search.step(slope, slope_at);
  at.search.reached(at.error);
  choose_slip_stiffness(step, error_before, at.error);
  if (log)
    log("  newton " + std::to_string(at.report.newton) + " step " + std::to_string(step) + " residual " +
        std::to_string(at.error) + " cg " + std::to_string(at.report.linear) + " active " +
        std::to_string(tractions_.closed()) + " sticking " + std::to_string(tractions_.sticking()));
}

void ContactSolver::choose_slip_stiffness(double step, double error_before, double error) {
  constexpr double little_progress = 0.5;
  const bool is_slow = error > little_progress * error_before;
  const bool is_secant = slip_stiffness_ == SlipStiffness::secant;
  const bool stays = !is_slow && (is_secant || step >= 1);
  if (!stays) slip_stiffness_ = is_secant ? SlipStiffness::tangent : SlipStiffness::secant;
}

void ContactSolver::measure_change(Iteration& at) {
  const auto change = tractions_.change(at.state);
  at.report.penetration = force_of(change);
  at.report.residual = at.error;
  if (log)
    log(" update " + std::to_string(at.report.updates) + " change " + std::to_string(change.pressure) + " " +
        std::to_string(change.shear));
  at.closed = change.pressure <= options_.penetration_tolerance && change.shear <= options_.slip_tolerance;
}

double ContactSolver::force_of(const InterfaceTractions::Change& change) const {
  // The unbalanced force is measured by the pressures' total, and so is the change that sets the next goal.
  return change.pressure + change.shear * tractions_.shear_share();
}

void ContactSolver::update_multipliers(Iteration& at) {
  // Large friction on slopes couples pressure and shear: a row may then stick after one update and slip after
  // the next, for ever. Half of the change meets in between.
  constexpr double progress = 0.9, half = 0.5;
  constexpr int patience = 3;
  const double change = at.report.penetration;
  at.stalls = change < progress * at.change_before ? 0 : at.stalls + 1;
  at.change_before = std::exchange(at.last_change, change);
  if (at.stalls >= patience) at.share = half;
  // The update doubles the traction that the penalty carried, so that sticking rows would slip in the next
  // evaluation.
  if (tractions_.has_friction()) tractions_.hold_sticking();
  system_.follow_slopes(at.state.displacement);
  tractions_.update_multipliers(at.state, at.share);
  tractions_.update_limits(at.state);
  // The first steps' stick and slip that called for the secant have been found by now.
  if (at.pace == Pace::quick) slip_stiffness_ = SlipStiffness::tangent;
  if (tractions_.has_friction()) step_with_held_rows(at);
  at.error = evaluate(at.state, at.target, at.residual, at.tangent);
  at.search.restart(at.error);
}

void ContactSolver::finish(Iteration& at) {
  ContactState& state = at.state;
  tractions_.update_multipliers(state);
  at.report.friction_work = tractions_.friction_work(state);
  if (tractions_.has_adhesion()) {
    const std::vector<double> here = gaps(state);
    at.report.adhesion_loss = tractions_.update_bonds(state, here);
    at.report.adhesion_energy = tractions_.adhesion_energy(state, here);
  }
  tractions_.update_history(state);
  if (force_control()) read_approach(state);
}

int ContactSolver::newton_direction(const TangentField* tangent, double spring, double accuracy,
                                    const Vector<double>& residual, Vector<double>& direction) {
  int iterations = 0;
  if (tractions_.has_adhesion() && convex_steps_left_-- <= 0) {
    // Attraction that falls with the gap softens. Where that makes the matrix indefinite, as in a jump,
    // conjugate gradients end with a direction of descent. Algebraic multigrid of such a matrix may fail: the
    // softening is then left out for some steps.
    convex_steps_left_ = 0;
    try {
      system_.linear().update(tractions_.stiffness(false, slip_stiffness_), tangent, spring);
      iterations = system_.linear().solve(direction, residual, accuracy);
      if (residual * direction > 0 && iterations < iterations_of_definite) return iterations;
    } catch (const WorkError&) {
    }
    convex_steps_left_ = convex_steps;
  }
  system_.linear().update(tractions_.stiffness(true, slip_stiffness_), tangent, spring);
  return iterations + system_.linear().solve(direction, residual, accuracy);
}

void ContactSolver::step_with_held_rows(Iteration& at) {
  evaluate(at.state, at.target, at.residual, at.tangent);
  if (tractions_.any_closed()) {
    at.report.linear += newton_direction(at.tangent, 0.0, rough_direction, at.residual, at.direction);
    at.state.displacement.zero_out_ghost_values();
    at.direction.zero_out_ghost_values();
    at.state.displacement += at.direction;
    at.state.displacement.update_ghost_values();
  }
  tractions_.release();
}

SurfaceDisplacement ContactSolver::mean_displacement(const ContactState& state) const {
  if (!system_.options().tilted_normals) return {};
  std::vector<double> weight(state.multiplier.size());
  for (std::size_t r = 0; r < weight.size(); ++r) weight[r] = system_.areas()[r] * state.multiplier[r];
  const double* displacement = state.displacement.begin();
  return mean_surface_displacement(
      system_.row_points(), weight,
      {system_.interface().jumps(displacement, 0), system_.interface().jumps(displacement, 1)});
}

}  // namespace asperity::fem
