// Gradients of trilinear fields at the 2x2x2 Gauss points of hexahedra, and their transpose, by sum
// factorisation.
//
// Vertices v = i + 2j + 4k and points q = i + 2j + 4k count lexicographically. A derivative along one
// direction is constant along it, so each direction has four distinct values, indexed by the other two
// coordinates of the point.
#pragma once

#include <array>

namespace asperity::fem {

constexpr int vertices_per_hex = 8, points_per_hex = 8;

/// Values of the two linear shape functions at the two Gauss points: (1 +- 1/sqrt(3)) / 2.
constexpr double gauss_near = 0.78867513459481288225, gauss_far = 0.21132486540518711775;
constexpr double gauss_weight = 0.125;  ///< of each point on the unit cube

/// Index among the four values of direction d at point q.
constexpr int slot(int direction, int q) {
  return direction == 0   ? ((q >> 1) & 1) + 2 * ((q >> 2) & 1)
         : direction == 1 ? (q & 1) + 2 * ((q >> 2) & 1)
                          : (q & 1) + 2 * ((q >> 1) & 1);
}

/// Interpolates four values from the ends to the Gauss points of two directions; symmetric, so its own
/// transpose.
template <typename V, typename Number>
inline void interpolate_both(std::array<V, 4>& e, Number near, Number far) {
  const V a = near * e[0] + far * e[1], b = far * e[0] + near * e[1];
  const V c = near * e[2] + far * e[3], d = far * e[2] + near * e[3];
  e[0] = near * a + far * c;
  e[1] = near * b + far * d;
  e[2] = far * a + near * c;
  e[3] = far * b + near * d;
}

/// Reference gradients of one field: result[direction][slot].
template <typename V, typename Number>
inline void reference_gradients(const V* f, std::array<std::array<V, 4>, 3>& g) {
  for (int s = 0; s < 4; ++s) {
    const int x = 2 * s;
    g[0][s] = f[x + 1] - f[x];
    const int y = (s & 1) + 4 * (s >> 1);
    g[1][s] = f[y + 2] - f[y];
    g[2][s] = f[s + 4] - f[s];
  }
  for (int d = 0; d < 3; ++d) interpolate_both(g[d], Number(gauss_near), Number(gauss_far));
}

/// Transpose: nodal values from what was summed into result[direction][slot] (overwritten).
template <typename V, typename Number>
inline void integrate_gradients(std::array<std::array<V, 4>, 3>& g, V* f) {
  for (int d = 0; d < 3; ++d) interpolate_both(g[d], Number(gauss_near), Number(gauss_far));
  for (int v = 0; v < 8; ++v) {
    const V& x = g[0][v >> 1];
    const V& y = g[1][(v & 1) + 2 * (v >> 2)];
    const V& z = g[2][v & 3];
    f[v] = (v & 1 ? x : -x) + (v & 2 ? y : -y) + (v & 4 ? z : -z);
  }
}

}  // namespace asperity::fem
