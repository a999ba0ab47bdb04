// Distances and gaps measured on the triangles themselves, independent of the contact solver: they judge its
// gaps. An axis-aligned bounding box tree (CGAL AABB tree) answers in O(log n); the batch calls use all
// OpenMP threads.
#pragma once

#include <memory>
#include <vector>

#include "meshing/triangles/triangle_surface.h"

namespace asperity::meshing {

/// A surface made ready for queries. All queries are const and may run concurrently.
class SurfaceQuery {
 public:
  /// Throws InputError if the surface is empty or not manifold.
  explicit SurfaceQuery(const TriangleSurface& surface);
  ~SurfaceQuery();
  SurfaceQuery(SurfaceQuery&&) noexcept;
  SurfaceQuery& operator=(SurfaceQuery&&) noexcept;

  /// Whether the surface bounds a volume, so that distances have a sign.
  bool closed() const;

  /// Distance from a point to the nearest point of the surface [m].
  double distance(const Point& point) const;
  /// The same, negative inside the body [m]. Throws InputError if the surface is not closed.
  double signed_distance(const Point& point) const;
  /// Nearest point on the surface [m].
  Point nearest_point(const Point& point) const;
  /// Lowest and highest z where the vertical line through (x, y) meets the surface [m]; NaN where it misses.
  double lowest_z(double x, double y) const;
  double highest_z(double x, double y) const;

  /// The same for many points at once, several at a time [m].
  std::vector<double> distances(const std::vector<Point>& points) const;
  std::vector<double> signed_distances(const std::vector<Point>& points) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

/// Vertical gap at (x, y) from the top of the lower surface to the underside of the upper one [m]; negative
/// where they overlap, NaN where either is missed. Put the upper body in place with translated().
std::vector<double> vertical_gaps(const SurfaceQuery& lower, const SurfaceQuery& upper,
                                  const std::vector<std::array<double, 2>>& places);

/// Shift of the upper surface along z that makes the smallest of the gaps zero: minus the smallest gap [m].
/// NaN gaps are skipped; throws InputError if there is none left.
double shift_to_first_contact(const std::vector<double>& gaps);

}  // namespace asperity::meshing
