// A triangle surface as CGAL's half-edge mesh (internal: include from .cc files only).
#pragma once

#include <CGAL/Surface_mesh.h>

#include "core/error.h"
#include "meshing/triangles/cgal_kernel.h"

namespace asperity::meshing {

using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// Face i is triangle i; coordinates in nm. Throws InputError where the surface is not manifold.
inline CgalMesh cgal_mesh(const TriangleSurface& surface) {
  CgalMesh mesh;
  const auto points = static_cast<CgalMesh::size_type>(surface.points.size());
  const auto triangles = static_cast<CgalMesh::size_type>(surface.triangles.size());
  mesh.reserve(points, points + triangles, triangles);
  for (const auto& point : surface.points) mesh.add_vertex(to_nm(point));
  using Vertex = CgalMesh::Vertex_index;
  for (const auto& [a, b, c] : surface.triangles)
    if (mesh.add_face(Vertex(a), Vertex(b), Vertex(c)) == CgalMesh::null_face())
      throw InputError("a triangle surface is not manifold at triangle " +
                       std::to_string(mesh.number_of_faces()) + "; check its orientation and its points");
  return mesh;
}

}  // namespace asperity::meshing
