#include "meshing/triangles/gap_query.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Side_of_triangle_mesh.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "meshing/triangles/cgal_mesh.h"

namespace asperity::meshing {

namespace {

using Primitive = CGAL::AABB_face_graph_triangle_primitive<CgalMesh>;
using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
using SideOfMesh = CGAL::Side_of_triangle_mesh<CgalMesh, Kernel, CGAL::Default, AabbTree>;

constexpr double missed = std::numeric_limits<double>::quiet_NaN();

/// z of a plane through three points at the vertical line through (x, y), in coordinates relative to it:
/// exact to rounding of the heights, where CGAL's construction of line and plane loses digits. NaN for a
/// vertical plane.
double height_at(const Kernel::Point_3& a, const Kernel::Point_3& b, const Kernel::Point_3& c, double x,
                 double y) {
  const double ax = a.x() - x, ay = a.y() - y, bx = b.x() - x, by = b.y() - y, cx = c.x() - x, cy = c.y() - y;
  const double weight_a = bx * cy - by * cx, weight_b = cx * ay - cy * ax, weight_c = ax * by - ay * bx;
  const double height =
      (weight_a * a.z() + weight_b * b.z() + weight_c * c.z()) / (weight_a + weight_b + weight_c);
  if (!std::isfinite(height)) return missed;
  const auto [lowest, highest] = std::minmax({a.z(), b.z(), c.z()});
  return std::clamp(height, lowest, highest);  // where a steep triangle leaves the weights to rounding
}

}  // namespace

struct SurfaceQuery::Tree {
  explicit Tree(const TriangleSurface& surface)
      : mesh(cgal_mesh(surface)),
        closed(CGAL::is_closed(mesh)),
        aabb(faces(mesh).first, faces(mesh).second, mesh) {
    aabb.build();
    aabb.accelerate_distance_queries();
    if (closed) side = std::make_unique<SideOfMesh>(aabb);
  }

  /// Calls visit(z in nm) for the heights at which the vertical line meets each triangle it hits.
  template <class Visit>
  void for_each_height(double x, double y, const Visit& visit) const {
    const Kernel::Point_3 foot(x, y, 0);
    const Kernel::Line_3 line(foot, Kernel::Vector_3(0, 0, 1));
    std::vector<CgalMesh::Face_index> hit;
    aabb.all_intersected_primitives(line, std::back_inserter(hit));
    for (const auto face : hit) {
      std::array<Kernel::Point_3, 3> corner;
      int index = 0;
      for (const auto vertex : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
        corner[index++] = mesh.point(vertex);
      const double height = height_at(corner[0], corner[1], corner[2], x, y);
      if (!std::isnan(height)) {
        visit(height);
      } else {  // a vertical triangle: the line runs within it
        const auto crossing = CGAL::intersection(line, Kernel::Triangle_3(corner[0], corner[1], corner[2]));
        if (!crossing) continue;
        if (const auto* point = boost::get<Kernel::Point_3>(&*crossing)) visit(point->z());
        if (const auto* segment = boost::get<Kernel::Segment_3>(&*crossing)) {
          visit(segment->source().z());
          visit(segment->target().z());
        }
      }
    }
  }

  CgalMesh mesh;
  bool closed;
  AabbTree aabb;
  std::unique_ptr<SideOfMesh> side;
};

SurfaceQuery::SurfaceQuery(const TriangleSurface& surface) {
  if (surface.triangles.empty())
    throw InputError("gaps cannot be measured on a surface without triangles; pass one that has some");
  tree_ = std::make_unique<Tree>(surface);
}
SurfaceQuery::~SurfaceQuery() = default;
SurfaceQuery::SurfaceQuery(SurfaceQuery&&) noexcept = default;
SurfaceQuery& SurfaceQuery::operator=(SurfaceQuery&&) noexcept = default;

bool SurfaceQuery::closed() const { return tree_->closed; }

double SurfaceQuery::distance(const Point& point) const {
  return std::sqrt(tree_->aabb.squared_distance(to_nm(point))) / metre_in_nm;
}

double SurfaceQuery::signed_distance(const Point& point) const {
  if (!tree_->closed)
    throw InputError(
        "a signed distance needs a closed surface, but this one has open edges; ask for the plain distance");
  const bool inside = (*tree_->side)(to_nm(point)) == CGAL::ON_BOUNDED_SIDE;
  return inside ? -distance(point) : distance(point);
}

Point SurfaceQuery::nearest_point(const Point& point) const {
  return from_nm(tree_->aabb.closest_point(to_nm(point)));
}

double SurfaceQuery::lowest_z(double x, double y) const {
  double lowest = missed;
  tree_->for_each_height(x * metre_in_nm, y * metre_in_nm, [&](double z) { lowest = std::fmin(lowest, z); });
  return lowest / metre_in_nm;
}

double SurfaceQuery::highest_z(double x, double y) const {
  double highest = missed;
  tree_->for_each_height(x * metre_in_nm, y * metre_in_nm,
                         [&](double z) { highest = std::fmax(highest, z); });
  return highest / metre_in_nm;
}

namespace {

/// query(i) for i < count on all threads. Queries that may throw are checked before.
template <class Query>
std::vector<double> in_parallel(std::size_t count, const Query& query) {
  std::vector<double> results(count);
#pragma omp parallel for schedule(dynamic, 256)
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(count); ++i) results[i] = query(i);
  return results;
}

}  // namespace

std::vector<double> SurfaceQuery::distances(const std::vector<Point>& points) const {
  return in_parallel(points.size(), [&](std::size_t i) { return distance(points[i]); });
}

std::vector<double> SurfaceQuery::signed_distances(const std::vector<Point>& points) const {
  if (!points.empty()) signed_distance(points.front());
  return in_parallel(points.size(), [&](std::size_t i) { return signed_distance(points[i]); });
}

std::vector<double> vertical_gaps(const SurfaceQuery& lower, const SurfaceQuery& upper,
                                  const std::vector<std::array<double, 2>>& places) {
  return in_parallel(places.size(), [&](std::size_t i) {
    return upper.lowest_z(places[i][0], places[i][1]) - lower.highest_z(places[i][0], places[i][1]);
  });
}

double shift_to_first_contact(const std::vector<double>& gaps) {
  double smallest = missed;
  for (const double gap : gaps) smallest = std::fmin(smallest, gap);
  if (std::isnan(smallest))
    throw InputError("the two surfaces face each other nowhere; place one above the other");
  return -smallest;
}

}  // namespace asperity::meshing
