// What an experiment writes: the row of each step, its checkpoint, the result.
#include <deal.II/base/multithread_info.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>

#include "core/atomic_file.h"
#include "core/quantity.h"
#include "fem/experiments/contact_experiment.h"
#include "fem/output/added_column.h"
#include "fem/output/checkpoint.h"
#include "fem/output/half_space_check.h"
#include "fem/output/half_space_map.h"
#include "fem/output/result_file.h"

namespace asperity::fem {
namespace {

/// Of a step: what the bodies store and how far they yield; `sums` holds what was dissipated so far.
void set_energies(HistoryRow& r, const BodyEnergies& energies, const HistoryRow& sums) {
  r.elastic_energy = energies.elastic;
  r.hardening_energy = energies.hardening;
  r.plastic_work = sums.plastic_work;
  r.friction_work = sums.friction_work;
  r.adhesion_energy = sums.adhesion_energy;
  r.adhesion_loss = sums.adhesion_loss;
  r.dissipated_energy = r.plastic_work - r.hardening_energy + r.friction_work + r.adhesion_loss;
  r.plastic_volume = energies.plastic_volume;
  r.load_step_error = energies.approach_error;
  r.largest_plastic_strain = energies.largest_plastic_strain();
  r.largest_von_mises = energies.largest_von_mises();
  r.particle_plastic_strain = energies.plastic_strain[0];
  r.substrate_plastic_strain = energies.plastic_strain[1];
  r.particle_von_mises = energies.von_mises[0];
  r.substrate_von_mises = energies.von_mises[1];
}

}  // namespace

HistoryRow ContactExperiment::record(const BodyEnergies& energies, const HistoryRow& sums) const {
  const ContactResultants c = solver_->resultants(state_);
  HistoryRow r;
  r.step = static_cast<double>(records_.size() + 1);
  r.time = state_.time;
  set_energies(r, energies, sums);
  r.normal_force = c.force - setup_.attraction_force;
  r.attraction = c.attraction + setup_.attraction_force;
  r.driven_displacement = state_.approach;
  r.normal_displacement =
      state_.approach - stiffness_.far_field * c.force - delayed_far_field_.approach(records_, r);
  const RigidMotion& start = program_.front().motion;
  r.shift = state_.motion.x - start.x;
  r.lateral_force = c.lateral_force[0];
  r.shift_across = state_.motion.y - start.y;
  r.lateral_force_across = c.lateral_force[1];
  r.lateral_displacement =
      r.shift - stiffness_.lateral_far_field * r.lateral_force - delayed_far_field_.shift(records_, r);
  r.rolling_angle = state_.motion.roll - start.roll;
  r.rolling_moment = c.rolling_moment;
  r.torsion_angle = state_.motion.spin;
  r.torsion_moment = c.torsion_moment;
  r.sticking_share = c.active > 0 ? static_cast<double>(c.sticking) / c.active : 0;
  // First touch moves the particle by the offset: outwards, so negative, where asperities meet first.
  r.mean_plane_approach = r.normal_displacement + solver_->touch_offset();
  r.contact_radius = std::sqrt(c.area / M_PI);
  r.pressure_radius = c.pressure_radius;
  r.load_centre_x = c.centre[0], r.load_centre_y = c.centre[1];
  r.spots = c.spots, r.contact_perimeter = c.perimeter;
  r.contact_area = c.area;
  r.max_pressure = c.largest_pressure;
  r.mean_pressure = c.area > 0 ? c.force / c.area : 0;
  if (c.force > 0)
    r.force_error =
        std::max({std::abs(c.reaction_driven / c.force - 1), std::abs(c.reaction_fixed / c.force - 1),
                  std::abs(c.lateral_reaction[0] - c.lateral_force[0]) / c.force,
                  std::abs(c.lateral_reaction[1] - c.lateral_force[1]) / c.force});
  r.moment_error = c.moment_error;
  r.reaches_rim = c.reaches_rim;
  r.newton_iterations = last_report_.newton;
  r.linear_iterations = last_report_.linear;
  r.penetration = last_report_.penetration;
  r.wall_time = wall_time();
  return r;
}

void ContactExperiment::say_rim() const {
  const std::size_t steps = records_.size();
  if (!(records_.back().reaches_rim > 0) || (steps > 1 && records_[steps - 2].reaches_rim > 0)) return;
  say("the contact has come to the edge of the finely meshed region of ±" +
      format_quantity(setup_.system.mesh.sizes.region_particle, Dimension::length) +
      ", beyond which nothing touches: it is too small and too soft from here on; solve again with a larger "
      "Mesh/Contact region");
}

void ContactExperiment::write_step() {
  say_rim();
  Checkpoint c;
  c.provenance = provenance();
  c.records = records_;
  c.load = load_;
  c.wall_time = wall_time();
  c.stiffness = stiffness_;
  c.parts = parts_;
  if (const auto& kept = system_->options().mesh.kept) c.kept = kept->cells();
  c.interface = state_;
  c.path = solver_->prediction().memory(state_);
  c.displacement.assign(state_.displacement.begin(),
                        state_.displacement.begin() + state_.displacement.locally_owned_size());
  c.history = system_->bodies().save_history();
  write_checkpoint(options_.output / "checkpoint", c, MPI_COMM_WORLD);
  if (speaks())
    write_file_atomically(options_.output / "history.csv",
                          format_history(history_of(records_, added_column_names())));
}

void ContactExperiment::say_load_steps() const {
  constexpr double small = 0.005;  // of the approach, as much as a fine mesh leaves
  const HistoryRow& peak = at_largest_load(records_);
  const double share = peak.normal_displacement > 0 ? peak.load_step_error / peak.normal_displacement : 0;
  if (share <= small) return;
  const int enough = static_cast<int>(std::ceil(input_.experiment.load_steps * share / small));
  say("the load steps leave the approach some " +
      std::to_string(std::lround(1000 * share) / 10.0).substr(0, 4) +
      " % too large; Experiment/Load steps = " + std::to_string(enough) + " would leave half a per cent");
}

void ContactExperiment::write_result() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  ResultSummary summary;
  summary.provenance = provenance();
  summary.peak_memory =
      dealii::Utilities::MPI::sum(static_cast<double>(usage.ru_maxrss) * 1024, MPI_COMM_WORLD);
  summary.wall_time = wall_time();
  summary.ranks = ranks_;
  summary.threads = static_cast<int>(dealii::MultithreadInfo::n_threads());
  summary.cells = most_cells_;
  summary.unknowns = most_unknowns_;
  summary.contact_nodes = static_cast<long>(system_->rows().size());
  summary.stiffness = stiffness_;
  const HistoryRow& peak = at_largest_load(records_);
  double tension = 0;
  for (const auto& row : records_) tension = std::max(tension, -row.normal_force);
  if (speaks()) summary.half_space = half_space_check(input_, setup_, peak, tension);
  if (summary.half_space) {
    say(half_space_text(*summary.half_space, peak, stiffness_.normal, tension));
    if (input_.output.fields) write_half_space_map(options_.output, *summary.half_space);
  }
  if (speaks())
    write_file_atomically(options_.output / "result.json", result_json(input_, setup_, records_, summary));
  say_load_steps();
  say("wrote " + (options_.output / "result.json").string());
}

}  // namespace asperity::fem
