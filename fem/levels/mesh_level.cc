#include "fem/levels/mesh_level.h"

#include <deal.II/base/index_set.h>
#include <deal.II/base/multithread_info.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/tria_accessor.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.h"

namespace asperity::fem {

using dealii::types::global_dof_index;

MeshLevel::MeshLevel(const dealii::Triangulation<3>& triangulation, Control control, MPI_Comm communicator)
    : communicator_(communicator),
      element_(dealii::FE_Q<3>(1), 3),
      control_(control),
      triangulation_(&triangulation),
      size_(dofs().n_dofs()) {
  make_constraints();
  make_batches();
  make_thread_runs();
  collect_interfaces();
}

const dealii::DoFHandler<3>& MeshLevel::dofs() const {
  if (!dofs_) {
    dofs_ = std::make_unique<dealii::DoFHandler<3>>(*triangulation_);
    dofs_->distribute_dofs(element_);
  }
  return *dofs_;
}

void MeshLevel::release_cells() {
  dofs_.reset();
  triangulation_ = nullptr;
  place_of_cell_ = {};
}

void MeshLevel::add_to_batch(const Cell& cell, int index) {
  CellBatch& batch = batches_[index];
  std::vector<global_dof_index> indices(3 * vertices_per_hex);
  cell->get_dof_indices(indices);
  for (std::size_t v = 0; v < vertices_per_hex; ++v) {
    const unsigned local = partitioner_->global_to_local(indices[3 * v]);
    if (local % 3 != 0 || indices[3 * v + 2] != indices[3 * v] + 2)
      throw WorkError(
          "the unknowns of a node are not numbered together; this build of deal.II is not supported");
    batch.node[v][batch.count] = static_cast<int>(local / 3);
  }
  batch.body[batch.count] = batch.material[batch.count] = static_cast<unsigned char>(cell->material_id());
  place_of_cell_[cell->active_cell_index()] = lanes * index + batch.count++;
}

void MeshLevel::make_batches() {
  place_of_cell_.assign(dofs().get_triangulation().n_active_cells(), -1);
  const auto children_are_here = [](const auto& parent) {
    for (unsigned c = 0; c < parent->n_children(); ++c)
      if (!parent->child(c)->is_active() || !parent->child(c)->is_locally_owned()) return false;
    return true;
  };
  int open = -1;  // the batch that single cells are added to
  for (const auto& cell : dofs().active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    if (cell->level() > 0 && children_are_here(cell->parent())) {
      const auto parent = cell->parent();
      if (place_of_cell_[cell->active_cell_index()] >= 0) continue;
      batches_.emplace_back();
      for (unsigned c = 0; c < parent->n_children(); ++c)
        add_to_batch(Cell(parent->child(c)), static_cast<int>(batches_.size()) - 1);
      continue;
    }
    if (open < 0 || batches_[open].count == lanes) {
      open = static_cast<int>(batches_.size());
      batches_.emplace_back();
    }
    add_to_batch(cell, open);
  }
  batches_.shrink_to_fit();
  if (open < 0) return;
  CellBatch& last = batches_[open];
  for (int l = last.count; l < lanes; ++l) {
    for (auto& nodes : last.node) nodes[l] = nodes[0];
    last.body[l] = last.body[0];
    last.material[l] = last.material[0];
  }
}

void MeshLevel::take_films(const meshing::RoughGeometry& geometry, const CellMaterials& materials) {
  if (!materials.has_films()) return;
  for (const auto& cell : dofs().active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    const auto [index, lane] = place_of(cell->active_cell_index());
    CellBatch& batch = batches_[index];
    const int body = batch.body[lane];
    batch.material[lane] =
        materials.number(body, geometry.film_share(meshing::logical_box(cell), materials.thickness()[body]));
  }
  for (CellBatch& batch : batches_)
    for (int l = batch.count; l < lanes; ++l) batch.material[l] = batch.material[0];
}

std::vector<int> MeshLevel::slabs_of_batches(const std::vector<int>& batches, int slabs, int axis) const {
  std::vector<double> place(batches_.size(), 0);
  for (const auto& cell : dofs().active_cell_iterators())
    if (cell->is_locally_owned()) {
      const int batch = place_of_cell_[cell->active_cell_index()] / lanes;
      place[batch] += cell->center()[axis] / batches_[batch].count;
    }
  std::vector<int> order(batches.size()), slab(batches.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return place[batches[a]] < place[batches[b]]; });
  for (std::size_t rank = 0; rank < order.size(); ++rank)
    slab[order[rank]] = static_cast<int>(rank * static_cast<std::size_t>(slabs) / order.size());
  return slab;
}

std::vector<int> MeshLevel::add_round(const std::vector<int>& batches, int runs, int axis) {
  const std::vector<int> run_of_batch = slabs_of_batches(batches, runs, axis);
  // A node belongs to the first run that touches it; what another run has at it waits.
  std::vector<int> run_of_node(partitioner_->locally_owned_size() / 3 + partitioner_->n_ghost_indices() / 3,
                               runs);
  for (std::size_t k = 0; k < batches.size(); ++k)
    for (const auto& nodes : batches_[batches[k]].node)
      for (const int node : nodes) run_of_node[node] = std::min(run_of_node[node], run_of_batch[k]);
  const auto waits = [&](std::size_t k) {
    for (const auto& nodes : batches_[batches[k]].node)
      for (const int node : nodes)
        if (run_of_node[node] != run_of_batch[k]) return true;
    return false;
  };
  std::vector<int> round{static_cast<int>(ordered_batches_.size())}, waiting;
  for (int run = 0; run < runs; ++run) {
    for (std::size_t k = 0; k < batches.size(); ++k)
      if (run_of_batch[k] == run) (waits(k) ? waiting : ordered_batches_).push_back(batches[k]);
    round.push_back(static_cast<int>(ordered_batches_.size()));
  }
  rounds_.push_back(std::move(round));
  return waiting;
}

void MeshLevel::make_thread_runs() {
  // What meets across the slabs of one axis is a layer, of which slabs along the next axis leave a line.
  constexpr std::size_t worth_threads = 40;
  std::vector<int> left(batches_.size());
  std::iota(left.begin(), left.end(), 0);
  for (int axis = 0; axis < 3 && left.size() >= worth_threads; ++axis)
    left = add_round(left, static_cast<int>(dealii::MultithreadInfo::n_threads()), axis);
  if (!left.empty()) add_round(left, 1, 0);
}

void MeshLevel::collect_interfaces() {
  std::vector<InterfaceFace> own;
  std::vector<global_dof_index> indices(24);
  for (const auto& cell : dofs().active_cell_iterators()) {
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
      for (std::size_t v = 0; v < 4; ++v)
        face.node[v] = static_cast<long>(indices[3 * (v + (f == 5 ? 4 : 0))] / 3);
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
  interface_faces_.shrink_to_fit();
  std::sort(interface_faces_.begin(), interface_faces_.end(), [](const auto& a, const auto& b) {
    return std::array<int, 3>{a.body, a.j, a.i} < std::array<int, 3>{b.body, b.j, b.i};
  });
}

Vector<double> MeshLevel::node_positions(const meshing::RoughGeometry& geometry) const {
  Vector<double> positions(partitioner_);
  std::vector<global_dof_index> indices(24);
  for (const auto& cell : dofs().active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    cell->get_dof_indices(indices);
    const auto box = meshing::logical_box(cell);
    for (std::size_t v = 0; v < vertices_per_hex; ++v) {
      if (!partitioner_->in_local_range(indices[3 * v])) continue;
      const auto p = geometry.position(box.tree, box.vertex(static_cast<int>(v)));
      for (std::size_t c = 0; c < 3; ++c) positions(indices[3 * v + c]) = p[c];
    }
  }
  // Hanging nodes lie on the edge or face of their coarser neighbour, so that the bodies have no gaps inside.
  dealii::AffineConstraints<double> hanging(partitioner_->ghost_indices());
  dealii::IndexSet relevant = partitioner_->locally_owned_range();
  relevant.add_indices(partitioner_->ghost_indices());
  hanging.reinit(relevant);
  dealii::DoFTools::make_hanging_node_constraints(dofs(), hanging);
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

}  // namespace asperity::fem
