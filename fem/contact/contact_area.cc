#include "fem/contact/contact_area.h"

#include <algorithm>
#include <cmath>

namespace asperity::fem {

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

double contact_area(const std::vector<std::array<int, 4>>& quads, const std::vector<std::array<double, 2>>& points,
                    const std::vector<double>& pressure, const std::vector<double>& gap, double modulus) {
  constexpr int around[4] = {0, 1, 3, 2};
  double area = 0;
  for (const auto& quad : quads) {
    // The part of the face inside: its closed corners and the points where the edge crosses its sides.
    std::array<std::array<double, 2>, 8> polygon;
    int corners = 0, closed = 0;
    for (const int row : quad) closed += pressure[row] > 0;
    if (closed == 0) continue;
    const bool diagonal = closed == 2 && (pressure[quad[0]] > 0) == (pressure[quad[3]] > 0);
    for (int k = 0; k < 4; ++k) {
      const int here = quad[around[k]], next = quad[around[(k + 1) % 4]], before = quad[around[(k + 3) % 4]];
      const auto crossing = [&](int in, int out) {
        const auto &a = points[in], &b = points[out];
        const double s = edge_fraction(pressure[in], gap[out], std::hypot(b[0] - a[0], b[1] - a[1]), modulus);
        return std::array<double, 2>{a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])};
      };
      const bool in = pressure[here] > 0, next_in = pressure[next] > 0;
      if (diagonal) {  // two contacts that meet nowhere in this face: a triangle at either corner
        if (!in) continue;
        const auto p = points[here], a = crossing(here, next), b = crossing(here, before);
        area += 0.5 * std::abs((a[0] - p[0]) * (b[1] - p[1]) - (b[0] - p[0]) * (a[1] - p[1]));
        continue;
      }
      if (in) polygon[corners++] = points[here];
      if (in != next_in) polygon[corners++] = in ? crossing(here, next) : crossing(next, here);
    }
    double twice = 0;
    for (int k = 0; k < corners; ++k) {
      const auto &a = polygon[k], &b = polygon[(k + 1) % corners];
      twice += a[0] * b[1] - b[0] * a[1];
    }
    area += 0.5 * std::abs(twice);
  }
  return area;
}

}  // namespace asperity::fem
