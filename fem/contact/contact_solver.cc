#include "fem/contact/contact_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "fem/contact/line_search.h"

namespace asperity::fem {
namespace {

// Unbalanced force, relative, of the first solution and of those after an update of the multipliers.
constexpr double first_goal = 1e-3, fraction_of_change = 0.03;
// Bounds of the residual that conjugate gradients leave of a Newton direction: closer ones save hardly a
// Newton step.
constexpr double accurate_direction = 1e-2, rough_direction = 1e-1;

constexpr int more_newton_steps_for_jumps = 10;
// Conjugate gradients need a few tens of iterations; many times that indicate an indefinite matrix.
constexpr int iterations_of_definite = 200, convex_steps = 3;

// Steps without progress before the line search locates the minimum accurately: full steps soon alternate
// between stick and slip.
constexpr int patience_without = 3, patience_with_friction = 0;

bool parallel(const ContactSystem& system) {
  return dealii::Utilities::MPI::n_mpi_processes(system.level().communicator()) > 1;
}

}  // namespace

ContactSolver::ContactSolver(ContactSystem& system, const ContactSolverOptions& options)
    : system_(system),
      options_(options),
      penalty_(options_.penalty_factor * system.reduced_modulus() /
               system.options().mesh.sizes.spacing_particle),
      tractions_(system, options_.friction.get(), options_.adhesion, penalty_),
      elastic_diagonal_(
          HexOperator<double>(system.level(), system.positions(), system.options().materials).diagonal()) {
  const auto& gaps = system.initial_gaps();
  touch_offset_ = *std::min_element(gaps.begin(), gaps.end());
  // Snap-in and pull-off release much energy and take many iterations.
  if (tractions_.has_adhesion()) options_.largest_newton *= more_newton_steps_for_jumps;
}

ContactState ContactSolver::first_touch() const {
  ContactState state;
  system_.level().initialise(state.displacement);
  state.displacement.update_ghost_values();
  state.multiplier.assign(system_.rows().size(), 0.0);
  for (auto& component : state.shear) component.assign(system_.rows().size(), 0.0);
  state.friction_history.assign(system_.rows().size() * tractions_.history_size(), 0.0);
  if (tractions_.has_adhesion()) state.bonded.assign(system_.rows().size(), 0);
  state.coupling = system_.coupling();
  return state;
}

void ContactSolver::push_rigidly(ContactState& state, double approach) const {
  const auto& level = system_.level();
  const auto up = rotation(system_.coupling().frames)[2];  // in the particle's frame
  std::vector<char> seen(state.displacement.locally_owned_size() / 3, 0);
  for (const auto& batch : level.batches())
    for (int l = 0; l < batch.count; ++l) {
      if (batch.body[l] != 0) continue;
      for (int v = 0; v < vertices_per_hex; ++v) {
        const int node = batch.node[v][l];
        if (node >= static_cast<int>(seen.size()) || seen[node]) continue;
        seen[node] = 1;
        for (int c = 0; c < 3; ++c) state.displacement.local_element(3 * node + c) -= approach * up[c];
      }
    }
  state.approach += approach;
  complete(state.displacement, state.approach);
}

void ContactSolver::complete(Vector<double>& displacement, double approach) const {
  displacement.update_ghost_values();
  if (force_control())
    system_.level().distribute(displacement.begin());
  else
    system_.level().distribute(displacement.begin(), -approach * upright());
}

Vector<double> ContactSolver::linear_advance(double approach, const std::vector<RowStiffness>& stiffness,
                                             double accuracy, int* iterations) {
  // A rigid motion of the particle strains no body: only the active contacts have stiffness against it.
  ContactState rigid = first_touch();
  push_rigidly(rigid, approach);
  std::vector<double> forces = system_.interface().gaps(rigid.displacement.begin());
  for (std::size_t r = 0; r < forces.size(); ++r) forces[r] *= -stiffness[r].normal;
  Vector<double> load, relaxed;
  system_.level().initialise(load);
  system_.level().initialise(relaxed);
  system_.interface().add_forces(forces, load.begin());
  system_.level().condense(load.begin());
  load.compress(dealii::VectorOperation::add);
  system_.linear().update(stiffness, nullptr, 0.0);
  const int made = system_.linear().solve(relaxed, load, accuracy);
  if (iterations) *iterations += made;
  rigid.displacement.zero_out_ghost_values();
  relaxed.zero_out_ghost_values();
  rigid.displacement += relaxed;
  complete(rigid.displacement, approach);
  return rigid.displacement;
}

void ContactSolver::advance_to(ContactState& state, double approach, SolveReport& report) {
  std::vector<RowStiffness> stiffness(state.multiplier.size());
  for (std::size_t r = 0; r < stiffness.size(); ++r)
    stiffness[r] = state.multiplier[r] > 0 ? penalty_ * system_.areas()[r] : 0.0;
  Vector<double> step = linear_advance(approach - state.approach, stiffness, 1e-2, &report.linear);
  state.displacement.zero_out_ghost_values();
  step.zero_out_ghost_values();
  state.displacement += step;
  state.approach = approach;
  complete(state.displacement, approach);
}

void ContactSolver::read_approach(ContactState& state) const {
  const auto& level = system_.level();
  const double own =
      level.owns_driven_dof() ? -state.displacement.local_element(level.local_driven_dof()) : 0.0;
  state.approach = dealii::Utilities::MPI::sum(own, level.communicator()) / upright();
}

std::vector<double> ContactSolver::gaps(const ContactState& state) const {
  std::vector<double> gaps = system_.interface().gaps(state.displacement.begin());
  for (std::size_t r = 0; r < gaps.size(); ++r) gaps[r] += system_.initial_gaps()[r] - touch_offset_;
  return gaps;
}

double ContactSolver::evaluate(const ContactState& state, double target, Vector<double>& residual,
                               TangentField* tangent) {
  const auto& level = system_.level();
  tractions_.evaluate(state, gaps(state));
  residual = 0.0;
  if (parallel(system_)) residual.zero_out_ghost_values();
  system_.bodies().internal_force(state.displacement, residual, tangent);
  // Not `residual *= -1`, which leaves out the ghost entries that are being sent to other ranks.
  const std::size_t entries = residual.locally_owned_size() + level.partitioner()->n_ghost_indices();
  for (std::size_t i = 0; i < entries; ++i) residual.begin()[i] = -residual.begin()[i];
  tractions_.add_forces(residual.begin());
  if (force_control() && level.owns_driven_dof())
    residual.begin()[level.local_driven_dof()] -= target / upright();
  level.condense(residual.begin());
  residual.compress(dealii::VectorOperation::add);
  double scale = std::max(tractions_.total_force(), force_control() ? std::abs(target) : 0.0);
  const double spacing = system_.options().mesh.sizes.spacing_particle;
  if (scale == 0)
    scale = 0.1 * system_.reduced_modulus() * spacing *
            spacing;  // no contact: what would flatten a tenth of a spacing
  rounding_ = force_of_rounding(state.displacement) / scale;
  return residual.l1_norm() / scale;
}

double ContactSolver::force_of_rounding(const Vector<double>& displacement) const {
  double sum = 0;
  for (std::size_t i = 0; i < displacement.locally_owned_size(); ++i)
    sum += elastic_diagonal_.local_element(i) * std::abs(displacement.local_element(i));
  return std::numeric_limits<double>::epsilon() *
         dealii::Utilities::MPI::sum(sum, system_.level().communicator());
}

int ContactSolver::newton_direction(const TangentField* tangent, double spring, double accuracy,
                                    const Vector<double>& residual, Vector<double>& direction) {
  int iterations = 0;
  if (tractions_.has_adhesion() && convex_steps_left_-- <= 0) {
    // Attraction that falls with the gap softens; where that makes the matrix indefinite, as in a jump, it is
    // left out for some steps.
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

void ContactSolver::step_with_held_rows(ContactState& state, double target, TangentField* tangent,
                                        Vector<double>& residual, Vector<double>& direction,
                                        SolveReport& report) {
  evaluate(state, target, residual, tangent);
  if (tractions_.any_closed()) {
    report.linear += newton_direction(tangent, 0.0, rough_direction, residual, direction);
    state.displacement.zero_out_ghost_values();
    direction.zero_out_ghost_values();
    state.displacement += direction;
    state.displacement.update_ghost_values();
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

SolveReport ContactSolver::solve(ContactState& state, double target, const RigidMotion& motion,
                                 double time_step) {
  SolveReport report;
  const auto& level = system_.level();
  // The surfaces have moved with their frames and in them: by the mean over the pressure, and what differs
  // from it is small. A failed step or a restart may have left the interfaces coupled elsewhere.
  if (!(system_.coupling() == state.coupling)) system_.couple_at(state.coupling, state.displacement);
  const std::vector<double> gaps_before = gaps(state);
  constexpr double growth = 1.001;  // steps at the same load meet it within their tolerance
  const bool load_grows = force_control() ? target > growth * tractions_.carried_load(state, gaps_before)
                                          : target > state.approach;
  system_.couple_at({motion, mean_displacement(state)}, state.displacement);
  state.coupling = system_.coupling();
  system_.bodies().begin_step({state.time + time_step, time_step});
  tractions_.begin_step(state, motion, gaps_before, gaps(state), load_grows, time_step);
  state.motion = motion;
  if (force_control())
    complete(state.displacement, state.approach);
  else
    advance_to(state, target, report);
  Vector<double> residual, direction;
  for (auto* v : {&residual, &direction}) level.initialise(*v);
  TangentField* tangent = system_.bodies().can_yield() ? &tangent_ : nullptr;
  // First guess of the stick-slip state: nodes that slipped keep slipping if the motion continues in their
  // direction; at the start and after a reversal all nodes stick.
  if (tractions_.has_friction()) {
    tractions_.hold_unless_slipping_on(state);
    step_with_held_rows(state, target, tangent, residual, direction, report);
  }
  double error = evaluate(state, target, residual, tangent);

  slip_stiffness_ = SlipStiffness::tangent;
  LineSearch search(error, tractions_.has_friction() ? patience_with_friction : patience_without);
  bool closed = false;  // whether another update of the multipliers would change less than the tolerances
  for (report.updates = 0; report.updates <= options_.largest_updates; ++report.updates) {
    for (;;) {
      // The residual after a multiplier update is about as large as the change of the multipliers: each
      // update is followed by a solution more accurate than that, the last one by a solution to the full
      // tolerance.
      const double wanted = closed ? 0.0
                            : report.updates == 0
                                ? first_goal
                                : std::min(first_goal, fraction_of_change * report.penetration);
      const double goal = std::max({options_.residual_tolerance, rounding_, wanted});
      if (error <= goal || report.newton >= options_.largest_newton) break;
      // Without active contact nodes a spring with the stiffness of one contact regularises the system: the
      // direction is still one of descent.
      const bool open = !tractions_.any_closed();
      const double spring = open && force_control()
                                ? system_.reduced_modulus() * system_.options().mesh.sizes.spacing_particle
                                : 0.0;
      const double accuracy = std::clamp(0.1 * goal / error, accurate_direction, rough_direction);
      report.linear += newton_direction(tangent, spring, accuracy, residual, direction);
      ++report.newton;

      // The slope along the direction changes sign where the convex energy is lowest.
      const double slope = residual * direction;
      const Vector<double> start = state.displacement;
      direction.zero_out_ghost_values();
      const auto slope_at = [&](double step) {
        state.displacement = start;
        state.displacement.zero_out_ghost_values();
        state.displacement.add(step, direction);
        state.displacement.update_ghost_values();
        error = evaluate(state, target, residual, tangent);
        return residual * direction;
      };
      const double error_before = error;
      const double step = search.step(slope, slope_at);
      search.reached(error);
      // Cut steps show that nodes change from slip to stick. The consistent tangent has no stiffness along
      // the slip direction, so its steps overshoot that change; the secant stiffness, an upper bound of the
      // convex energy, does not. The two alternate whenever one of them makes little progress.
      constexpr double little_progress = 0.5;
      const bool is_slow = error > little_progress * error_before;
      const bool stays = slip_stiffness_ == SlipStiffness::secant ? !is_slow : !is_slow && step >= 1;
      if (!stays)
        slip_stiffness_ =
            slip_stiffness_ == SlipStiffness::secant ? SlipStiffness::tangent : SlipStiffness::secant;
      if (log)
        log("  newton " + std::to_string(report.newton) + " step " + std::to_string(step) + " residual " +
            std::to_string(error) + " cg " + std::to_string(report.linear) + " active " +
            std::to_string(tractions_.closed()) + " sticking " + std::to_string(tractions_.sticking()));
    }
    const auto change = tractions_.change(state);
    // The unbalanced force is measured by the pressures' total, and so is the change that sets the next goal.
    report.penetration = change.pressure + change.shear * tractions_.shear_share();
    report.residual = error;
    if (log)
      log(" update " + std::to_string(report.updates) + " change " + std::to_string(change.pressure) + " " +
          std::to_string(change.shear));
    closed = change.pressure <= options_.penetration_tolerance && change.shear <= options_.slip_tolerance;
    if (closed && error <= std::max(options_.residual_tolerance, rounding_)) {
      report.converged = true;
      break;
    }
    if (report.newton >= options_.largest_newton) break;
    if (!closed) {
      // The update doubles the traction that the penalty carried, so that sticking rows would slip in the
      // next evaluation.
      if (tractions_.has_friction()) tractions_.hold_sticking();
      system_.follow_slopes(state.displacement);
      tractions_.update_multipliers(state);
      tractions_.update_limits(state);
      if (tractions_.has_friction()) step_with_held_rows(state, target, tangent, residual, direction, report);
      error = evaluate(state, target, residual, tangent);
      search.restart(error);
    }
  }
  tractions_.update_multipliers(state);
  report.friction_work = tractions_.friction_work(state);
  if (tractions_.has_adhesion()) {
    const std::vector<double> here = gaps(state);
    report.adhesion_loss = tractions_.update_bonds(state, here);
    report.adhesion_energy = tractions_.adhesion_energy(state, here);
  }
  tractions_.update_history(state);
  if (force_control()) read_approach(state);
  return report;
}

}  // namespace asperity::fem
