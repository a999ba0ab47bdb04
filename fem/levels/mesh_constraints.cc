// Constraints of a mesh level: hanging nodes, the fixed and the driven plane, and the layout of vectors that
// they need.
#include <deal.II/base/index_set.h>
#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <map>
#include <set>

#include "fem/levels/mesh_level.h"

namespace asperity::fem {

using dealii::types::global_dof_index;

namespace {

dealii::IndexSet boundary_dofs(const dealii::DoFHandler<3>& dofs, unsigned id, int component) {
  dealii::ComponentMask mask(3, false);
  mask.set(component, true);
  return dealii::DoFTools::extract_boundary_dofs(dofs, mask, {static_cast<dealii::types::boundary_id>(id)});
}

}  // namespace

struct MeshLevel::DriveShares {
  std::vector<std::pair<global_dof_index, double>> along_z;
  std::map<global_dof_index, double> along_x;
};

struct MeshLevel::TiedNodes {
  dealii::AffineConstraints<double> constraints;
  std::vector<int> fixed_z, driven_nodes;  ///< as MeshLevel keeps them
};

void MeshLevel::make_constraints() {
  const dealii::IndexSet& owned = dofs().locally_owned_dofs();
  first_owned_ = owned.n_elements() ? owned.nth_index_in_set(0) : 0;
  choose_driven_dof();
  const dealii::IndexSet relevant = relevant_dofs();
  DriveShares shares;
  dealii::AffineConstraints<double> constraints;
  {
    TiedNodes tied = tie_nodes(relevant);
    fixed_z_ = std::move(tied.fixed_z);
    driven_nodes_ = std::move(tied.driven_nodes);
    make_partitioner(relevant, tied.constraints);
    constraints = constrain(tied.constraints, shares);
  }
  fill_arrays(constraints, shares);
}

dealii::AffineConstraints<double> MeshLevel::constraints() const {
  DriveShares shares;
  return constrain(tie_nodes(relevant_dofs()).constraints, shares);
}

dealii::IndexSet MeshLevel::relevant_dofs() const {
  dealii::IndexSet relevant;
  dealii::DoFTools::extract_locally_relevant_dofs(dofs(), relevant);
  relevant.add_range(driven_dof_ - 2, driven_dof_ + 1);
  relevant.compress();
  return relevant;
}

void MeshLevel::choose_driven_dof() {
  global_dof_index lowest = dealii::numbers::invalid_dof_index;
  for (const auto dof : boundary_dofs(dofs(), meshing::driven_boundary, 2))
    if (dofs().locally_owned_dofs().is_element(dof)) lowest = std::min(lowest, dof);
  driven_dof_ = dealii::Utilities::MPI::min(lowest, communicator_);
}

MeshLevel::TiedNodes MeshLevel::tie_nodes(const dealii::IndexSet& relevant) const {
  const dealii::IndexSet& owned = dofs().locally_owned_dofs();
  TiedNodes result{dealii::AffineConstraints<double>(relevant), {}, {}};
  dealii::AffineConstraints<double>& tied = result.constraints;
  dealii::DoFTools::make_hanging_node_constraints(dofs(), tied);
  for (int component = 0; component < 3; ++component)
    for (const auto dof : boundary_dofs(dofs(), meshing::fixed_boundary, component))
      if (!tied.is_constrained(dof)) {
        if (component == 2 && owned.is_element(dof))
          result.fixed_z.push_back(static_cast<int>(dof - first_owned_));
        tied.add_line(dof);
      }
  for (int component = 0; component < 3; ++component)
    for (const auto dof : boundary_dofs(dofs(), meshing::driven_boundary, component)) {
      if (component == 2 && owned.is_element(dof))
        result.driven_nodes.push_back(static_cast<int>((dof - first_owned_) / 3));
      if (tied.is_constrained(dof) || dof == driven_dof_) continue;
      tied.add_line(dof);
      if (component != 1) tied.add_entry(dof, driven_dof_, 1.0);  // along x: scaled by set_drive_tilt
    }
  // A rank sees the boundary and the coarser neighbours of its own and its ghost cells only; a node at the
  // edge of its sight may be constrained by what lies beyond.
  if (dealii::Utilities::MPI::n_mpi_processes(communicator_) > 1)
    tied.make_consistent_in_parallel(owned, tied.get_local_lines(), communicator_);
  tied.close();
  return result;
}

dealii::AffineConstraints<double> MeshLevel::constrain(const dealii::AffineConstraints<double>& tied,
                                                       DriveShares& shares) const {
  dealii::AffineConstraints<double> constraints(tied.get_local_lines());
  shares.along_z.emplace_back(driven_dof_, 1.0);
  for (const auto& line : tied.get_lines()) {
    constraints.add_line(line.index);
    for (const auto& [master, weight] : line.entries) {
      if (master != driven_dof_)
        constraints.add_entry(line.index, master, weight);
      else if (line.index % 3 == 0)
        shares.along_x[line.index] = weight;
      else {
        shares.along_z.emplace_back(line.index, weight);
        if (control_ == Control::force) constraints.add_entry(line.index, master, weight);
      }
    }
  }
  if (control_ == Control::displacement) constraints.add_line(driven_dof_);
  constraints.close();
  return constraints;
}

void MeshLevel::make_partitioner(const dealii::IndexSet& relevant,
                                 const dealii::AffineConstraints<double>& tied) {
  // The masters of constraints must be at hand wherever the constrained node is.
  // Collected in order: an index set moves its ranges for each index that it gets among them.
  std::set<global_dof_index> others;
  const auto add_node_of = [&](global_dof_index dof) {
    if (relevant.is_element(dof)) return;
    for (global_dof_index c = 0; c < 3; ++c) others.insert(dof - dof % 3 + c);
  };
  for (const auto& line : tied.get_lines()) {
    add_node_of(line.index);
    for (const auto& entry : line.entries) add_node_of(entry.first);
  }
  dealii::IndexSet needed = relevant;
  needed.add_indices(others.begin(), others.end());
  needed.compress();
  partitioner_ = std::make_shared<dealii::Utilities::MPI::Partitioner>(dofs().locally_owned_dofs(), needed,
                                                                       communicator_);
}

void MeshLevel::fill_arrays(const dealii::AffineConstraints<double>& constraints, const DriveShares& shares) {
  const auto local = [&](global_dof_index dof) {
    return static_cast<int>(partitioner_->global_to_local(dof));
  };
  for (const auto& [dof, weight] : shares.along_z) share_along_z_.emplace_back(local(dof), weight);
  for (const auto& [dof, weight] : shares.along_x) share_along_x_.emplace_back(local(dof), weight);
  driven_share_ = share_along_z_;
  for (const auto& line : constraints.get_lines()) {
    lines_.add_line(local(line.index));
    for (const auto& [master, weight] : line.entries) lines_.add_entry(local(master), weight);
    const auto tilted = shares.along_x.find(line.index);
    if (tilted != shares.along_x.end() && control_ == Control::force)
      tilted_entry_.emplace_back(lines_.add_entry(local(driven_dof_), 0), tilted->second);
  }
  const std::vector<int> number = lines_.finish();
  for (auto& [entry, share] : tilted_entry_) entry = number[entry];
}

void MeshLevel::set_drive_tilt(double tilt) {
  for (const auto& [entry, share] : tilted_entry_) lines_.set_weight(entry, tilt * share);
  driven_share_ = share_along_z_;
  for (const auto& [dof, share] : share_along_x_) driven_share_.emplace_back(dof, tilt * share);
}

}  // namespace asperity::fem
