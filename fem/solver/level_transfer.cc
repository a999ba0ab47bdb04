#include "fem/solver/level_transfer.h"

#include <deal.II/base/mpi.h>
#include <deal.II/grid/tria_accessor.h>

#include <array>
#include <cmath>
#include <map>
#include <unordered_map>

#include "core/error.h"
#include "core/threads.h"

namespace asperity::fem {
namespace {

// Some microseconds of work.
constexpr int nodes_of_a_part = 2000;

using dealii::types::global_dof_index;

using meshing::cell_key;
using meshing::LogicalBox;
using meshing::parent_of;

using CellNodes = std::array<long, 8>;

template <typename Visit>
void for_owned_cells(const MeshLevel& level, const Visit& visit) {
  std::vector<global_dof_index> indices(24);
  for (const auto& cell : level.dofs().active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    cell->get_dof_indices(indices);
    CellNodes nodes;
    for (std::size_t v = 0; v < 8; ++v) nodes[v] = static_cast<long>(indices[3 * v] / 3);
    visit(meshing::logical_box(cell), nodes);
  }
}

/// Nodes of the coarse cells that the own fine cells lie in, fetched from whichever rank owns them.
class CoarseCells {
 public:
  CoarseCells(const MeshLevel& fine, const MeshLevel& coarse) {
    using dealii::Utilities::MPI::some_to_some;
    const MPI_Comm comm = coarse.communicator();
    const unsigned ranks = dealii::Utilities::MPI::n_mpi_processes(comm);
    if (ranks == 1) {
      for_owned_cells(coarse,
                      [&](const LogicalBox& box, const CellNodes& nodes) { found_[cell_key(box)] = nodes; });
      return;
    }
    const auto directory = [&](std::uint64_t key) {
      return static_cast<unsigned>((key * 0x9E3779B97F4A7C15ull >> 32) % ranks);
    };
    std::map<unsigned, std::vector<long>> announced, asked;
    for_owned_cells(coarse, [&](const LogicalBox& box, const CellNodes& nodes) {
      const meshing::CellKey key = cell_key(box);
      auto& message = announced[directory(key)];
      message.push_back(static_cast<long>(key));
      message.insert(message.end(), nodes.begin(), nodes.end());
    });
    for_owned_cells(fine, [&](const LogicalBox& box, const CellNodes&) {
      for (const auto k : {cell_key(box), cell_key(parent_of(box))})
        asked[directory(k)].push_back(static_cast<long>(k));
    });
    std::unordered_map<std::uint64_t, CellNodes> entries;
    const auto unpack = [](const std::vector<long>& message, auto& map) {
      for (std::size_t at = 0; at + 9 <= message.size(); at += 9) {
        CellNodes nodes;
        std::copy(message.begin() + at + 1, message.begin() + at + 9, nodes.begin());
        map[static_cast<std::uint64_t>(message[at])] = nodes;
      }
    };
    for (const auto& [rank, message] : some_to_some(comm, announced)) unpack(message, entries);
    std::map<unsigned, std::vector<long>> answers;
    for (const auto& [rank, keys] : some_to_some(comm, asked))
      for (const long key : keys) {
        const auto entry = entries.find(static_cast<std::uint64_t>(key));
        if (entry == entries.end()) continue;
        answers[rank].push_back(key);
        answers[rank].insert(answers[rank].end(), entry->second.begin(), entry->second.end());
      }
    for (const auto& [rank, message] : some_to_some(comm, answers)) unpack(message, found_);
  }
  const CellNodes* find(std::uint64_t key) const {
    const auto cell = found_.find(key);
    return cell == found_.end() ? nullptr : &cell->second;
  }

 private:
  std::unordered_map<std::uint64_t, CellNodes> found_;
};

/// Owned nodes without a row of their own: hanging nodes follow from the others.
std::vector<char> nodes_without_row(const MeshLevel& fine) {
  std::vector<char> without(fine.partitioner()->locally_owned_size() / 3, 0);
  for (const int dof : fine.constrained())
    if (dof % 3 == 0 && dof / 3 < static_cast<int>(without.size())) without[dof / 3] = 1;
  // Nodes of the driven plane have their lateral components constrained but may move along z.
  for (const int node : fine.driven_nodes()) without[node] = 0;
  return without;
}

}  // namespace

LevelTransfer::LevelTransfer(const MeshLevel& fine, const MeshLevel& coarse)
    : coarse_(coarse), parallel_(dealii::Utilities::MPI::n_mpi_processes(fine.communicator()) > 1) {
  number_columns(make_rows(fine));
  transpose_rows();
}

std::vector<long> LevelTransfer::make_rows(const MeshLevel& fine) {
  const CoarseCells cells(fine, coarse_);
  const auto& layout = *fine.partitioner();
  std::vector<char> done = nodes_without_row(fine);
  std::vector<long> columns;
  const auto add_entry = [&](long node, double weight) {
    columns.push_back(node);
    rows_.weight.push_back(static_cast<float>(weight));
  };
  for_owned_cells(fine, [&](const LogicalBox& box, const CellNodes& nodes) {
    const LogicalBox parent = parent_of(box);
    const CellNodes* same = cells.find(cell_key(box));
    const CellNodes* above = same ? nullptr : cells.find(cell_key(parent));
    if (!same && !above)
      throw WorkError("a cell has no counterpart on the next coarser mesh; this is an error of the program");
    for (int v = 0; v < 8; ++v) {
      const auto dof = static_cast<global_dof_index>(3 * nodes[v]);
      if (!layout.in_local_range(dof)) continue;
      const int local = static_cast<int>(layout.global_to_local(dof) / 3);
      if (done[local]) continue;
      done[local] = 1;
      fine_node_.push_back(local);
      if (same) {
        add_entry((*same)[v], 1);
      } else {
        const auto weights = meshing::corner_weights(parent, box.vertex(v));
        for (int w = 0; w < 8; ++w)
          if (weights[w] != 0) add_entry((*above)[w], weights[w]);
      }
      rows_.start.push_back(static_cast<int>(columns.size()));
    }
  });
  fine_node_.shrink_to_fit();
  rows_.start.shrink_to_fit();
  rows_.weight.shrink_to_fit();
  return columns;
}

void LevelTransfer::number_columns(const std::vector<long>& columns) {
  dealii::IndexSet needed(coarse_.size());
  for (const long node : columns) needed.add_range(3 * node, 3 * node + 3);
  needed.compress();
  columns_ = parallel_ ? std::make_shared<dealii::Utilities::MPI::Partitioner>(
                             coarse_.partitioner()->locally_owned_range(), needed, coarse_.communicator())
                       : coarse_.partitioner();
  buffer_.reinit(columns_);
  rows_.column.reserve(columns.size());
  for (const long node : columns)
    rows_.column.push_back(static_cast<int>(columns_->global_to_local(3 * node) / 3));
}

void LevelTransfer::transpose_rows() {
  const int coarse_nodes =
      static_cast<int>((columns_->locally_owned_size() + columns_->n_ghost_indices()) / 3);
  std::vector<int> fill(coarse_nodes + 1, 0);
  for (const int c : rows_.column) ++fill[c + 1];
  for (int c = 0; c < coarse_nodes; ++c) fill[c + 1] += fill[c];
  transposed_.start = fill;
  transposed_.column.resize(rows_.column.size());
  transposed_.weight.resize(rows_.column.size());
  for (std::size_t r = 0; r < fine_node_.size(); ++r)
    for (int e = rows_.start[r]; e < rows_.start[r + 1]; ++e) {
      const int at = fill[rows_.column[e]]++;
      transposed_.column[at] = fine_node_[r];
      transposed_.weight[at] = rows_.weight[e];
    }
}

std::vector<int> LevelTransfer::new_nodes() const {
  std::vector<int> nodes;
  for (std::size_t r = 0; r < fine_node_.size(); ++r)
    if (rows_.start[r + 1] - rows_.start[r] > 1) nodes.push_back(fine_node_[r]);
  return nodes;
}

void LevelTransfer::prolongate_and_add(Vector<float>& fine, const Vector<float>& coarse) const {
  if (parallel_) coarse.update_ghost_values();
  coarse_.distribute(const_cast<float*>(coarse.begin()));
  const float* values = coarse.begin();
  if (parallel_) {
    coarse.zero_out_ghost_values();
    for (unsigned i = 0; i < buffer_.locally_owned_size(); ++i)
      buffer_.local_element(i) = coarse.local_element(i);
    buffer_.update_ghost_values();
    values = buffer_.begin();
  }
  float* x = fine.begin();
  for_parts(static_cast<int>(fine_node_.size()), nodes_of_a_part, [&](int first, int last) {
    for (int r = first; r < last; ++r) {
      float sum[3] = {0, 0, 0};
      for (int e = rows_.start[r]; e < rows_.start[r + 1]; ++e)
        for (int c = 0; c < 3; ++c) sum[c] += rows_.weight[e] * values[3 * rows_.column[e] + c];
      for (int c = 0; c < 3; ++c) x[3 * fine_node_[r] + c] += sum[c];
    }
  });
  if (parallel_) buffer_.zero_out_ghost_values();
}

void LevelTransfer::restrict_to(Vector<float>& coarse, const Vector<float>& fine) const {
  Vector<float>& target = parallel_ ? buffer_ : coarse;
  const float* r = fine.begin();
  float* y = target.begin();
  for_parts(static_cast<int>(transposed_.start.size()) - 1, nodes_of_a_part, [&](int first, int last) {
    for (int n = first; n < last; ++n) {
      float sum[3] = {0, 0, 0};
      for (int e = transposed_.start[n]; e < transposed_.start[n + 1]; ++e)
        for (int c = 0; c < 3; ++c) sum[c] += transposed_.weight[e] * r[3 * transposed_.column[e] + c];
      for (int c = 0; c < 3; ++c) y[3 * n + c] = sum[c];
    }
  });
  if (parallel_) {
    buffer_.compress(dealii::VectorOperation::add);
    coarse = 0.0f;
    for (unsigned i = 0; i < coarse.locally_owned_size(); ++i)
      coarse.local_element(i) = buffer_.local_element(i);
    // Only the owner of a hanging node passes on what it received.
    coarse.zero_out_ghost_values();
  }
  coarse_.condense(coarse.begin());
  if (parallel_) coarse.compress(dealii::VectorOperation::add);
}

}  // namespace asperity::fem
