// The surface of a body, or a height field, as triangles: what CGAL's services and other programs work on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace asperity::meshing {

using Point = std::array<double, 3>;  ///< [m]
using TriangleIndices = std::array<std::uint32_t, 3>;
using QuadIndices = std::array<std::uint32_t, 4>;  ///< in cyclic order

/// Triangles seen counter-clockwise from outside the material.
struct TriangleSurface {
  std::vector<Point> points;  ///< [m]
  std::vector<TriangleIndices> triangles;
};

/// Boundary of a hexahedral body. `quads` point outward (counter-clockwise from outside) and index `points`;
/// points no quad uses are left out. Each quad is split along the diagonal with the better triangles. Hanging
/// nodes (one per edge, as in a 2:1 balanced octree) are inserted into the coarse quad's edge, so that a
/// closed body stays closed.
/// Throws InputError for no quads, or a quad of a point that is not there.
TriangleSurface triangles_of_quads(const std::vector<Point>& points, const std::vector<QuadIndices>& quads);

/// Heights on a regular grid of nodes: heights[iy * nx + ix] at (origin_x + ix dx, origin_y + iy dy) [m].
struct HeightField {
  int nx = 0, ny = 0;
  double dx = 0, dy = 0;
  double origin_x = 0, origin_y = 0;
  std::vector<double> heights;  ///< [m]; NaN where missing
};

/// Open surface through the nodes of a height field, facing +z. Triangles with a missing node are left out.
/// It departs from bilinear interpolation by at most |z00 + z11 - z10 - z01| / 4 in each cell (at the cell's
/// centre).
/// Throws InputError for a field that is no grid, or one without a cell of three known heights.
TriangleSurface triangles_of_heights(const HeightField& field);

/// Copy shifted by a vector [m], e.g. a sphere's surface put at its approach.
TriangleSurface translated(const TriangleSurface& surface, const Point& shift);

/// Sum of the triangles' areas [m^2].
double area(const TriangleSurface& surface);

/// Volume by the divergence theorem [m^3]; positive if it faces outward; needs a closed surface.
double volume(const TriangleSurface& surface);

/// Lowest and highest coordinates.
struct BoundingBox {
  Point lower{}, upper{};  ///< [m]
};
/// Of all points of a surface.
BoundingBox bounding_box(const TriangleSurface& surface);

}  // namespace asperity::meshing
