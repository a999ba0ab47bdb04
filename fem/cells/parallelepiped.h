// Elastic forces of parallelepipeds: trilinear hexahedra with mean dilatation whose Jacobian is constant.
//
// In products of coordinates from -1 to 1 the gradients of a trilinear field are orthogonal polynomials, so
// that the stiffness of hex_kernel.h, integrated exactly by its points, falls apart into that of the mean
// gradient and those of six hourglass modes (Flanagan & Belytschko 1981; Belytschko & Bindeman 1993). That
// takes a quarter of the operations at eight points.
#pragma once

#include <array>

#include "fem/cells/hex_gradients.h"

namespace asperity::fem {

/// What the forces need of cells with shear modulus mu, bulk modulus K, volume V.
template <typename V>
struct Parallelepiped {
  /// sqrt(mu V) / 4 times the inverse Jacobian [sqrt(N/m)], [direction][component].
  std::array<std::array<V, 3>, 3> gradient;
  V bulk_ratio;  ///< K / mu [-]
};

/// Values at the vertices to coefficients of products: bit b of an index says whether coordinate b is a
/// factor. Eight times the coefficients.
template <typename V>
inline void products_of_vertices(V (&f)[8]) {
  for (int bit = 1; bit < 8; bit *= 2)
    for (int low = 0; low < 8; ++low) {
      if (low & bit) continue;
      const V a = f[low], b = f[low | bit];
      f[low] = a + b;
      f[low | bit] = b - a;
    }
}

/// Transpose of products_of_vertices().
template <typename V>
inline void vertices_of_products(V (&f)[8]) {
  for (int bit = 1; bit < 8; bit *= 2)
    for (int low = 0; low < 8; ++low) {
      if (low & bit) continue;
      const V a = f[low], b = f[low | bit];
      f[low] = a - b;
      f[low | bit] = a + b;
    }
}

/// Scalar product.
template <typename V>
inline V dot(const std::array<V, 3>& a, const std::array<V, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Replaces displacements [component][vertex] by nodal forces.
template <typename Number, typename V>
inline void parallelepiped_forces(const Parallelepiped<V>& cell, V (&nodes)[3][8]) {
  constexpr Number third = Number(1.0 / 3.0), two_thirds = Number(2.0 / 3.0), ninth = Number(1.0 / 9.0);
  using Vector3 = std::array<V, 3>;
  for (auto& component : nodes) products_of_vertices(component);
  const auto mode = [&](int m) { return Vector3{nodes[0][m], nodes[1][m], nodes[2][m]}; };
  const auto& g = cell.gradient;

  // The mean gradient, with all of the dilatation.
  V h[3][3];  // [component][direction in space]
  for (int c = 0; c < 3; ++c)
    for (int k = 0; k < 3; ++k)
      h[c][k] = nodes[c][1] * g[0][k] + nodes[c][2] * g[1][k] + nodes[c][4] * g[2][k];
  const V pressure = (cell.bulk_ratio - two_thirds) * (h[0][0] + h[1][1] + h[2][2]);
  V stress[3][3];
  for (int c = 0; c < 3; ++c)
    for (int k = 0; k < 3; ++k) stress[c][k] = h[c][k] + h[k][c];
  for (int c = 0; c < 3; ++c) stress[c][c] += pressure;
  V force[3][8];
  for (int c = 0; c < 3; ++c) {
    force[c][0] = V{};
    for (int d = 0; d < 3; ++d)
      force[c][1 << d] = stress[c][0] * g[d][0] + stress[c][1] * g[d][1] + stress[c][2] * g[d][2];
  }

  // Hourglass modes are deviatoric. Those of xy, xz, yz have gradients linear in one coordinate, each of
  // which two of them share; their mean square is a third, that of xyz a ninth.
  const Vector3 xy = mode(3), xz = mode(5), yz = mode(6), xyz = mode(7);
  const V g00 = dot(g[0], g[0]), g11 = dot(g[1], g[1]), g22 = dot(g[2], g[2]), g01 = dot(g[0], g[1]),
          g02 = dot(g[0], g[2]), g12 = dot(g[1], g[2]);
  V a[3], b[3], d[3];
  for (int k = 0; k < 3; ++k) a[k] = dot(xy, g[k]), b[k] = dot(xz, g[k]), d[k] = dot(yz, g[k]);
  const V along_xy[3] = {third * a[0] - two_thirds * d[2], third * a[1] - two_thirds * b[2], b[1] + d[0]};
  const V along_xz[3] = {third * b[0] - two_thirds * d[1], a[2] + d[0], third * b[2] - two_thirds * a[1]};
  const V along_yz[3] = {a[2] + b[1], third * d[1] - two_thirds * b[0], third * d[2] - two_thirds * a[0]};
  const V sum_xy = g00 + g11, sum_xz = g00 + g22, sum_yz = g11 + g22;
  const V sum = ninth * (sum_xy + g22);
  constexpr Number third_of_ninth = third * ninth;
  V along_xyz[3];
  for (int k = 0; k < 3; ++k) along_xyz[k] = third_of_ninth * dot(xyz, g[k]);
  for (int c = 0; c < 3; ++c) {
    const V &gx = g[0][c], &gy = g[1][c], &gz = g[2][c];
    force[c][3] = third * (sum_xy * xy[c] + g12 * xz[c] + g02 * yz[c] + along_xy[0] * gx + along_xy[1] * gy +
                           along_xy[2] * gz);
    force[c][5] = third * (sum_xz * xz[c] + g12 * xy[c] + g01 * yz[c] + along_xz[0] * gx + along_xz[1] * gy +
                           along_xz[2] * gz);
    force[c][6] = third * (sum_yz * yz[c] + g02 * xy[c] + g01 * xz[c] + along_yz[0] * gx + along_yz[1] * gy +
                           along_yz[2] * gz);
    force[c][7] = sum * xyz[c] + along_xyz[0] * gx + along_xyz[1] * gy + along_xyz[2] * gz;
  }
  for (int c = 0; c < 3; ++c) {
    vertices_of_products(force[c]);
    for (int v = 0; v < 8; ++v) nodes[c][v] = force[c][v];
  }
}

}  // namespace asperity::fem
