#include "tests/fem/support/smooth_contact.h"

#include <cmath>

#include "fem/contact/contact_solver.h"

namespace asperity::test {

double Hertz::contact_radius() const { return std::cbrt(3 * force * radius / (4 * modulus)); }
double Hertz::peak_pressure() const { return 1.5 * force / (M_PI * contact_radius() * contact_radius()); }

namespace {

fem::ContactSystemOptions system_options(const SmoothContactOptions& o) {
  fem::ContactSystemOptions options;
  auto& s = options.mesh.sizes;
  s.radius = o.radius;
  s.block_half_width = o.block_half_width;
  // The substrate's lattice is shifted and a little coarser, so that no node meets another.
  s.spacing_particle = o.spacing;
  s.spacing_substrate = 1.1 * o.spacing;
  s.offset_substrate_x = 0.37 * o.spacing;
  s.offset_substrate_y = 0.21 * o.spacing;
  s.region_particle = 1.2 * o.largest_radius;
  s.region_substrate = s.region_particle + 3 * o.spacing;
  options.mesh.layers = o.layers;
  options.materials = {o.particle, o.substrate};
  return options;
}

}  // namespace

struct SmoothContact::Implementation {
  explicit Implementation(const SmoothContactOptions& o)
      : options(o), system(MPI_COMM_WORLD, system_options(o)), solver(system, {}), state(solver.first_touch()) {
    far_field = solver.far_field_compliance(0.8 * o.largest_radius);
  }
  SmoothContactOptions options;
  fem::ContactSystem system;
  fem::ContactSolver solver;
  fem::ContactState state;
  double far_field = 0;
};

SmoothContact::SmoothContact(const SmoothContactOptions& options) : it_(std::make_unique<Implementation>(options)) {}
SmoothContact::~SmoothContact() = default;

double SmoothContact::reduced_modulus() const { return it_->system.reduced_modulus(); }
long SmoothContact::unknowns() const { return static_cast<long>(it_->system.level().size()); }
Hertz SmoothContact::hertz(double force) const { return {it_->options.radius, reduced_modulus(), force}; }
double SmoothContact::elastic_stiffness() { return it_->solver.elastic_stiffness(it_->state); }

ContactStep SmoothContact::load(double force) {
  auto& state = it_->state;
  const auto before = state.displacement;
  if (state.approach == 0) it_->solver.push_rigidly(state, 0.7 * hertz(force).approach());
  const auto report = it_->solver.solve(state, force);
  const auto resultants = it_->solver.resultants(state);
  const auto cells = it_->system.bodies().cell_states(state.displacement);
  const auto energies = it_->system.bodies().accept(before, state.displacement);

  ContactStep step;
  step.force = resultants.force;
  step.raw_approach = state.approach;
  step.approach = state.approach - it_->far_field * force;
  step.contact_radius = std::sqrt(resultants.area / M_PI);
  step.peak_pressure = resultants.largest_pressure;
  step.reaction_driven = resultants.reaction_driven;
  step.reaction_fixed = resultants.reaction_fixed;
  step.elastic_energy = energies.elastic;
  step.plastic_work = energies.plastic_work;
  step.plastic_strain = energies.largest_plastic_strain;
  step.yield_ratio = energies.largest_yield_ratio;
  step.newton = report.newton, step.linear = report.linear, step.updates = report.updates;
  step.converged = report.converged;
  step.reaches_rim = resultants.reaches_rim;

  std::size_t k = 0;
  for (const auto& batch : it_->system.level().batches())
    for (int l = 0; l < batch.count; ++l, ++k) {
      double z = 0;
      for (int v = 0; v < fem::vertices_per_hex; ++v) z += it_->system.positions().local_element(3 * batch.node[v][l] + 2) / 8;
      const bool particle = batch.body[l] == 0;
      double& largest = particle ? step.particle_von_mises : step.von_mises;
      if (cells[k].von_mises <= largest) continue;
      largest = cells[k].von_mises;
      (particle ? step.particle_von_mises_depth : step.von_mises_depth) = std::abs(z);
    }
  return step;
}

double SmoothContact::residual_depth() const {
  // The deepest point of the substrate's surface; the far field is back at rest when no force acts.
  double deepest = 0;
  const auto& displacement = it_->state.displacement;
  const auto& level = it_->system.level();
  for (const auto& batch : level.batches())
    for (int l = 0; l < batch.count; ++l) {
      if (batch.body[l] != 1) continue;
      for (int v = 0; v < fem::vertices_per_hex; ++v) {
        const int node = batch.node[v][l];
        if (it_->system.positions().local_element(3 * node + 2) > -1e-15) deepest = std::max(deepest, -displacement.local_element(3 * node + 2));
      }
    }
  return deepest;
}

}  // namespace asperity::test
