// Overlaps of faces of two interfaces, and the points on them by which products of shape functions are
// integrated.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "fem/mortar/mortar.h"

namespace asperity::fem {

/// A point in the plane of the contact [m], or bilinear coordinates [-].
using PlanePoint = std::array<double, 2>;

/// A convex polygon of few corners, cut by half-planes along the axes (Sutherland & Hodgman 1974).
struct Polygon {
  std::array<PlanePoint, 8> corner;
  int count = 0;

  /// Keeps what has sign * (p[axis] - bound) <= 0.
  void cut(int axis, double bound, double sign) {
    Polygon kept;
    for (int k = 0; k < count; ++k) {
      const PlanePoint &p = corner[k], &q = corner[(k + 1) % count];
      const double dp = sign * (p[axis] - bound), dq = sign * (q[axis] - bound);
      if (dp <= 0) kept.corner[kept.count++] = p;
      if ((dp < 0 && dq > 0) || (dp > 0 && dq < 0)) {
        const double t = dp / (dp - dq);
        kept.corner[kept.count++] = {p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])};
      }
    }
    *this = kept;
  }
};

/// Area of a triangle, negative where its corners go clockwise [m^2].
inline double triangle_area(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
}

/// Bilinear shape functions of a face at coordinates between 0 and 1 [-].
inline std::array<double, 4> bilinear(double s, double t) {
  return {(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t};
}

/// Bilinear coordinates of points of a quadrilateral, by Newton's iteration: one step where it is a
/// parallelogram.
class BilinearMap {
 public:
  explicit BilinearMap(const PlaneQuad& quad) : origin_(quad.corner[0]) {
    for (int c = 0; c < 2; ++c) {
      along_[c] = quad.corner[1][c] - origin_[c];
      across_[c] = quad.corner[2][c] - origin_[c];
      twist_[c] = quad.corner[3][c] - quad.corner[1][c] - across_[c];
    }
  }

  /// Of a point of the face [m], between 0 and 1 [-].
  PlanePoint coordinates(const PlanePoint& p) const {
    PlanePoint s{0.5, 0.5};
    for (int iteration = 0; iteration < 20; ++iteration) {
      double residual[2], ds[2], dt[2];
      for (int c = 0; c < 2; ++c) {
        residual[c] = p[c] - origin_[c] - s[0] * along_[c] - s[1] * across_[c] - s[0] * s[1] * twist_[c];
        ds[c] = along_[c] + s[1] * twist_[c];
        dt[c] = across_[c] + s[0] * twist_[c];
      }
      const double determinant = ds[0] * dt[1] - ds[1] * dt[0];
      const double step_s = (residual[0] * dt[1] - residual[1] * dt[0]) / determinant;
      const double step_t = (ds[0] * residual[1] - ds[1] * residual[0]) / determinant;
      s[0] += step_s, s[1] += step_t;
      if (std::abs(step_s) + std::abs(step_t) < 1e-13) break;
    }
    return s;
  }

 private:
  PlanePoint origin_, along_, across_, twist_;
};

/// Exact to degree 4 on a triangle, as the product of two bilinear functions needs (Strang & Fix 1973):
/// barycentric a, weight.
constexpr std::array<std::array<double, 2>, 2> triangle_rule{
    {{0.445948490915964886, 0.223381589678011466}, {0.091576213509770743, 0.109951743655321868}}};

/// A point of the overlap of one particle face with one of the substrate.
struct OverlapPoint {
  double weight;                               ///< [m^2]
  std::array<double, 4> own, other;            ///< shape functions of both faces
  std::array<std::array<double, 2>, 4> slope;  ///< gradients of `other` [1/m]
  int face;                                    ///< of the substrate
};

/// Appends the points of the overlap of a particle's face, with its map, and the substrate's face `index`.
inline void add_overlap(const PlaneQuad& quad, const BilinearMap& map, const PlaneFace& face, int index,
                        std::vector<OverlapPoint>& points) {
  Polygon overlap;
  overlap.corner = {quad.corner[0], quad.corner[1], quad.corner[3], quad.corner[2]};
  overlap.count = 4;
  overlap.cut(0, face.x1, 1), overlap.cut(0, face.x0, -1), overlap.cut(1, face.y1, 1),
      overlap.cut(1, face.y0, -1);
  const double wx = face.x1 - face.x0, wy = face.y1 - face.y0;
  for (int k = 1; k + 1 < overlap.count; ++k) {
    const PlanePoint triangle[3] = {overlap.corner[0], overlap.corner[k], overlap.corner[k + 1]};
    const double area = triangle_area(triangle[0], triangle[1], triangle[2]);
    if (area <= 0) continue;
    for (const auto& [a, weight] : triangle_rule)
      for (int v = 0; v < 3; ++v) {
        PlanePoint p{};
        for (int u = 0; u < 3; ++u)
          for (int c = 0; c < 2; ++c) p[c] += (u == v ? 1 - 2 * a : a) * triangle[u][c];
        const PlanePoint s = map.coordinates(p);
        const double x = (p[0] - face.x0) / wx, y = (p[1] - face.y0) / wy;
        points.push_back({weight * area,
                          bilinear(s[0], s[1]),
                          bilinear(x, y),
                          {{{-(1 - y) / wx, -(1 - x) / wy},
                            {(1 - y) / wx, -x / wy},
                            {-y / wx, (1 - x) / wy},
                            {y / wx, x / wy}}},
                          index});
      }
  }
}

}  // namespace asperity::fem
