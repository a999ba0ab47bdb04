#include "tests/fem/support/smooth_contact.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "fem/contact/contact_solver.h"

namespace asperity::test {

double LoadedHertz::contact_radius() const { return std::cbrt(3 * force * radius / (4 * modulus)); }
double LoadedHertz::peak_pressure() const {
  return 1.5 * force / (M_PI * contact_radius() * contact_radius());
}

namespace {

fem::ContactSystemOptions system_options(const SmoothContactOptions& o) {
  fem::ContactSystemOptions options;
  auto& s = options.mesh.sizes;
  s.radius = o.radius;
  s.block_half_width = o.block_half_width;
  // The substrate's lattice is shifted and of another spacing, so that no node meets another.
  s.spacing_particle = o.spacing;
  s.spacing_substrate = o.substrate_spacing * o.spacing;
  s.offset_substrate_x = 0.37 * o.spacing;
  s.offset_substrate_y = 0.21 * o.spacing;
  s.region_particle = 1.2 * o.largest_radius;
  s.region_substrate = s.region_particle + 3 * o.spacing;
  options.mesh.layers = o.layers;
  options.materials = {o.particle, o.substrate};
  options.films = o.films;
  return options;
}

struct Peak {
  double stress = 0, depth = 0;
};

/// Top of the polynomial through the largest of the values and two neighbours on either side. The curve falls
/// more gently below its top than above: a parabola through three values would put the top too deep.
Peak top_of_curve(const std::vector<Peak>& values) {
  const int count = static_cast<int>(values.size());
  const int top =
      static_cast<int>(std::max_element(values.begin(), values.end(),
                                        [](const Peak& a, const Peak& b) { return a.stress < b.stress; }) -
                       values.begin());
  if (top < 2 || top + 2 >= count) return values[top];
  const auto curve = [&](double depth) {
    double sum = 0;
    for (int i = top - 2; i <= top + 2; ++i) {
      double shape = 1;
      for (int j = top - 2; j <= top + 2; ++j)
        if (j != i) shape *= (depth - values[j].depth) / (values[i].depth - values[j].depth);
      sum += shape * values[i].stress;
    }
    return sum;
  };
  Peak peak = values[top];
  constexpr int samples = 2000;
  for (int k = 0; k <= samples; ++k) {
    const double depth =
        values[top - 1].depth + (values[top + 1].depth - values[top - 1].depth) * k / samples;
    if (const double stress = curve(depth); stress > peak.stress) peak = {stress, depth};
  }
  return peak;
}

/// Largest von Mises stress along the axis of a body: of the cells around the axis, averaged at each depth.
Peak largest_on_axis(const fem::ContactSystem& system, const std::vector<fem::CellState>& cells, int body) {
  struct Column {
    double stress = 0, depth = 0;
    int count = 0;
  };
  std::map<long, Column> by_depth;
  std::size_t k = 0;
  for (const auto& batch : system.level().batches())
    for (int l = 0; l < batch.count; ++l, ++k) {
      if (batch.body[l] != body) continue;
      std::array<double, 3> low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
      for (int v = 0; v < fem::vertices_per_hex; ++v)
        for (int c = 0; c < 3; ++c) {
          const double x = system.positions().local_element(3 * batch.node[v][l] + c);
          low[c] = std::min(low[c], x), high[c] = std::max(high[c], x);
        }
      const double reach =
          1e-3 * (high[0] - low[0]) + (body == 1 ? system.options().mesh.sizes.offset_substrate_x : 0.0);
      if (low[0] > reach || high[0] < -reach || low[1] > reach || high[1] < -reach) continue;
      const double depth = std::abs(0.5 * (low[2] + high[2]));
      Column& column = by_depth[std::lround(depth / (0.05 * system.options().mesh.sizes.spacing_particle))];
      column.stress += cells[k].von_mises, column.depth += depth, ++column.count;
    }
  std::vector<Peak> peaks;
  for (const auto& [key, c] : by_depth) peaks.push_back({c.stress / c.count, c.depth / c.count});
  std::sort(peaks.begin(), peaks.end(), [](const Peak& a, const Peak& b) { return a.depth < b.depth; });
  return top_of_curve(peaks);
}

}  // namespace

struct SmoothContact::Implementation {
  explicit Implementation(const SmoothContactOptions& o)
      : options(o),
        system(MPI_COMM_WORLD, system_options(o)),
        solver(system, {}),
        state(solver.first_touch()) {
    far_field = solver.far_field_compliance(0.8 * o.largest_radius);
  }
  SmoothContactOptions options;
  fem::ContactSystem system;
  fem::ContactSolver solver;
  fem::ContactState state;
  double far_field = 0, force = 0;
};

SmoothContact::SmoothContact(const SmoothContactOptions& options)
    : it_(std::make_unique<Implementation>(options)) {}
SmoothContact::~SmoothContact() = default;

double SmoothContact::reduced_modulus() const { return it_->system.reduced_modulus(); }
long SmoothContact::unknowns() const { return static_cast<long>(it_->system.level().size()); }
LoadedHertz SmoothContact::hertz(double force) const {
  return {it_->options.radius, reduced_modulus(), force};
}

ContactStep SmoothContact::load(double force) {
  auto& state = it_->state;
  const auto before = state.displacement;
  if (state.approach == 0) it_->solver.push_rigidly(state, 0.7 * hertz(force).approach());
  const auto report = it_->solver.solve(state, force);
  const auto resultants = it_->solver.resultants(state);
  const auto cells = it_->system.bodies().cell_states(state.displacement);
  const auto energies = it_->system.bodies().accept(before, state.displacement, force - it_->force);

  it_->force = force;

  ContactStep step;
  step.load_step_error = energies.approach_error;
  step.force = resultants.force;
  step.raw_approach = state.approach;
  step.approach = state.approach - it_->far_field * force;
  step.contact_radius = std::sqrt(resultants.area / M_PI);
  step.peak_pressure = resultants.largest_pressure;
  step.reaction_driven = resultants.reaction_driven;
  step.reaction_fixed = resultants.reaction_fixed;
  step.elastic_energy = energies.elastic;
  step.plastic_work = energies.plastic_work;
  step.plastic_strain = energies.largest_plastic_strain();
  step.yield_ratio = energies.largest_yield_ratio;
  step.newton = report.newton, step.linear = report.linear, step.updates = report.updates;
  step.converged = report.converged;
  step.reaches_rim = resultants.reaches_rim;

  const auto substrate = largest_on_axis(it_->system, cells, 1),
             particle = largest_on_axis(it_->system, cells, 0);
  step.von_mises = substrate.stress, step.von_mises_depth = substrate.depth;
  step.particle_von_mises = particle.stress, step.particle_von_mises_depth = particle.depth;
  return step;
}

}  // namespace asperity::test
