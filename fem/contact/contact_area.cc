#include "fem/contact/contact_area.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace asperity::fem {
namespace {

using Point = std::array<double, 2>;

/// Of the area counted, taken for contact at least: spots of one or two nodes.
constexpr double smallest_share = 0.25;

/// Clusters of active contact nodes that sides of faces join, by union and find.
int count_spots(const std::vector<std::array<int, 4>>& quads, const std::vector<double>& pressure) {
  constexpr int sides[4][2] = {{0, 1}, {2, 3}, {0, 2}, {1, 3}};
  std::vector<int> parent(pressure.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int row) {
    while (parent[row] != row) row = parent[row] = parent[parent[row]];
    return row;
  };
  for (const auto& quad : quads)
    for (const auto& [a, b] : sides)
      if (pressure[quad[a]] > 0 && pressure[quad[b]] > 0) parent[root(quad[a])] = root(quad[b]);
  int spots = 0;
  for (std::size_t row = 0; row < pressure.size(); ++row)
    spots += pressure[row] > 0 && parent[row] == static_cast<int>(row);
  return spots;
}

double area_of(const std::vector<Point>& points, const std::array<int, 4>& quad) {
  const Point &a = points[quad[0]], &b = points[quad[3]], &c = points[quad[1]], &d = points[quad[2]];
  return 0.5 * std::abs((b[0] - a[0]) * (d[1] - c[1]) - (b[1] - a[1]) * (d[0] - c[0]));
}

/// The part of a face inside of the edge: its closed corners and the points where the edge crosses its sides.
struct Inside {
  std::array<Point, 8> corner;
  std::array<bool, 8> leaves{};  ///< the side that follows the corner is the edge
  int count = 0;

  void add(const Point& p, bool is_on_edge = false) {
    leaves[count] = is_on_edge;
    corner[count++] = p;
  }
  /// Adds the polygon's area and the length of its edge.
  void add_to(double& area, double& edge) const {
    double twice = 0;
    for (int k = 0; k < count; ++k) {
      const Point &a = corner[k], &b = corner[(k + 1) % count];
      twice += a[0] * b[1] - b[0] * a[1];
      if (leaves[k]) edge += std::hypot(b[0] - a[0], b[1] - a[1]);
    }
    area += 0.5 * std::abs(twice);
  }
};

}  // namespace

double edge_fraction(double pressure, double gap, double distance, double modulus) {
  if (gap <= 0) return 1;
  // With s the fraction: (1 - s)^(3/2) = q sqrt(s); the difference falls steadily from s = 0 to 1.
  const double q = 0.75 * modulus * gap / (pressure * distance);
  double low = 0, high = 1;
  for (int k = 0; k < 40; ++k) {
    const double s = 0.5 * (low + high);
    ((1 - s) * std::sqrt(1 - s) > q * std::sqrt(s) ? low : high) = s;
  }
  return 0.5 * (low + high);
}

ContactShape contact_shape(const std::vector<std::array<int, 4>>& quads, const std::vector<Point>& points,
                           const std::vector<double>& pressure, const std::vector<double>& gap,
                           double modulus) {
  constexpr int around[4] = {0, 1, 3, 2};
  ContactShape shape;
  shape.spots = count_spots(quads, pressure);
  const auto crossing = [&](int in, int out) {
    const Point &a = points[in], &b = points[out];
    const double s = edge_fraction(pressure[in], gap[out], std::hypot(b[0] - a[0], b[1] - a[1]), modulus);
    return Point{a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])};
  };
  double patches = 0, within = 0, rim = 0;  // areas of the active nodes, within the edge, and of the outset
  for (const auto& quad : quads) {
    const auto is_closed = [&](int k) { return pressure[quad[around[k % 4]]] > 0; };
    const int closed = is_closed(0) + is_closed(1) + is_closed(2) + is_closed(3);
    if (closed == 0) continue;
    const bool diagonal = closed == 2 && is_closed(0) == is_closed(2);
    Inside inside;
    double edge = 0;
    for (int k = 0; k < 4; ++k) {
      const int here = quad[around[k]], next = quad[around[(k + 1) % 4]], before = quad[around[(k + 3) % 4]];
      if (diagonal) {  // two contacts that meet nowhere in this face: a triangle at either corner
        if (!is_closed(k)) continue;
        Inside triangle;
        triangle.add(points[here]), triangle.add(crossing(here, next), true),
            triangle.add(crossing(here, before));
        triangle.add_to(within, edge);
        continue;
      }
      if (is_closed(k)) inside.add(points[here]);
      if (is_closed(k) != is_closed(k + 1))
        inside.add(is_closed(k) ? crossing(here, next) : crossing(next, here), is_closed(k));
    }
    inside.add_to(within, edge);
    const double face = area_of(points, quad);
    shape.perimeter += edge;
    patches += 0.25 * closed * face;
    rim += outset * edge * std::sqrt(face);
  }
  const double counted = 0.5 * (patches + within);
  shape.area = std::max(counted - rim, smallest_share * counted);
  return shape;
}

}  // namespace asperity::fem
