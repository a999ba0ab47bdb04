#include "fem/solver/smoothed_part.h"

namespace asperity::fem {
namespace {

// Marks of nodes are kept in vectors of unknowns, which exchange them between ranks: not 0 is marked.
bool is_marked(const Vector<float>& marks, int node) {
  const float* mark = marks.begin() + 3 * static_cast<std::ptrdiff_t>(node);
  return mark[0] != 0 || mark[1] != 0 || mark[2] != 0;
}

void mark(Vector<float>& marks, int node) {
  for (int c = 0; c < 3; ++c) marks.begin()[3 * static_cast<std::ptrdiff_t>(node) + c] = 1;
}

bool has_marked_node(const CellBatch& batch, int lane, const Vector<float>& marks) {
  for (const auto& nodes : batch.node)
    if (is_marked(marks, nodes[lane])) return true;
  return false;
}

}  // namespace

SmoothedPart smoothed_part(const MeshLevel& fine, const LevelTransfer& transfer) {
  Vector<float> is_new, smoothed;
  fine.initialise(is_new);
  fine.initialise(smoothed);
  for (const int node : transfer.new_nodes()) mark(is_new, node);
  is_new.update_ghost_values();
  for (const CellBatch& batch : fine.batches())
    for (int l = 0; l < batch.count; ++l)
      if (has_marked_node(batch, l, is_new))
        for (const auto& nodes : batch.node) mark(smoothed, nodes[l]);
  smoothed.compress(dealii::VectorOperation::add);
  smoothed.update_ghost_values();

  // Hanging nodes and those of the driven plane move with the nodes that they follow.
  Vector<float> moved = smoothed;
  moved.update_ghost_values();
  fine.distribute(moved.begin());
  SmoothedPart part;
  const int nodes =
      static_cast<int>((smoothed.locally_owned_size() + fine.partitioner()->n_ghost_indices()) / 3);
  for (int n = 0; n < nodes; ++n) part.node.push_back(is_marked(smoothed, n));
  for (const CellBatch& batch : fine.batches()) {
    bool here = false;
    for (int l = 0; l < batch.count; ++l)
      here = here || has_marked_node(batch, l, smoothed) || has_marked_node(batch, l, moved);
    part.batch.push_back(here);
  }
  return part;
}

}  // namespace asperity::fem
