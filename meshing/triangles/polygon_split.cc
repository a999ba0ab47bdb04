#include "meshing/triangles/polygon_split.h"

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <unordered_set>

#include "meshing/triangles/vectors.h"

namespace asperity::meshing {

namespace {

std::uint64_t edge_key(std::uint32_t from, std::uint32_t to) { return std::uint64_t{from} << 32 | to; }

/// Edges of quads that no other quad runs along in the opposite sense.
class OpenEdges {
 public:
  explicit OpenEdges(const std::vector<QuadIndices>& quads) {
    std::unordered_set<std::uint64_t> all;
    all.reserve(4 * quads.size());
    for (const auto& quad : quads)
      for (int side = 0; side < 4; ++side) all.insert(edge_key(quad[side], quad[(side + 1) % 4]));
    for (const auto key : all) {
      const auto from = static_cast<std::uint32_t>(key >> 32), to = static_cast<std::uint32_t>(key);
      if (all.count(edge_key(to, from)) == 0) {
        keys_.insert(key);
        ends_[from].push_back(to);
      }
    }
    for (auto& [from, ends] : ends_) std::sort(ends.begin(), ends.end());
  }

  bool has(std::uint32_t from, std::uint32_t to) const { return keys_.count(edge_key(from, to)) != 0; }
  const std::vector<std::uint32_t>& ends(std::uint32_t from) const {
    static const std::vector<std::uint32_t> none;
    const auto found = ends_.find(from);
    return found == ends_.end() ? none : found->second;
  }

 private:
  std::unordered_set<std::uint64_t> keys_;
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> ends_;
};

/// Appends `from` and what hangs between it and `to`. The fine neighbours run from `to` over the node back to
/// `from`; that the node sees the edge under an obtuse angle tells it from a corner of a hole in the surface.
void append_edge(const std::vector<Point>& points, const OpenEdges& open, std::uint32_t from,
                 std::uint32_t to, std::vector<std::uint32_t>& polygon) {
  if (open.has(from, to))
    for (const auto middle : open.ends(to))
      if (open.has(middle, from) &&
          dot(minus(points[from], points[middle]), minus(points[to], points[middle])) < 0) {
        polygon.push_back(from);
        polygon.push_back(middle);
        return;
      }
  polygon.push_back(from);
}

}  // namespace

std::vector<std::vector<std::uint32_t>> polygons_with_hanging_nodes(const std::vector<Point>& points,
                                                                    const std::vector<QuadIndices>& quads) {
  const OpenEdges open(quads);
  std::vector<std::vector<std::uint32_t>> polygons;
  polygons.reserve(quads.size());
  for (const auto& quad : quads) {
    std::vector<std::uint32_t> polygon;
    for (int side = 0; side < 4; ++side) append_edge(points, open, quad[side], quad[(side + 1) % 4], polygon);
    polygons.push_back(std::move(polygon));
  }
  return polygons;
}

void split_polygon(const std::vector<Point>& points, const std::vector<std::uint32_t>& polygon,
                   std::vector<TriangleIndices>& triangles) {
  const int corners = static_cast<int>(polygon.size());
  if (corners == 3) {
    triangles.push_back({polygon[0], polygon[1], polygon[2]});
    return;
  }
  Vector normal{};
  for (int corner = 1; corner + 1 < corners; ++corner) {
    const Vector twice_area = cross(minus(points[polygon[corner]], points[polygon[0]]),
                                    minus(points[polygon[corner + 1]], points[polygon[0]]));
    for (int axis = 0; axis < 3; ++axis) normal[axis] += twice_area[axis];
  }
  const double length = norm(normal);
  const auto measure = [&](int i, int j, int k) {
    const Vector ij = minus(points[polygon[j]], points[polygon[i]]),
                 ik = minus(points[polygon[k]], points[polygon[i]]),
                 jk = minus(points[polygon[k]], points[polygon[j]]);
    return 2 * std::sqrt(3.) * dot(cross(ij, ik), normal) /
           (length * (dot(ij, ij) + dot(ik, ik) + dot(jk, jk)));
  };
  // best[i][k]: the worst triangle of the best triangulation of corners i..k; apex[i][k]: its triangle on
  // edge ik.
  std::vector<std::vector<double>> best(
      corners, std::vector<double>(corners, std::numeric_limits<double>::infinity()));
  std::vector<std::vector<int>> apex(corners, std::vector<int>(corners, -1));
  for (int span = 2; span < corners; ++span)
    for (int i = 0; i + span < corners; ++i) {
      const int k = i + span;
      best[i][k] = -std::numeric_limits<double>::infinity();
      for (int j = i + 1; j < k; ++j) {
        const double worst = std::min({best[i][j], best[j][k], measure(i, j, k)});
        if (apex[i][k] < 0 || worst > best[i][k]) {
          best[i][k] = worst;
          apex[i][k] = j;
        }
      }
    }
  std::vector<std::pair<int, int>> open{{0, corners - 1}};
  while (!open.empty()) {
    const auto [i, k] = open.back();
    open.pop_back();
    if (k - i < 2) continue;
    const int j = apex[i][k];
    triangles.push_back({polygon[i], polygon[j], polygon[k]});
    open.push_back({i, j});
    open.push_back({j, k});
  }
}

}  // namespace asperity::meshing
