// Meshes of an experiment: the first, that of a checkpoint it goes on from, and those of a contact on its
// way.
#include <algorithm>

#include "core/error.h"
#include "core/machine_memory.h"
#include "core/quantity.h"
#include "core/wait_text.h"
#include "fem/case/derived_spacing.h"
#include "fem/case/mesh_quality.h"
#include "fem/case/solve_cost.h"
#include "fem/contact/carried_state.h"
#include "fem/experiments/contact_experiment.h"
#include "fem/materials/material_law.h"

namespace asperity::fem {

void ContactExperiment::mesh(const FineParts& parts, const std::shared_ptr<const meshing::KeptCells>& kept) {
  ContactSolverOptions options;
  options.residual_tolerance = input_.solver.tolerance;
  options.largest_newton = input_.solver.newton_steps;
  options.friction = make_friction_law(input_.interface);
  options.adhesion = make_adhesion_laws(input_.interface);
  if (solver_) options.touch_offset = solver_->touch_offset();
  solver_.reset();
  system_.reset();
  parts_ = parts;
  ContactSystemOptions system = setup_.system;
  system.mesh.fine = path_.with_margin(parts);
  system.mesh.kept = kept;
  system_ = std::make_unique<ContactSystem>(MPI_COMM_WORLD, system);
  ContactState unloaded;
  system_->level().initialise(unloaded.displacement);
  unloaded.displacement.update_ghost_values();
  system_->couple_at({program_.front().motion, {}}, unloaded.displacement);
  solver_ = std::make_unique<ContactSolver>(*system_, options);
  if (options_.says_iterations && speaks()) solver_->log = options_.progress;
  if (const auto unknowns = static_cast<long>(system_->level().size()); unknowns > most_unknowns_) {
    most_unknowns_ = unknowns;
    most_cells_ = static_cast<long>(system_->forest().n_global_active_cells());
  }
}

void ContactExperiment::require_mesh_quality() {
  const HexMeshQuality quality =
      hex_mesh_quality(system_->level(), system_->positions(), system_->options().mesh);
  require_quality(quality, system_->options().mesh, input_.file);
  for (int body = 0; body < 2; ++body) {
    setup_.roughness[body].fidelity = quality.roughness[body];
    const std::string missed =
        missed_roughness_text(quality.roughness[body], body == 0 ? "particle" : "substrate");
    if (!missed.empty()) say(missed);
  }
}

bool ContactExperiment::start() {
  const auto& sizes = setup_.system.mesh.sizes;
  say("meshing: " + format_quantity(sizes.spacing_particle, Dimension::length) + " at the interface over ±" +
      format_quantity(sizes.region_particle, Dimension::length) + ", Hertz contact radius " +
      format_quantity(setup_.hertz_radius, Dimension::length));
  for (const std::string& text : resolution_texts(setup_)) say(text);
  if (ranks_ == 1) {  // others may be on machines of their own
    const double unknowns = estimated_unknowns(sizes, input_.mesh.layers) * path_.share_at_a_time();
    if (const auto text = memory_warning(input_, setup_, unknowns, available_memory()); !text.empty())
      say(text);
  }
  mesh(path_.first(), nullptr);
  state_ = solver_->first_touch();
  state_.motion = program_.front().motion;
  require_mesh_quality();
  say(std::to_string(system_->level().size()) + " unknowns, " + std::to_string(system_->rows().size()) +
      " contact nodes, " + system_->linear().description() + " (" + wait_text(wall_time()) + ")");
  if (path_.travels())
    say("fine cells travel with the contact: some " +
        format_quantity(100 * path_.share_at_a_time(), Dimension::none, 2) + " % of the whole path's");
  if (!options_.resume) return false;
  const auto checkpoint = read_checkpoint(options_.output / "checkpoint", provenance(), MPI_COMM_WORLD);
  if (checkpoint) resume(*checkpoint);
  return checkpoint.has_value();
}

void ContactExperiment::resume(const Checkpoint& checkpoint) {
  if (path_.travels()) {
    mesh(checkpoint.parts,
         checkpoint.kept.empty() ? nullptr : std::make_shared<meshing::KeptCells>(checkpoint.kept));
    state_ = solver_->first_touch();
  }
  if (checkpoint.displacement.size() != state_.displacement.locally_owned_size() ||
      checkpoint.interface.multiplier.size() != state_.multiplier.size())
    throw WorkError("the checkpoint in '" + options_.output.string() +
                    "' belongs to another mesh; solve again with --overwrite");
  std::copy(checkpoint.displacement.begin(), checkpoint.displacement.end(), state_.displacement.begin());
  state_.displacement.update_ghost_values();
  static_cast<InterfaceState&>(state_) = checkpoint.interface;
  solver_->prediction().restore(checkpoint.path, state_);
  system_->bodies().restore_history(checkpoint.history);
  records_ = checkpoint.records;
  load_ = checkpoint.load;
  stiffness_ = checkpoint.stiffness;
  time_before_ = checkpoint.wall_time;
  say("resuming after step " + std::to_string(checkpoint.steps()));
}

void ContactExperiment::travel_to(const RigidMotion& motion) {
  if (!path_.travels() || path_.holds(parts_, motion)) return;
  const CarriedState carried(*system_, state_, solver_->prediction().memory(state_));
  mesh(path_.onwards(state_.motion, motion), carried.yielded());
  // Other places of the path have other slopes.
  require_quality(hex_mesh_quality(system_->level(), system_->positions(), system_->options().mesh),
                  system_->options().mesh, input_.file);
  auto taken = carried.taken_by(*system_, solver_->first_touch());
  state_.take(taken.state);
  system_->couple_at(state_.coupling, state_.displacement);
  solver_->push_rigidly(state_, 0);  // constrained nodes of the new mesh follow those that hold them
  solver_->prediction().restore(taken.path, state_);
}

void ContactExperiment::measure_far_field() {
  // A radius well inside of the region and several spacings wide; the far field does not depend on it at
  // first order. Also when resumed: the smoothers take their eigenvalues from the first system they see, and
  // with the same ones the steps that follow are the same to the last digit. Of bodies that relax that of the
  // contact in the end, where the far field is largest.
  const double contact = relaxes(input_) ? setup_.largest_radius : setup_.hertz_radius;
  const double radius = std::max(std::min(contact, 0.8 * setup_.system.mesh.sizes.region_particle),
                                 6 * setup_.system.mesh.sizes.spacing_particle);
  stiffness_.far_field = solver_->far_field_compliance(radius);
  stiffness_.lateral_far_field = solver_->lateral_far_field_compliance(radius);
  delayed_far_field_.measure(*solver_, setup_.system.materials, radius, stiffness_.far_field,
                             stiffness_.lateral_far_field);
}

}  // namespace asperity::fem
