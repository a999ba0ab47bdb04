#include "fem/levels/boundary_surface.h"

#include <deal.II/grid/tria_accessor.h>

namespace asperity::fem {

meshing::TriangleSurface boundary_surface(const MeshLevel& level, const Vector<double>& positions,
                                          meshing::Body body) {
  // Vertices of each face of a cell in deal.II's order, counter-clockwise seen from outside.
  static constexpr int outward[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                        {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  const std::size_t nodes =
      (level.partitioner()->locally_owned_size() + level.partitioner()->n_ghost_indices()) / 3;
  std::vector<meshing::Point> points(nodes);
  const double* x = positions.begin();
  for (std::size_t n = 0; n < nodes; ++n) points[n] = {x[3 * n], x[3 * n + 1], x[3 * n + 2]};

  std::vector<meshing::QuadIndices> quads;
  for (const auto& cell : level.dofs().active_cell_iterators()) {
    if (!cell->is_locally_owned()) continue;
    const auto [number, lane] = level.place_of(cell->active_cell_index());
    const CellBatch& batch = level.batches()[number];
    if (static_cast<meshing::Body>(batch.body[lane]) != body) continue;
    for (const unsigned f : cell->face_indices()) {
      if (!cell->face(f)->at_boundary()) continue;
      meshing::QuadIndices quad;
      for (int v = 0; v < 4; ++v) quad[v] = static_cast<std::uint32_t>(batch.node[outward[f][v]][lane]);
      quads.push_back(quad);
    }
  }
  return meshing::triangles_of_quads(points, quads);
}

}  // namespace asperity::fem
