// Strains and internal forces of trilinear hexahedra with mean dilatation (B-bar), eight cells at a time.
//
// B-bar (Nagtegaal, Parks & Rice 1974; Hughes 1980): the volumetric strain is its mean over the cell, so that
// plastic flow at constant volume does not lock. The pressure is then constant per cell. Geometry is
// recomputed from the nodes: that costs less than reading stored Jacobians.
#pragma once

#include <array>

#include "fem/cells/hex_gradients.h"
#include "fem/cells/simd.h"

namespace asperity::fem {

/// Symmetric tensor, components xx yy zz xy yz xz (tensor shear, not engineering shear).
template <typename V>
using SymmetricTensor = std::array<V, 6>;

/// Quantities of a batch of cells that the strain evaluation leaves for the integration of forces.
template <typename V>
struct HexStrain {
  std::array<std::array<V, 9>, points_per_hex> inverse_jacobian;  ///< [q][3 * direction + component]
  std::array<V, points_per_hex> volume;                           ///< |J| times weight [m^3]
  std::array<SymmetricTensor<V>, points_per_hex> deviator;        ///< deviatoric strain
  V dilatation;                                                   ///< mean volumetric strain of the cell
  V cell_volume;
};

/// Geometry of the cells: inverse Jacobians and volumes. x[component][vertex] in m.
template <typename Number, typename V = Simd<Number>>
inline void evaluate_geometry(const V (&x)[3][8], HexStrain<V>& strain) {
  std::array<std::array<V, 4>, 3> g[3];
  for (int c = 0; c < 3; ++c) reference_gradients<V, Number>(x[c], g[c]);
  strain.cell_volume = V{};
  for (int q = 0; q < points_per_hex; ++q) {
    V j[3][3];  // j[component][direction]
    for (int c = 0; c < 3; ++c)
      for (int d = 0; d < 3; ++d) j[c][d] = g[c][d][slot(d, q)];
    auto& inv = strain.inverse_jacobian[q];
    inv[0] = j[1][1] * j[2][2] - j[1][2] * j[2][1];
    inv[1] = j[0][2] * j[2][1] - j[0][1] * j[2][2];
    inv[2] = j[0][1] * j[1][2] - j[0][2] * j[1][1];
    inv[3] = j[1][2] * j[2][0] - j[1][0] * j[2][2];
    inv[4] = j[0][0] * j[2][2] - j[0][2] * j[2][0];
    inv[5] = j[0][2] * j[1][0] - j[0][0] * j[1][2];
    inv[6] = j[1][0] * j[2][1] - j[1][1] * j[2][0];
    inv[7] = j[0][1] * j[2][0] - j[0][0] * j[2][1];
    inv[8] = j[0][0] * j[1][1] - j[0][1] * j[1][0];
    const V determinant = j[0][0] * inv[0] + j[1][0] * inv[1] + j[2][0] * inv[2];
    const V reciprocal = Number(1) / determinant;
    for (auto& entry : inv) entry *= reciprocal;
    strain.volume[q] = determinant * Number(gauss_weight);
    strain.cell_volume += strain.volume[q];
  }
}

/// Deviatoric strain at the points and mean dilatation, from u[component][vertex] and the geometry.
template <typename Number, typename V = Simd<Number>>
inline void evaluate_strain(const V (&u)[3][8], HexStrain<V>& strain) {
  std::array<std::array<V, 4>, 3> g[3];
  for (int c = 0; c < 3; ++c) reference_gradients<V, Number>(u[c], g[c]);
  V volume_change = V{};
  for (int q = 0; q < points_per_hex; ++q) {
    const auto& inv = strain.inverse_jacobian[q];
    V h[3][3];  // h[component][k] = du_component / dx_k
    for (int c = 0; c < 3; ++c)
      for (int k = 0; k < 3; ++k)
        h[c][k] = g[c][0][slot(0, q)] * inv[k] + g[c][1][slot(1, q)] * inv[3 + k] +
                  g[c][2][slot(2, q)] * inv[6 + k];
    const V trace = h[0][0] + h[1][1] + h[2][2], mean = trace * Number(1.0 / 3.0);
    volume_change += trace * strain.volume[q];
    strain.deviator[q] = {h[0][0] - mean,
                          h[1][1] - mean,
                          h[2][2] - mean,
                          Number(0.5) * (h[0][1] + h[1][0]),
                          Number(0.5) * (h[1][2] + h[2][1]),
                          Number(0.5) * (h[0][2] + h[2][0])};
  }
  strain.dilatation = volume_change / strain.cell_volume;
}

/// Nodal forces f[component][vertex] = integral of B-bar^T sigma, sigma = stress_deviator + pressure I
/// (tension > 0).
template <typename Number, typename V = Simd<Number>>
inline void integrate_stress(const HexStrain<V>& strain,
                             const std::array<SymmetricTensor<V>, points_per_hex>& stress_deviator,
                             const V& mean_stress, V (&f)[3][8]) {
  std::array<std::array<V, 4>, 3> g[3] = {};
  constexpr int index[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
  for (int q = 0; q < points_per_hex; ++q) {
    const auto& inv = strain.inverse_jacobian[q];
    SymmetricTensor<V> s = stress_deviator[q];
    for (int c = 0; c < 3; ++c) s[c] += mean_stress;
    for (auto& component : s) component *= strain.volume[q];
    for (int c = 0; c < 3; ++c)
      for (int d = 0; d < 3; ++d)
        g[c][d][slot(d, q)] +=
            s[index[c][0]] * inv[3 * d] + s[index[c][1]] * inv[3 * d + 1] + s[index[c][2]] * inv[3 * d + 2];
  }
  for (int c = 0; c < 3; ++c) integrate_gradients<V, Number>(g[c], f[c]);
}

}  // namespace asperity::fem
