#include "meshing/triangles/surface_check.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <unordered_map>

#include "core/error.h"
#include "meshing/triangles/cgal_failure.h"
#include "meshing/triangles/cgal_kernel.h"
#include "meshing/triangles/cgal_mesh.h"

namespace asperity::meshing {

namespace {

/// Disjoint sets of numbered things.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) {
    for (std::size_t i = 0; i < count; ++i) parent_[i] = i;
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) { parent_[root(i)] = root(j); }

 private:
  std::vector<std::size_t> parent_;
};

struct EdgeUse {
  std::uint32_t forward = 0,
                backward = 0;  ///< triangles that run from the smaller to the larger index, and back
  std::uint32_t triangle = 0;  ///< the first of them
};

std::size_t count_degenerate(const TriangleSurface& surface) {
  std::size_t count = 0;
  for (const auto& [a, b, c] : surface.triangles)
    count += CGAL::collinear(to_nm(surface.points[a]), to_nm(surface.points[b]), to_nm(surface.points[c]));
  return count;
}

}  // namespace

SurfaceCheck check_surface(const TriangleSurface& surface) {
  SurfaceCheck check;
  check.area = area(surface);
  const std::size_t triangle_count = surface.triangles.size();

  std::unordered_map<std::uint64_t, EdgeUse> edges;
  edges.reserve(2 * triangle_count);
  Sets pieces(triangle_count);
  // Corners of triangles around a point that share an edge belong to one fan; a manifold point has one fan.
  Sets fans(3 * triangle_count);
  const auto corner_at = [&](std::uint32_t triangle, std::uint32_t point) {
    const auto& corners = surface.triangles[triangle];
    return 3 * std::size_t{triangle} + (corners[0] == point ? 0 : corners[1] == point ? 1 : 2);
  };
  for (std::uint32_t triangle = 0; triangle < triangle_count; ++triangle)
    for (int side = 0; side < 3; ++side) {
      const auto from = surface.triangles[triangle][side], to = surface.triangles[triangle][(side + 1) % 3];
      auto& use = edges[std::uint64_t{std::min(from, to)} << 32 | std::max(from, to)];
      if (use.forward + use.backward == 0) {
        use.triangle = triangle;
      } else {
        pieces.join(triangle, use.triangle);
        for (const auto end : {from, to}) fans.join(corner_at(triangle, end), corner_at(use.triangle, end));
      }
      ++(from < to ? use.forward : use.backward);
    }
  for (const auto& [key, use] : edges) {
    check.boundary_edges += use.forward + use.backward == 1;
    check.non_manifold_edges += use.forward > 1 || use.backward > 1;
  }
  std::vector<std::uint32_t> fans_of_point(surface.points.size(), 0);
  for (std::size_t corner = 0; corner < 3 * triangle_count; ++corner)
    if (fans.root(corner) == corner) ++fans_of_point[surface.triangles[corner / 3][corner % 3]];
  for (const auto count : fans_of_point) check.non_manifold_vertices += count > 1;
  for (std::size_t triangle = 0; triangle < triangle_count; ++triangle)
    check.components += pieces.root(triangle) == triangle;

  check.degenerate_triangles = count_degenerate(surface);
  if (check.closed()) check.volume = volume(surface);
  if (check.manifold()) {
    const CgalMesh mesh = cgal_mesh(surface);
    using Face = CgalMesh::Face_index;
    std::vector<std::pair<Face, Face>> pairs;
    without_raw_failures("look for triangles that cross", "use another interface spacing", [&] {
      CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
    });
    check.self_intersections = pairs.size();
  }
  return check;
}

std::string SurfaceCheck::defects() const {
  std::string list;
  const auto add = [&](bool present, const std::string& defect) {
    if (present) list += (list.empty() ? "" : ", ") + defect;
  };
  const auto add_count = [&](std::size_t count, const std::string& what) {
    add(count > 0, std::to_string(count) + " " + what);
  };
  add_count(boundary_edges, "open edges");
  add_count(non_manifold_edges, "edges where triangles disagree");
  add_count(non_manifold_vertices, "points where sheets touch");
  add_count(degenerate_triangles, "triangles without area");
  add_count(self_intersections, "pairs of triangles that cross");
  add(closed() && volume <= 0, "triangles that face inward");
  return list;
}

void require_body(const SurfaceCheck& check, const std::string& what) {
  if (check.bounds_a_body()) return;
  throw InputError("the surface of " + what + " does not bound a body (" + check.defects() +
                   "); use a finer interface spacing, a smoother topography, or a closed surface");
}

}  // namespace asperity::meshing
