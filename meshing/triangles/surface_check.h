// Whether a triangle surface bounds a body: closed, manifold, outward, free of self-intersections.
// Topology is counted on the indices; self-intersections come from CGAL's Polygon mesh processing (exact
// predicates).
#pragma once

#include <cstddef>
#include <string>

#include "meshing/triangles/triangle_surface.h"

namespace asperity::meshing {

struct SurfaceCheck {
  std::size_t boundary_edges = 0;  ///< edges with one triangle
  std::size_t non_manifold_edges =
      0;  ///< edges with more than two triangles, or two that disagree in orientation
  std::size_t non_manifold_vertices = 0;  ///< points where sheets of the surface touch
  std::size_t degenerate_triangles = 0;   ///< exactly zero area
  std::size_t self_intersections = 0;     ///< pairs of triangles that cross, found if the surface is manifold
  std::size_t components = 0;             ///< connected pieces
  double area = 0;                        ///< [m^2]
  double volume = 0;                      ///< [m^3], of a closed surface

  bool manifold() const { return non_manifold_edges == 0 && non_manifold_vertices == 0; }
  bool closed() const { return boundary_edges == 0; }
  bool outward() const { return closed() && volume > 0; }
  /// All of it: fit to be meshed by tetrahedra or given to another program as a solid.
  bool bounds_a_body() const {
    return manifold() && outward() && degenerate_triangles == 0 && self_intersections == 0;
  }
  /// What keeps it from that, e.g. "3 open edges, 2 pairs of triangles that cross"; empty if nothing does.
  std::string defects() const;
};

/// Looks at all edges, corners and pairs of triangles.
SurfaceCheck check_surface(const TriangleSurface& surface);

/// Throws InputError saying what keeps the surface from bounding a body; `what` names it, e.g. "the
/// particle".
void require_body(const SurfaceCheck& check, const std::string& what);

}  // namespace asperity::meshing
