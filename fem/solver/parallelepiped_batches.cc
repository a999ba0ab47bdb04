#include "fem/solver/parallelepiped_batches.h"

#include <algorithm>
#include <cmath>

#include "fem/cells/hex_kernel.h"
#include "fem/solver/hex_operator.h"

namespace asperity::fem {
namespace {

// Share by which the Jacobian within a cell may differ from its mean. Energies are wrong by twice as much,
// which conjugate gradients hardly notice.
constexpr float largest_distortion = 0.25f;

using Eight = Simd<float>;

/// Inverse mean Jacobian of the cells, [direction][component], and the largest difference from it.
std::array<std::array<Eight, 3>, 3> mean_inverse(const Eight (&position)[3][8],
                                                 const HexStrain<Eight>& strain, float& distortion) {
  Eight mean[3][3];  // [component][direction]
  for (int c = 0; c < 3; ++c) {
    Eight products[8];
    std::copy(position[c], position[c] + 8, products);
    products_of_vertices(products);
    for (int d = 0; d < 3; ++d) mean[c][d] = 0.25f * products[1 << d];
  }
  distortion = 0;
  for (int q = 0; q < points_per_hex; ++q)
    for (int d = 0; d < 3; ++d)
      for (int e = 0; e < 3; ++e) {
        const auto& inverse = strain.inverse_jacobian[q];
        Eight product{};
        for (int c = 0; c < 3; ++c) product += inverse[3 * d + c] * mean[c][e];
        for (int l = 0; l < lanes; ++l)
          distortion = std::max(distortion, std::abs(product[l] - (d == e ? 1.0f : 0.0f)));
      }
  std::array<std::array<Eight, 3>, 3> inverse;
  const auto minor = [&](int c, int d) {  // cofactor of mean[c][d]
    const int c1 = (c + 1) % 3, c2 = (c + 2) % 3, d1 = (d + 1) % 3, d2 = (d + 2) % 3;
    return mean[c1][d1] * mean[c2][d2] - mean[c1][d2] * mean[c2][d1];
  };
  const Eight determinant = mean[0][0] * minor(0, 0) + mean[1][0] * minor(1, 0) + mean[2][0] * minor(2, 0);
  for (int d = 0; d < 3; ++d)
    for (int c = 0; c < 3; ++c) inverse[d][c] = minor(c, d) / determinant;
  return inverse;
}

/// Whether the cells of a batch are eight siblings in their order, and their nodes.
bool find_siblings(const CellBatch& batch, PatchNodes& nodes) {
  if (batch.count < lanes) return false;
  nodes.fill(-1);
  for (int v = 0; v < vertices_per_hex; ++v)
    for (int l = 0; l < lanes; ++l) {
      int& node = nodes[patch_site(l, v)];
      if (node < 0) node = batch.node[v][l];
      if (node != batch.node[v][l]) return false;
    }
  nodes[patch_nodes] = nodes[patch_nodes - 1];
  return true;
}

Sixteen side_by_side(const Eight& a, const Eight& b) {
  return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
}

}  // namespace

ParallelepipedBatches::ParallelepipedBatches(const MeshLevel& level, const std::vector<float>& positions,
                                             const std::vector<float>& shear,
                                             const std::vector<float>& bulk) {
  const int last_node = static_cast<int>(positions.size() / 3) - 1;
  place_.reserve(level.batches().size());
  for (const CellBatch& batch : level.batches()) {
    place_.push_back(-1);
    Siblings cells;
    if (!find_siblings(batch, cells.node)) continue;
    Eight position[3][8];
    HexStrain<Eight> strain;
    load_nodes(batch, positions.data(), position);
    evaluate_geometry<float>(position, strain);
    float distortion;
    cells.gradient = mean_inverse(position, strain, distortion);
    if (distortion > largest_distortion) continue;
    Eight stiffness;
    for (int l = 0; l < lanes; ++l) {
      stiffness[l] = shear[batch.material[l]];
      cells.bulk_ratio[l] = bulk[batch.material[l]] / shear[batch.material[l]];
    }
    const Eight scale = 0.25f * square_root(Eight(stiffness * strain.cell_volume));
    for (auto& direction : cells.gradient)
      for (auto& component : direction) component *= scale;
    cells.is_last = std::find(cells.node.begin(), cells.node.end(), last_node) != cells.node.end();
    place_.back() = static_cast<int>(siblings_.size());
    siblings_.push_back(cells);
  }
  siblings_.shrink_to_fit();
}

void ParallelepipedBatches::load(const Siblings& siblings, const float* x, PatchGrid (&grid)[3]) {
  if (!siblings.is_last) return load_patch(siblings.node, x, grid);
  PatchNodes place;
  std::array<float, 3 * patch_nodes + 1> copy{};
  for (int s = 0; s < patch_nodes; ++s) {
    place[s] = s;
    std::copy_n(first_of(x, siblings.node[s]), 3, copy.data() + 3 * static_cast<std::ptrdiff_t>(s));
  }
  place[patch_nodes] = patch_nodes - 1;
  load_patch(place, copy.data(), grid);
}

void ParallelepipedBatches::apply(int first, int second, const float* x, float* y) const {
  const bool alone = second < 0;
  const Siblings &a = siblings_[place_[first]], &b = alone ? a : siblings_[place_[second]];
  Parallelepiped<Sixteen> cells;
  for (int d = 0; d < 3; ++d)
    for (int c = 0; c < 3; ++c) cells.gradient[d][c] = side_by_side(a.gradient[d][c], b.gradient[d][c]);
  cells.bulk_ratio = side_by_side(a.bulk_ratio, b.bulk_ratio);
  PatchGrid of_a[3], of_b[3];
  load(a, x, of_a);
  load(b, x, of_b);
  Sixteen nodes[3][8];
  to_vertices(of_a, of_b, nodes);
  parallelepiped_forces<float>(cells, nodes);
  add_patch<0>(a.node, nodes, y);
  if (!alone) add_patch<8>(b.node, nodes, y);
}

}  // namespace asperity::fem
