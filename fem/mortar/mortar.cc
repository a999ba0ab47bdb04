#include "fem/mortar/mortar.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "core/error.h"

namespace asperity::fem {
namespace {

/// Finds the faces that a rectangle may overlap: a regular grid of bins over all faces.
class FaceBins {
 public:
  FaceBins(const std::vector<PlaneFace>& faces, double width) : width_(width) {
    for (int f = 0; f < static_cast<int>(faces.size()); ++f)
      for_bins(faces[f], [&](long key) { bins_[key].push_back(f); });
  }
  template <typename Visit>
  void visit(const PlaneFace& face, const Visit& visit) const {
    std::vector<int> seen;
    for_bins(face, [&](long key) {
      const auto bin = bins_.find(key);
      if (bin != bins_.end()) seen.insert(seen.end(), bin->second.begin(), bin->second.end());
    });
    std::sort(seen.begin(), seen.end());
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    for (const int f : seen) visit(f);
  }

 private:
  template <typename Action>
  void for_bins(const PlaneFace& f, const Action& action) const {
    const auto bin = [&](double x) { return static_cast<long>(std::floor(x / width_)); };
    for (long j = bin(f.y0); j <= bin(f.y1); ++j)
      for (long i = bin(f.x0); i <= bin(f.x1); ++i) action(j * 4000037L + i);
  }
  double width_;
  std::unordered_map<long, std::vector<int>> bins_;
};

using Point = std::array<double, 2>;

/// A convex polygon of few corners, cut by half-planes along the axes (Sutherland & Hodgman 1974).
struct Polygon {
  std::array<Point, 8> corner;
  int count = 0;

  /// Keeps what has sign * (p[axis] - bound) <= 0.
  void cut(int axis, double bound, double sign) {
    Polygon kept;
    for (int k = 0; k < count; ++k) {
      const Point &p = corner[k], &q = corner[(k + 1) % count];
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

double cross(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

std::array<double, 4> bilinear(double s, double t) {
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
  Point coordinates(const Point& p) const {
    Point s{0.5, 0.5};
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
  Point origin_, along_, across_, twist_;
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

void add_overlap(const PlaneQuad& quad, const BilinearMap& map, const PlaneFace& face, int index,
                 std::vector<OverlapPoint>& points) {
  Polygon overlap;
  overlap.corner = {quad.corner[0], quad.corner[1], quad.corner[3], quad.corner[2]};
  overlap.count = 4;
  overlap.cut(0, face.x1, 1), overlap.cut(0, face.x0, -1), overlap.cut(1, face.y1, 1),
      overlap.cut(1, face.y0, -1);
  const double wx = face.x1 - face.x0, wy = face.y1 - face.y0;
  for (int k = 1; k + 1 < overlap.count; ++k) {
    const Point triangle[3] = {overlap.corner[0], overlap.corner[k], overlap.corner[k + 1]};
    const double area = 0.5 * cross(triangle[0], triangle[1], triangle[2]);
    if (area <= 0) continue;
    for (const auto& [a, weight] : triangle_rule)
      for (int v = 0; v < 3; ++v) {
        Point p{};
        for (int u = 0; u < 3; ++u)
          for (int c = 0; c < 2; ++c) p[c] += (u == v ? 1 - 2 * a : a) * triangle[u][c];
        const Point s = map.coordinates(p);
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

/// Coefficients A of the dual functions psi = A N of a face, and the integrals D of N.
std::pair<Eigen::Matrix4d, Eigen::Vector4d> dual_basis(const std::vector<OverlapPoint>& points) {
  Eigen::Matrix4d mass = Eigen::Matrix4d::Zero();
  Eigen::Vector4d integral = Eigen::Vector4d::Zero();
  for (const auto& p : points) {
    const Eigen::Map<const Eigen::Vector4d> n(p.own.data());
    mass += p.weight * n * n.transpose();
    integral += p.weight * n;
  }
  return {integral.asDiagonal() * mass.inverse(), integral};
}

double area_of(const PlaneQuad& q) {
  return 0.5 * (cross(q.corner[0], q.corner[1], q.corner[3]) + cross(q.corner[0], q.corner[3], q.corner[2]));
}

PlaneFace box_of(const PlaneQuad& quad) {
  PlaneFace box{1e300, -1e300, 1e300, -1e300, quad.node};
  for (const auto& p : quad.corner) {
    box.x0 = std::min(box.x0, p[0]), box.x1 = std::max(box.x1, p[0]);
    box.y0 = std::min(box.y0, p[1]), box.y1 = std::max(box.y1, p[1]);
  }
  return box;
}

}  // namespace

std::vector<PlaneQuad> quads(const std::vector<PlaneFace>& faces) {
  std::vector<PlaneQuad> result;
  for (const auto& f : faces)
    result.push_back({{{{f.x0, f.y0}, {f.x1, f.y0}, {f.x0, f.y1}, {f.x1, f.y1}}}, f.node});
  return result;
}

std::vector<GapRow> couple_interfaces(const std::vector<PlaneQuad>& particle,
                                      const std::vector<PlaneFace>& substrate) {
  if (particle.empty()) return {};
  PlaneFace all = box_of(particle[0]);
  double width = 1e300;
  for (const auto& q : particle) {
    const PlaneFace box = box_of(q);
    all.x0 = std::min(all.x0, box.x0), all.x1 = std::max(all.x1, box.x1), all.y0 = std::min(all.y0, box.y0),
    all.y1 = std::max(all.y1, box.y1);
    width = std::min(width, box.x1 - box.x0);
  }
  std::vector<PlaneFace> near;
  for (const auto& f : substrate)
    if (f.x1 > all.x0 && f.x0 < all.x1 && f.y1 > all.y0 && f.y0 < all.y1) near.push_back(f);
  const FaceBins bins(near, 2 * width);

  std::unordered_map<int, int> row_of_node;
  std::vector<GapRow> rows;
  std::vector<std::map<int, std::array<double, 3>>> mortar;  // integrals of psi N, psi dN/dx, psi dN/dy
  std::vector<OverlapPoint> points;
  for (const auto& quad : particle) {
    points.clear();
    const BilinearMap map(quad);
    bins.visit(box_of(quad), [&](int index) { add_overlap(quad, map, near[index], index, points); });
    double covered = 0;
    for (const auto& p : points) covered += p.weight;
    const double area = area_of(quad);
    if (std::abs(covered - area) > 1e-6 * area)
      throw WorkError(
          "the substrate's mesh does not cover the particle's contact region; enlarge Mesh/Contact region of "
          "the substrate");
    const auto [dual, integral] = dual_basis(points);
    int row[4];
    for (int a = 0; a < 4; ++a) {
      const auto [entry, added] = row_of_node.try_emplace(quad.node[a], static_cast<int>(rows.size()));
      if (added) {
        rows.emplace_back();
        rows.back().node = quad.node[a];
        mortar.emplace_back();
      }
      row[a] = entry->second;
      rows[row[a]].area += integral[a];
    }
    for (std::size_t first = 0, last = 0; first < points.size(); first = last) {
      double sums[4][4][3] = {};  // over one face of the substrate
      for (; last < points.size() && points[last].face == points[first].face; ++last) {
        const auto& p = points[last];
        const Eigen::Vector4d psi = p.weight * (dual * Eigen::Map<const Eigen::Vector4d>(p.own.data()));
        for (int a = 0; a < 4; ++a)
          for (int b = 0; b < 4; ++b) {
            sums[a][b][0] += psi[a] * p.other[b];
            sums[a][b][1] += psi[a] * p.slope[b][0];
            sums[a][b][2] += psi[a] * p.slope[b][1];
          }
      }
      for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b) {
          auto& sum = mortar[row[a]][near[points[first].face].node[b]];
          for (int k = 0; k < 3; ++k) sum[k] += sums[a][b][k];
        }
    }
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    rows[r].entries.emplace_back(rows[r].node, 1.0);
    for (const auto& [node, sum] : mortar[r]) {
      if (std::abs(sum[0]) > 1e-12 * rows[r].area) rows[r].entries.emplace_back(node, -sum[0] / rows[r].area);
      rows[r].slope_entries.push_back({node, {sum[1] / rows[r].area, sum[2] / rows[r].area}});
    }
  }
  return rows;
}

}  // namespace asperity::fem
