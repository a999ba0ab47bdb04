#include "fem/contact/contact_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace asperity::fem {
namespace {

constexpr int more_newton_steps_for_jumps = 10;

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
      prediction_(system.options().mesh.sizes.radius, system.options().mesh.sizes.region_particle),
      elastic_diagonal_(
          HexOperator<float>(system.level(), system.positions(), system.materials()).diagonal()) {
  const auto& gaps = system.initial_gaps();
  touch_offset_ = options_.touch_offset.value_or(*std::min_element(gaps.begin(), gaps.end()));
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
    sum += static_cast<double>(elastic_diagonal_.local_element(i)) * std::abs(displacement.local_element(i));
  return std::numeric_limits<double>::epsilon() *
         dealii::Utilities::MPI::sum(sum, system_.level().communicator());
}

}  // namespace asperity::fem
