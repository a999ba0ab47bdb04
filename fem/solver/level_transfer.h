// Prolongation between two meshes of the forest (trilinear interpolation at nodes) and its transpose.
//
// deal.II's own global-coarsening transfer numbers cells in 32 bits on Debian and so ends at nine levels;
// contact at a few nm below micrometres needs more. Cells are matched here by tree and lattice position,
// through a directory spread over all ranks.
#pragma once

#include <memory>
#include <vector>

#include "fem/levels/mesh_level.h"

namespace asperity::fem {

class LevelTransfer {
 public:
  /// Throws WorkError where a cell has no counterpart on the coarser mesh.
  LevelTransfer(const MeshLevel& fine, const MeshLevel& coarse);

  /// Fine local nodes, owned here, between those of the coarse mesh.
  std::vector<int> new_nodes() const;

  /// fine += P coarse. Sets the constrained entries of `coarse` as well.
  void prolongate_and_add(Vector<float>& fine, const Vector<float>& coarse) const;
  /// coarse = C^T P^T fine (condensed).
  void restrict_to(Vector<float>& coarse, const Vector<float>& fine) const;

 private:
  /// A row for each owned node of the fine mesh that does not hang. Returns the coarse nodes, global, of all
  /// entries. Collective.
  std::vector<long> make_rows(const MeshLevel& fine);
  /// Gives the coarse nodes of all entries their local numbers. Collective.
  void number_columns(const std::vector<long>& columns);
  void transpose_rows();

  const MeshLevel& coarse_;
  bool parallel_;
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner>
      columns_;                   ///< coarse unknowns with those that rows here need
  mutable Vector<float> buffer_;  ///< in the layout of columns_
  struct Rows {
    std::vector<int> start{0}, column;
    std::vector<float> weight;
  };
  std::vector<int> fine_node_;  ///< local node of each row
  Rows rows_, transposed_;      ///< by row; by local coarse node (entries: index of the row's fine node)
};

}  // namespace asperity::fem
