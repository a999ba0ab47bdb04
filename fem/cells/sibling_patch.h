// Nodal values of eight sibling cells, which share 27 nodes: read and written once each instead of once a
// cell, and moved to the cells' vertices and back in registers.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

#include "fem/cells/hex_gradients.h"
#include "fem/cells/simd.h"

namespace asperity::fem {

constexpr int patch_nodes = 27;

/// Four, and twice `lanes`, numbers in single precision.
typedef float Four __attribute__((vector_size(16)));
typedef float Sixteen __attribute__((vector_size(64)));

/// Local nodes of eight siblings, lexicographic; the last one once more.
using PatchNodes = std::array<int, 28>;

/// The node of a patch at a vertex of a cell, both lexicographic.
constexpr int patch_site(int cell, int vertex) {
  return ((cell & 1) + (vertex & 1)) + 3 * (((cell >> 1) & 1) + ((vertex >> 1) & 1)) +
         9 * ((cell >> 2) + (vertex >> 2));
}

/// Values of one component at 32 sites of a patch, of which the first 27 are used.
using PatchGrid = std::array<Sixteen, 2>;

/// Unaligned.
inline Four load_four(const float* values) {
  Four four;
  std::memcpy(&four, values, sizeof four);
  return four;
}

/// Side by side.
inline Sixteen joined_fours(const Four (&part)[4]) {
  const auto low = __builtin_shufflevector(part[0], part[1], 0, 1, 2, 3, 4, 5, 6, 7);
  const auto high = __builtin_shufflevector(part[2], part[3], 0, 1, 2, 3, 4, 5, 6, 7);
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
}

/// The first of three components of a node.
inline const float* first_of(const float* field, int node) {
  return field + 3 * static_cast<std::ptrdiff_t>(node);
}

/// Reads three components, and one number behind them, of each node.
inline void load_patch(const PatchNodes& node, const float* field, PatchGrid (&grid)[3]) {
  for (int half = 0; half < 2; ++half) {
    Four x[4] = {}, y[4] = {}, z[4] = {};
    for (int t = 0; t < 4 - half; ++t) {
      const int* n = node.data() + static_cast<std::ptrdiff_t>(16 * half + 4 * t);
      const Four a = load_four(first_of(field, n[0])), b = load_four(first_of(field, n[1]));
      const Four c = load_four(first_of(field, n[2])), d = load_four(first_of(field, n[3]));
      const Four low_ab = __builtin_shufflevector(a, b, 0, 4, 1, 5);
      const Four low_cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
      const Four high_ab = __builtin_shufflevector(a, b, 2, 6, 3, 7);
      const Four high_cd = __builtin_shufflevector(c, d, 2, 6, 3, 7);
      x[t] = __builtin_shufflevector(low_ab, low_cd, 0, 1, 4, 5);
      y[t] = __builtin_shufflevector(low_ab, low_cd, 2, 3, 6, 7);
      z[t] = __builtin_shufflevector(high_ab, high_cd, 0, 1, 4, 5);
    }
    grid[0][half] = joined_fours(x);
    grid[1][half] = joined_fours(y);
    grid[2][half] = joined_fours(z);
  }
}

/// Of a pair of vertices that differ in the first coordinate: first vertex of eight cells, second of eight.
template <int pair, int... lane>
inline Sixteen at_vertices(const PatchGrid& grid, std::integer_sequence<int, lane...>) {
  return __builtin_shufflevector(grid[0], grid[1], patch_site(lane % 8, 2 * pair + lane / 8)...);
}

/// The lane of a vector of cells whose vertex lies on a site; none: a lane of a second vector, which is zero.
constexpr int cell_at(int site, int vertex, int first_lane) {
  for (int cell = 0; cell < 8; ++cell)
    if (patch_site(cell, vertex) == site) return first_lane + cell;
  return 16;
}

/// Values at one vertex of the cells of one patch, moved to half of its sites.
template <int vertex, int first_lane, int half, int... lane>
inline Sixteen at_sites(const Sixteen& cells, std::integer_sequence<int, lane...>) {
  return __builtin_shufflevector(cells, Sixteen{}, cell_at(16 * half + lane, vertex, first_lane)...);
}

constexpr std::make_integer_sequence<int, 16> all_lanes{};

/// One component at the vertices of the cells of patch a, and then of b.
template <int... pair>
inline void to_vertices(const PatchGrid& a, const PatchGrid& b, Sixteen (&values)[8],
                        std::integer_sequence<int, pair...>) {
  const auto one = [&](std::ptrdiff_t p, const Sixteen& of_a, const Sixteen& of_b) {
    values[2 * p] =
        __builtin_shufflevector(of_a, of_b, 0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23);
    values[2 * p + 1] =
        __builtin_shufflevector(of_a, of_b, 8, 9, 10, 11, 12, 13, 14, 15, 24, 25, 26, 27, 28, 29, 30, 31);
  };
  (one(pair, at_vertices<pair>(a, all_lanes), at_vertices<pair>(b, all_lanes)), ...);
}

/// Sums over the cells of the patch that begins at `first_lane`.
template <int first_lane, int... vertex>
inline PatchGrid to_sites(const Sixteen (&values)[8], std::integer_sequence<int, vertex...>) {
  return {(at_sites<vertex, first_lane, 0>(values[vertex], all_lanes) + ...),
          (at_sites<vertex, first_lane, 1>(values[vertex], all_lanes) + ...)};
}

/// Three components at the vertices of the cells of patch a, and then of b.
inline void to_vertices(const PatchGrid (&a)[3], const PatchGrid (&b)[3], Sixteen (&values)[3][8]) {
  for (int c = 0; c < 3; ++c) to_vertices(a[c], b[c], values[c], std::make_integer_sequence<int, 4>{});
}

/// Adds the values of the cells of the first (first_lane 0) or second (8) patch to a field.
template <int first_lane>
inline void add_patch(const PatchNodes& node, const Sixteen (&values)[3][8], float* field) {
  alignas(64) float sum[3][32];
  for (int c = 0; c < 3; ++c) {
    const PatchGrid grid = to_sites<first_lane>(values[c], std::make_integer_sequence<int, 8>{});
    std::memcpy(sum[c], grid.data(), sizeof sum[c]);
  }
  for (int s = 0; s < patch_nodes; ++s) {
    float* own = field + 3 * static_cast<std::ptrdiff_t>(node[s]);
    own[0] += sum[0][s];
    own[1] += sum[1][s];
    own[2] += sum[2][s];
  }
}

}  // namespace asperity::fem
