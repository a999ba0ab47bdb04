#include "fem/contact/contact_solver.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.h"
#include "fem/contact/contact_area.h"
#include "fem/contact/line_search.h"

namespace asperity::fem {
namespace {

// Unbalanced force, relative, of the first solution and of those after an update of the multipliers.
constexpr double first_goal = 1e-3, fraction_of_change = 0.03;
// Bounds of the residual that conjugate gradients leave of a Newton direction: closer ones save hardly a Newton step.
constexpr double accurate_direction = 1e-2, rough_direction = 1e-1;

bool parallel(const ContactSystem& system) { return dealii::Utilities::MPI::n_mpi_processes(system.level().communicator()) > 1; }

}  // namespace

ContactSolver::ContactSolver(ContactSystem& system, const ContactSolverOptions& options) : system_(system), options_(options) {
  penalty_ = options_.penalty_factor * system.reduced_modulus() / system.options().mesh.sizes.spacing_particle;
  const auto& gaps = system.initial_gaps();
  touch_offset_ = *std::min_element(gaps.begin(), gaps.end());
}

ContactState ContactSolver::first_touch() const {
  ContactState state;
  system_.level().initialise(state.displacement);
  state.displacement.update_ghost_values();
  state.multiplier.assign(system_.rows().size(), 0.0);
  return state;
}

void ContactSolver::push_rigidly(ContactState& state, double approach) const {
  const auto& level = system_.level();
  std::vector<char> seen(state.displacement.locally_owned_size() / 3, 0);
  for (const auto& batch : level.batches())
    for (int l = 0; l < batch.count; ++l) {
      if (batch.body[l] != 0) continue;
      for (int v = 0; v < vertices_per_hex; ++v) {
        const int node = batch.node[v][l];
        if (node >= static_cast<int>(seen.size()) || seen[node]) continue;
        seen[node] = 1;
        state.displacement.local_element(3 * node + 2) -= approach;
      }
    }
  state.approach += approach;
  complete(state.displacement, state.approach);
}

void ContactSolver::complete(Vector<double>& displacement, double approach) const {
  displacement.update_ghost_values();
  if (force_control()) system_.level().distribute(displacement.begin());
  else system_.level().distribute(displacement.begin(), -approach);
}

Vector<double> ContactSolver::linear_advance(double approach, const std::vector<double>& stiffness, double accuracy, int* iterations) {
  // The particle's rigid motion strains nothing: only the closed contacts resist it.
  ContactState rigid = first_touch();
  push_rigidly(rigid, approach);
  std::vector<double> forces = system_.interface().gaps(rigid.displacement.begin());
  for (std::size_t r = 0; r < forces.size(); ++r) forces[r] *= -stiffness[r];
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
  std::vector<double> stiffness(state.multiplier.size());
  for (std::size_t r = 0; r < stiffness.size(); ++r) stiffness[r] = state.multiplier[r] > 0 ? penalty_ * system_.areas()[r] : 0.0;
  Vector<double> step = linear_advance(approach - state.approach, stiffness, 1e-2, &report.linear);
  state.displacement.zero_out_ghost_values();
  step.zero_out_ghost_values();
  state.displacement += step;
  state.approach = approach;
  complete(state.displacement, approach);
}

void ContactSolver::read_approach(ContactState& state) const {
  const auto& level = system_.level();
  const double own = level.owns_driven_dof() ? -state.displacement.local_element(level.local_driven_dof()) : 0.0;
  state.approach = dealii::Utilities::MPI::sum(own, level.communicator());
}

std::vector<double> ContactSolver::gaps(const ContactState& state) const {
  std::vector<double> gaps = system_.interface().gaps(state.displacement.begin());
  for (std::size_t r = 0; r < gaps.size(); ++r) gaps[r] += system_.initial_gaps()[r] - touch_offset_;
  return gaps;
}

std::vector<double> ContactSolver::pressures(const ContactState& state, const std::vector<double>& gaps) const {
  std::vector<double> p(gaps.size());
  for (std::size_t r = 0; r < p.size(); ++r) p[r] = std::max(0.0, state.multiplier[r] - penalty_ * gaps[r]);
  return p;
}

double ContactSolver::evaluate(const ContactState& state, double target, Vector<double>& residual, TangentField* tangent,
                               std::vector<double>& p) {
  const auto& level = system_.level();
  p = pressures(state, gaps(state));
  residual = 0.0;
  if (parallel(system_)) residual.zero_out_ghost_values();
  system_.bodies().internal_force(state.displacement, residual, tangent);
  // Not `residual *= -1`, which leaves out the ghost entries on their way to other ranks.
  const std::size_t entries = residual.locally_owned_size() + level.partitioner()->n_ghost_indices();
  for (std::size_t i = 0; i < entries; ++i) residual.begin()[i] = -residual.begin()[i];
  std::vector<double> forces(p.size());
  double total = 0;
  for (std::size_t r = 0; r < p.size(); ++r) total += forces[r] = p[r] * system_.areas()[r];
  system_.interface().add_forces(forces, residual.begin());
  if (force_control() && level.owns_driven_dof()) residual.begin()[level.local_driven_dof()] -= target;
  level.condense(residual.begin());
  residual.compress(dealii::VectorOperation::add);
  double scale = std::max(total, force_control() ? std::abs(target) : 0.0);
  const double spacing = system_.options().mesh.sizes.spacing_particle;
  if (scale == 0) scale = 0.1 * system_.reduced_modulus() * spacing * spacing;  // no contact: what would flatten a tenth of a spacing
  return residual.l1_norm() / scale;
}

SolveReport ContactSolver::solve(ContactState& state, double target) {
  SolveReport report;
  const auto& level = system_.level();
  if (force_control()) complete(state.displacement, state.approach);
  else advance_to(state, target, report);
  Vector<double> residual, direction;
  for (auto* v : {&residual, &direction}) level.initialise(*v);
  std::vector<double> p;
  TangentField* tangent = system_.bodies().can_yield() ? &tangent_ : nullptr;
  double error = evaluate(state, target, residual, tangent, p);

  LineSearch search(error);
  bool closed = false;  // whether another update of the multipliers would change nothing of weight
  for (report.updates = 0; report.updates <= options_.largest_updates; ++report.updates) {
    for (;;) {
      // A multiplier update unbalances about as much as it changes: each is followed by a solution finer than that, the
      // last one by the full accuracy.
      const double wanted = closed ? 0.0 : report.updates == 0 ? first_goal : std::min(first_goal, fraction_of_change * report.penetration);
      const double goal = std::max(options_.residual_tolerance, wanted);
      if (error <= goal || report.newton >= options_.largest_newton) break;
      std::vector<double> stiffness(p.size());
      for (std::size_t r = 0; r < p.size(); ++r) stiffness[r] = p[r] > 0 ? penalty_ * system_.areas()[r] : 0.0;
      // With no contact closed a spring of one contact's stiffness holds the particle: still a direction of descent.
      const bool open = std::none_of(p.begin(), p.end(), [](double v) { return v > 0; });
      const double spring = open && force_control() ? system_.reduced_modulus() * system_.options().mesh.sizes.spacing_particle : 0.0;
      system_.linear().update(stiffness, tangent, spring);
      const double accuracy = std::clamp(0.1 * goal / error, accurate_direction, rough_direction);
      report.linear += system_.linear().solve(direction, residual, accuracy);
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
        error = evaluate(state, target, residual, tangent, p);
        return residual * direction;
      };
      const double step = search.step(slope, slope_at);
      search.reached(error);
      if (log)
        log("  newton " + std::to_string(report.newton) + " step " + std::to_string(step) + " residual " + std::to_string(error) +
            " cg " + std::to_string(report.linear) + " active " + std::to_string(std::count_if(p.begin(), p.end(), [](double v) { return v > 0; })));
    }
    double change = 0, total = 0;
    for (std::size_t r = 0; r < p.size(); ++r) {
      change += system_.areas()[r] * std::abs(p[r] - state.multiplier[r]);
      total += system_.areas()[r] * p[r];
    }
    report.penetration = total > 0 ? change / total : 0.0;
    report.residual = error;
    if (log) log(" update " + std::to_string(report.updates) + " change " + std::to_string(report.penetration));
    closed = report.penetration <= options_.penetration_tolerance;
    if (closed && error <= options_.residual_tolerance) {
      report.converged = true;
      break;
    }
    if (report.newton >= options_.largest_newton) break;
    if (!closed) {
      state.multiplier = p;
      error = evaluate(state, target, residual, tangent, p);
      search.restart(error);
    }
  }
  state.multiplier = p;
  if (force_control()) read_approach(state);
  return report;
}

ContactResultants ContactSolver::resultants(const ContactState& state) const {
  const auto& level = system_.level();
  ContactResultants result;
  double moment_x = 0, moment_y = 0;
  for (std::size_t r = 0; r < state.multiplier.size(); ++r) {
    const double p = state.multiplier[r];
    if (p <= 0) continue;
    const double force = p * system_.areas()[r];
    result.force += force;
    result.largest_pressure = std::max(result.largest_pressure, p);
    ++result.active;
    result.reaches_rim = result.reaches_rim || system_.on_rim()[r];
    system_.interface().for_row(static_cast<int>(r), [&](int node, double weight) {
      moment_x += force * weight * system_.interface_points()[node][1];
      moment_y += force * weight * system_.interface_points()[node][0];
    });
  }
  std::vector<std::array<double, 2>> points;
  for (const auto& row : system_.rows()) points.push_back({system_.interface_points()[row.node][0], system_.interface_points()[row.node][1]});
  result.area = contact_area(system_.row_quads(), points, state.multiplier, gaps(state), system_.reduced_modulus());
  if (result.force > 0)
    result.moment_error = std::hypot(moment_x, moment_y) / (result.force * std::sqrt(result.area / M_PI));
  Vector<double> force;
  level.initialise(force);
  system_.bodies().internal_force(state.displacement, force, nullptr);
  double driven = 0, fixed = 0;
  for (const auto& [dof, share] : level.driven_share()) driven -= share * force.begin()[dof];
  force.compress(dealii::VectorOperation::add);
  for (const int dof : level.fixed_z()) fixed += force.local_element(dof);
  result.reaction_driven = dealii::Utilities::MPI::sum(driven, level.communicator());
  result.reaction_fixed = dealii::Utilities::MPI::sum(fixed, level.communicator());
  return result;
}

double ContactSolver::elastic_stiffness(const ContactState& state) {
  const auto& level = system_.level();
  std::vector<double> stiffness(state.multiplier.size());
  // Closed nodes move together: a spring far stiffer than the bodies' own spacing-scale stiffness.
  for (std::size_t r = 0; r < stiffness.size(); ++r) stiffness[r] = state.multiplier[r] > 0 ? 50 * penalty_ * system_.areas()[r] : 0.0;
  if (!force_control()) {
    const std::vector<double> gaps = system_.interface().gaps(linear_advance(1.0, stiffness, 1e-6, nullptr).begin());
    double force = 0;
    for (std::size_t r = 0; r < gaps.size(); ++r) force -= stiffness[r] * gaps[r];
    return force;
  }
  system_.linear().update(stiffness, nullptr, 0.0);
  Vector<double> unit, response;
  level.initialise(unit);
  level.initialise(response);
  if (level.owns_driven_dof()) unit.local_element(level.local_driven_dof()) = -1.0;
  system_.linear().solve(response, unit, 1e-6);
  const double own = level.owns_driven_dof() ? -response.local_element(level.local_driven_dof()) : 0.0;
  const double compliance = dealii::Utilities::MPI::sum(own, level.communicator());
  return 1 / compliance;
}

double ContactSolver::far_field_compliance(double radius) {
  const auto& level = system_.level();
  const auto& areas = system_.areas();
  std::vector<double> forces(areas.size(), 0.0), none(areas.size(), 0.0);
  double total = 0;
  for (std::size_t r = 0; r < areas.size(); ++r) {
    const auto& p = system_.interface_points()[system_.rows()[r].node];
    const double s = 1 - (p[0] * p[0] + p[1] * p[1]) / (radius * radius);
    if (s > 0) total += forces[r] = areas[r] * std::sqrt(s);
  }
  for (auto& f : forces) f /= total;
  Vector<double> load, response;
  level.initialise(load);
  level.initialise(response);
  system_.interface().add_forces(forces, load.begin());
  // Under displacement control the driven plane's reaction is the opposite load.
  if (force_control() && level.owns_driven_dof()) load.begin()[level.local_driven_dof()] -= 1.0;
  level.condense(load.begin());
  load.compress(dealii::VectorOperation::add);
  const double spring = force_control() ? system_.reduced_modulus() * radius : 0.0;  // carries nothing: the loads balance
  system_.linear().update(none, nullptr, spring);
  system_.linear().solve(response, load, 1e-7);
  const std::vector<double> opening = system_.interface().gaps(response.begin());
  double mean = 0;
  for (std::size_t r = 0; r < forces.size(); ++r) mean += forces[r] * opening[r];
  // Half-spaces under Hertz' pressure and unit force: delta = 3 / (4 E* a); the pressure-weighted mean of the surfaces'
  // displacement is 0.8 delta, because the mean of r^2 under that pressure is 2 a^2 / 5.
  return mean - 0.8 * 3 / (4 * system_.reduced_modulus() * radius);
}

}  // namespace asperity::fem
