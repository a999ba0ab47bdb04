#include "fem/levels/mesh_level.h"

#include <deal.II/base/index_set.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/tria_accessor.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.h"

namespace asperity::fem {

using dealii::types::global_dof_index;

MeshLevel::MeshLevel(const dealii::Triangulation<3>& triangulation, Control control)
    : communicator_(triangulation.get_communicator()),
      element_(dealii::FE_Q<3>(1), 3),
      dofs_(std::make_unique<dealii::DoFHandler<3>>(triangulation)) {
  dofs_->distribute_dofs(element_);
  make_constraints(control);
  make_batches();
  make_thread_runs();
  collect_interfaces();
}

void MeshLevel::make_constraints(Control control) {
  dealii::IndexSet relevant;
  dealii::DoFTools::extract_locally_relevant_dofs(*dofs_, relevant);
  const dealii::IndexSet& owned = dofs_->locally_owned_dofs();
  first_owned_ = owned.n_elements() ? owned.nth_index_in_set(0) : 0;

  const auto boundary_dofs = [&](unsigned id, int component) {
    dealii::ComponentMask mask(3, false);
    mask.set(component, true);
    return dealii::DoFTools::extract_boundary_dofs(*dofs_, mask,
                                                   {static_cast<dealii::types::boundary_id>(id)});
  };
  const dealii::IndexSet driven = boundary_dofs(meshing::driven_boundary, 2);
  global_dof_index lowest = dealii::numbers::invalid_dof_index;
  for (const auto dof : driven)
    if (owned.is_element(dof)) lowest = std::min(lowest, dof);
  driven_dof_ = dealii::Utilities::MPI::min(lowest, communicator_);
  relevant.add_range(driven_dof_ - 2, driven_dof_ + 1);
  relevant.compress();

  // Nodes of the driven plane follow one of them, hanging nodes their masters, whatever the control.
  dealii::AffineConstraints<double> tied(relevant);
  dealii::DoFTools::make_hanging_node_constraints(*dofs_, tied);
  for (int component = 0; component < 3; ++component)
    for (const auto dof : boundary_dofs(meshing::fixed_boundary, component))
      if (!tied.is_constrained(dof)) {
        if (component == 2 && owned.is_element(dof)) fixed_z_.push_back(static_cast<int>(dof - first_owned_));
        tied.add_line(dof);
      }
  for (int component = 0; component < 3; ++component)
    for (const auto dof : boundary_dofs(meshing::driven_boundary, component)) {
      if (component == 2 && owned.is_element(dof))
        driven_nodes_.push_back(static_cast<int>((dof - first_owned_) / 3));
      if (tied.is_constrained(dof) || dof == driven_dof_) continue;
      tied.add_line(dof);
      if (component != 1) tied.add_entry(dof, driven_dof_, 1.0);  // along x: scaled by set_drive_tilt
    }
  // A rank sees the boundary and the coarser neighbours of its own and its ghost cells only; a node at the
  // edge of its sight may be constrained by what lies beyond.
  if (dealii::Utilities::MPI::n_mpi_processes(communicator_) > 1)
    tied.make_consistent_in_parallel(owned, tied.get_local_lines(), communicator_);
  tied.close();

  // Displacement control takes the plane's common displacement out of the unknowns; how much of it each node
  // gets is kept.
  std::vector<std::pair<global_dof_index, double>> along_z{{driven_dof_, 1.0}};
  std::map<global_dof_index, double> along_x;
  constraints_.reinit(relevant);
  for (const auto& line : tied.get_lines()) {
    constraints_.add_line(line.index);
    for (const auto& [master, weight] : line.entries) {
      if (master != driven_dof_)
        constraints_.add_entry(line.index, master, weight);
      else if (line.index % 3 == 0)
        along_x[line.index] = weight;
      else {
        along_z.emplace_back(line.index, weight);
        if (control == Control::force) constraints_.add_entry(line.index, master, weight);
      }
    }
  }
  if (control == Control::displacement) constraints_.add_line(driven_dof_);
  constraints_.close();
  // The masters of constraints must be at hand wherever the constrained node is.
  dealii::IndexSet needed = relevant;
  for (const auto& line : tied.get_lines()) {
    needed.add_range(line.index - line.index % 3, line.index - line.index % 3 + 3);
    for (const auto& entry : line.entries)
      needed.add_range(entry.first - entry.first % 3, entry.first - entry.first % 3 + 3);
  }
  needed.compress();
  partitioner_ = std::make_shared<dealii::Utilities::MPI::Partitioner>(owned, needed, communicator_);

  for (const auto& [dof, weight] : along_z)
    share_along_z_.emplace_back(static_cast<int>(partitioner_->global_to_local(dof)), weight);
  for (const auto& [dof, weight] : along_x)
    share_along_x_.emplace_back(static_cast<int>(partitioner_->global_to_local(dof)), weight);
  driven_share_ = share_along_z_;
  entry_start_.push_back(0);
  for (const auto& line : constraints_.get_lines()) {
    constrained_.push_back(static_cast<int>(partitioner_->global_to_local(line.index)));
    for (const auto& [master, weight] : line.entries) {
      entry_dof_.push_back(static_cast<int>(partitioner_->global_to_local(master)));
      entry_weight_.push_back(weight);
    }
    const auto tilted = along_x.find(line.index);
    if (tilted != along_x.end() && control == Control::force) {
      tilted_entry_.emplace_back(static_cast<int>(entry_dof_.size()), tilted->second);
      entry_dof_.push_back(static_cast<int>(partitioner_->global_to_local(driven_dof_)));
      entry_weight_.push_back(0);
    }
    entry_start_.push_back(static_cast<int>(entry_dof_.size()));
  }
}

void MeshLevel::set_drive_tilt(double tilt) {
  for (const auto& [entry, share] : tilted_entry_) entry_weight_[entry] = tilt * share;
  driven_share_ = share_along_z_;
  for (const auto& [dof, share] : share_along_x_) driven_share_.emplace_back(dof, tilt * share);
}

void MeshLevel::make_batches() {
  std::vector<global_dof_index> indices(24);
  for (const auto& cell : dofs_->active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    cell->get_dof_indices(indices);
    if (batches_.empty() || batches_.back().count == lanes) batches_.emplace_back();
    CellBatch& batch = batches_.back();
    for (int v = 0; v < vertices_per_hex; ++v) {
      const unsigned local = partitioner_->global_to_local(indices[3 * v]);
      if (local % 3 != 0 || indices[3 * v + 2] != indices[3 * v] + 2)
        throw WorkError(
            "the unknowns of a node are not numbered together; this build of deal.II is not supported");
      batch.node[v][batch.count] = static_cast<int>(local / 3);
    }
    batch.body[batch.count++] = static_cast<unsigned char>(cell->material_id());
  }
  if (!batches_.empty())
    for (int l = batches_.back().count; l < lanes; ++l) {
      for (auto& nodes : batches_.back().node) nodes[l] = nodes[0];
      batches_.back().body[l] = batches_.back().body[0];
    }
}

void MeshLevel::make_thread_runs() {
  const int count = static_cast<int>(batches_.size());
  const int runs = count < 200 ? 1 : omp_get_max_threads();
  std::vector<int> run_of_node(partitioner_->locally_owned_size() / 3 + partitioner_->n_ghost_indices() / 3,
                               -1);
  constexpr int shared = -2;
  const auto run_of_batch = [&](int b) { return static_cast<int>(static_cast<long>(b) * runs / count); };
  for (int b = 0; b < count; ++b)
    for (const auto& nodes : batches_[b].node)
      for (const int node : nodes) {
        int& run = run_of_node[node];
        if (run == -1)
          run = run_of_batch(b);
        else if (run != run_of_batch(b))
          run = shared;
      }
  run_start_.assign(1, 0);
  for (int run = 0; run < runs; ++run) {
    for (int b = 0; b < count; ++b) {
      if (run_of_batch(b) != run) continue;
      bool meets = false;
      for (const auto& nodes : batches_[b].node)
        for (const int node : nodes) meets = meets || run_of_node[node] == shared;
      (meets ? meeting_batches_ : run_batches_).push_back(b);
    }
    run_start_.push_back(static_cast<int>(run_batches_.size()));
  }
}

void MeshLevel::collect_interfaces() {
  std::vector<InterfaceFace> own;
  std::vector<global_dof_index> indices(24);
  for (const auto& cell : dofs_->active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    for (const unsigned f : {4u, 5u}) {
      if (!cell->face(f)->at_boundary()) continue;
      const unsigned id = cell->face(f)->boundary_id();
      if (id != meshing::interface_particle && id != meshing::interface_substrate) continue;
      cell->get_dof_indices(indices);
      const auto box = meshing::logical_box(cell);
      const double unit = std::pow(2.0, lattice_bits);
      InterfaceFace face{id == meshing::interface_particle ? 0 : 1,
                         static_cast<int>(std::lround(box.corner[0] * unit)),
                         static_cast<int>(std::lround(box.corner[1] * unit)),
                         static_cast<int>(std::lround(box.size * unit)),
                         {}};
      for (int v = 0; v < 4; ++v) face.node[v] = static_cast<long>(indices[3 * (v + (f == 5 ? 4 : 0))] / 3);
      own.push_back(face);
    }
  }
  for (const auto& part :
       dealii::Utilities::MPI::n_mpi_processes(communicator_) == 1
           ? std::vector<std::vector<InterfaceFace>>{own}
           : [&] {
               // plain data travels as longs
               std::vector<long> packed;
               for (const auto& f : own)
                 packed.insert(packed.end(),
                               {f.body, f.i, f.j, f.size, f.node[0], f.node[1], f.node[2], f.node[3]});
               std::vector<std::vector<InterfaceFace>> parts;
               for (const auto& data : dealii::Utilities::MPI::all_gather(communicator_, packed)) {
                 parts.emplace_back();
                 for (std::size_t k = 0; k + 8 <= data.size(); k += 8)
                   parts.back().push_back({static_cast<int>(data[k]),
                                           static_cast<int>(data[k + 1]),
                                           static_cast<int>(data[k + 2]),
                                           static_cast<int>(data[k + 3]),
                                           {data[k + 4], data[k + 5], data[k + 6], data[k + 7]}});
               }
               return parts;
             }())
    interface_faces_.insert(interface_faces_.end(), part.begin(), part.end());
  std::sort(interface_faces_.begin(), interface_faces_.end(), [](const auto& a, const auto& b) {
    return std::array<int, 3>{a.body, a.j, a.i} < std::array<int, 3>{b.body, b.j, b.i};
  });
}

Vector<double> MeshLevel::node_positions(const meshing::RoughGeometry& geometry) const {
  Vector<double> positions(partitioner_);
  std::vector<global_dof_index> indices(24);
  for (const auto& cell : dofs_->active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    cell->get_dof_indices(indices);
    const auto box = meshing::logical_box(cell);
    for (int v = 0; v < vertices_per_hex; ++v) {
      if (!partitioner_->in_local_range(indices[3 * v])) continue;
      const auto p = geometry.position(box.tree, box.vertex(v));
      for (int c = 0; c < 3; ++c) positions(indices[3 * v + c]) = p[c];
    }
  }
  // Hanging nodes lie on the edge or face of their coarser neighbour, so that the bodies have no gaps inside.
  dealii::AffineConstraints<double> hanging(partitioner_->ghost_indices());
  dealii::IndexSet relevant = partitioner_->locally_owned_range();
  relevant.add_indices(partitioner_->ghost_indices());
  hanging.reinit(relevant);
  dealii::DoFTools::make_hanging_node_constraints(*dofs_, hanging);
  hanging.close();
  positions.update_ghost_values();
  Vector<double> fixed = positions;
  for (const auto& line : hanging.get_lines()) {
    if (!partitioner_->in_local_range(line.index)) continue;
    double sum = 0;
    for (const auto& [master, weight] : line.entries) sum += weight * positions(master);
    fixed(line.index) = sum;
  }
  fixed.update_ghost_values();
  return fixed;
}

void MeshLevel::condense_diagonal(double* y) const {
  for (std::size_t c = 0; c < constrained_.size(); ++c) {
    const double value = y[constrained_[c]];
    y[constrained_[c]] = 0;
    for (int e = entry_start_[c]; e < entry_start_[c + 1]; ++e)
      y[entry_dof_[e]] += entry_weight_[e] * entry_weight_[e] * value;
  }
}

}  // namespace asperity::fem
