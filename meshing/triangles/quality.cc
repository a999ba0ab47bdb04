#include "meshing/triangles/quality.h"

#include <algorithm>
#include <limits>

#include "meshing/triangles/vectors.h"

namespace asperity::meshing {

namespace {

/// Ratio that calls a collapsed element 0, not NaN.
double ratio(double numerator, double denominator) { return denominator == 0 ? 0 : numerator / denominator; }

double triangle_area(const Point& a, const Point& b, const Point& c) {
  return norm(cross(minus(b, a), minus(c, a))) / 2;
}

}  // namespace

double scaled_jacobian(const std::array<Point, 8>& hexahedron) {
  // Neighbours of each corner along its three edges, in right-handed order.
  static constexpr int neighbours[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                           {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
  double smallest = std::numeric_limits<double>::infinity();
  for (int corner = 0; corner < 8; ++corner) {
    std::array<Vector, 3> edge;
    for (int direction = 0; direction < 3; ++direction)
      edge[direction] = minus(hexahedron[neighbours[corner][direction]], hexahedron[corner]);
    smallest = std::min(
        smallest, ratio(triple(edge[0], edge[1], edge[2]), norm(edge[0]) * norm(edge[1]) * norm(edge[2])));
  }
  return smallest;
}

double scaled_jacobian(const std::array<Point, 4>& tetrahedron) {
  double largest_product = 0;
  for (int corner = 0; corner < 4; ++corner) {
    double product = 1;
    for (int other = 0; other < 4; ++other)
      if (other != corner) product *= norm(minus(tetrahedron[other], tetrahedron[corner]));
    largest_product = std::max(largest_product, product);
  }
  return ratio(std::sqrt(2.) * 6 * volume(tetrahedron), largest_product);
}

double radius_ratio(const std::array<Point, 4>& tetrahedron) {
  const auto& [a, b, c, d] = tetrahedron;
  const double signed_volume = volume(tetrahedron);
  const double surface =
      triangle_area(a, b, c) + triangle_area(a, b, d) + triangle_area(a, c, d) + triangle_area(b, c, d);
  const double inradius = ratio(3 * signed_volume, surface);
  // Circumradius from the products of opposite edges (Crelle 1821): 24 V R =
  // sqrt((p+q+r)(p+q-r)(p-q+r)(-p+q+r)).
  const double p = norm(minus(b, a)) * norm(minus(d, c)), q = norm(minus(c, a)) * norm(minus(d, b)),
               r = norm(minus(d, a)) * norm(minus(c, b));
  const double product = (p + q + r) * (p + q - r) * (p - q + r) * (-p + q + r);
  const double volume_times_circumradius = std::sqrt(std::max(product, 0.)) / 24;
  return ratio(3 * inradius * std::abs(signed_volume), volume_times_circumradius);
}

double smallest_dihedral_angle(const std::array<Point, 4>& tetrahedron) {
  double smallest = M_PI;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) {
      // Angle about edge ij between the faces with the two other points k and l.
      std::array<int, 2> others{};
      for (int point = 0, found = 0; point < 4; ++point)
        if (point != i && point != j) others[found++] = point;
      const Vector edge = minus(tetrahedron[j], tetrahedron[i]);
      const Vector first = cross(edge, minus(tetrahedron[others[0]], tetrahedron[i]));
      const Vector second = cross(edge, minus(tetrahedron[others[1]], tetrahedron[i]));
      smallest = std::min(smallest, std::atan2(norm(cross(first, second)), dot(first, second)));
    }
  return smallest;
}

double volume(const std::array<Point, 4>& tetrahedron) {
  const auto& [a, b, c, d] = tetrahedron;
  return triple(minus(b, a), minus(c, a), minus(d, a)) / 6;
}

}  // namespace asperity::meshing
