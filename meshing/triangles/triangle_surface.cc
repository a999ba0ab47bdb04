#include "meshing/triangles/triangle_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/error.h"
#include "meshing/triangles/polygon_split.h"
#include "meshing/triangles/vectors.h"

namespace asperity::meshing {

namespace {

/// Drops points that no triangle uses.
TriangleSurface compact(const std::vector<Point>& points, std::vector<TriangleIndices> triangles) {
  constexpr auto unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> new_index(points.size(), unused);
  TriangleSurface surface;
  for (auto& triangle : triangles)
    for (auto& index : triangle) {
      if (new_index[index] == unused) {
        new_index[index] = static_cast<std::uint32_t>(surface.points.size());
        surface.points.push_back(points[index]);
      }
      index = new_index[index];
    }
  surface.triangles = std::move(triangles);
  return surface;
}

}  // namespace

TriangleSurface triangles_of_quads(const std::vector<Point>& points, const std::vector<QuadIndices>& quads) {
  if (quads.empty())
    throw InputError("a surface needs at least one quad, but none was given; pass the body's boundary faces");
  for (std::size_t quad = 0; quad < quads.size(); ++quad)
    for (const auto index : quads[quad])
      if (index >= points.size())
        throw InputError("quad " + std::to_string(quad) + " refers to point " + std::to_string(index) +
                         ", but there are only " + std::to_string(points.size()) +
                         "; pass the points the quads were made with");
  std::vector<TriangleIndices> triangles;
  triangles.reserve(2 * quads.size());
  for (const auto& polygon : polygons_with_hanging_nodes(points, quads))
    split_polygon(points, polygon, triangles);
  return compact(points, std::move(triangles));
}

TriangleSurface triangles_of_heights(const HeightField& field) {
  const auto node_count =
      static_cast<std::size_t>(std::max(field.nx, 0)) * static_cast<std::size_t>(std::max(field.ny, 0));
  if (field.nx < 2 || field.ny < 2 || !(field.dx > 0) || !(field.dy > 0) ||
      field.heights.size() != node_count)
    throw InputError(
        "a height field needs at least 2 x 2 nodes, positive spacing and one height per node, not " +
        std::to_string(field.nx) + " x " + std::to_string(field.ny) + " nodes with " +
        std::to_string(field.heights.size()) + " heights; check its size");
  std::vector<Point> points(node_count);
  for (int iy = 0; iy < field.ny; ++iy)
    for (int ix = 0; ix < field.nx; ++ix) {
      const std::size_t node = static_cast<std::size_t>(iy) * field.nx + ix;
      points[node] = {field.origin_x + ix * field.dx, field.origin_y + iy * field.dy, field.heights[node]};
    }
  const auto known = [&](std::uint32_t node) { return std::isfinite(field.heights[node]); };
  std::vector<TriangleIndices> triangles;
  triangles.reserve(2 * static_cast<std::size_t>(field.nx - 1) * (field.ny - 1));
  for (int iy = 0; iy + 1 < field.ny; ++iy)
    for (int ix = 0; ix + 1 < field.nx; ++ix) {
      const auto corner = static_cast<std::uint32_t>(static_cast<std::size_t>(iy) * field.nx + ix);
      const auto above = corner + static_cast<std::uint32_t>(field.nx);
      std::vector<std::uint32_t> polygon;
      for (const auto node : {corner, corner + 1, above + 1, above})
        if (known(node)) polygon.push_back(node);
      if (polygon.size() >= 3) split_polygon(points, polygon, triangles);
    }
  if (triangles.empty())
    throw InputError("the height field has no cell with three known heights; pass a less masked one");
  return compact(points, std::move(triangles));
}

TriangleSurface translated(const TriangleSurface& surface, const Point& shift) {
  TriangleSurface moved = surface;
  for (auto& point : moved.points)
    for (int axis = 0; axis < 3; ++axis) point[axis] += shift[axis];
  return moved;
}

double area(const TriangleSurface& surface) {
  double sum = 0;
  for (const auto& [a, b, c] : surface.triangles)
    sum += norm(cross(minus(surface.points[b], surface.points[a]),
                      minus(surface.points[c], surface.points[a]))) /
           2;
  return sum;
}

double volume(const TriangleSurface& surface) {
  if (surface.triangles.empty()) return 0;
  const Point& origin = surface.points[surface.triangles[0][0]];  // near the body, against cancellation
  double sum = 0;
  for (const auto& [a, b, c] : surface.triangles)
    sum += triple(minus(surface.points[a], origin), minus(surface.points[b], origin),
                  minus(surface.points[c], origin)) /
           6;
  return sum;
}

BoundingBox bounding_box(const TriangleSurface& surface) {
  if (surface.points.empty()) return {};
  BoundingBox box{surface.points[0], surface.points[0]};
  for (const auto& point : surface.points)
    for (int axis = 0; axis < 3; ++axis) {
      box.lower[axis] = std::min(box.lower[axis], point[axis]);
      box.upper[axis] = std::max(box.upper[axis], point[axis]);
    }
  return box;
}

}  // namespace asperity::meshing
