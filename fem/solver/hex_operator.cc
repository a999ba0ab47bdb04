#include "fem/solver/hex_operator.h"

#include <algorithm>
#include <type_traits>

#include "core/error.h"
#include "core/threads.h"

namespace asperity::fem {

template <typename Number>
HexOperator<Number>::HexOperator(const MeshLevel& level, const Vector<double>& positions,
                                 const CellMaterials& materials)
    : level_(level),
      local_(level.partitioner()->locally_owned_size() + level.partitioner()->n_ghost_indices()) {
  if constexpr (std::is_same_v<Number, double>) {
    positions_ = positions.begin();
  } else {
    single_positions_.assign(positions.begin(), positions.begin() + local_);
    positions_ = single_positions_.data();
  }
  for (const J2Material& material : materials.all()) {
    shear_.push_back(static_cast<Number>(material.shear_modulus));
    bulk_.push_back(static_cast<Number>(material.bulk_modulus));
  }
}

template <typename Number>
void HexOperator<Number>::apply_batch(int index, const Number* x, Number* y) const {
  using V = Simd<Number>;
  const CellBatch& batch = level_.batches()[index];
  V nodes[3][8];
  HexStrain<V> strain;
  load_nodes(batch, positions_, nodes);
  evaluate_geometry<Number>(nodes, strain);
  load_nodes(batch, x, nodes);
  forces_of(index, strain, nodes);
  add_nodes(batch, nodes, y);
}

template <typename Number>
void HexOperator<Number>::apply_run(const int* first, const int* last, const Number* x, Number* y) const {
  if constexpr (std::is_same_v<Number, float>) {
    if (parallelepipeds_) {
      int waiting = -1;  // for another one: two at a time fill the processor's vectors
      for (const int* batch = first; batch != last; ++batch) {
        if (!part_.empty() && !part_[*batch]) continue;
        if (!parallelepipeds_->holds(*batch) || yields(*batch)) {
          apply_batch(*batch, x, y);
        } else if (waiting < 0) {
          waiting = *batch;
        } else {
          parallelepipeds_->apply(waiting, *batch, x, y);
          waiting = -1;
        }
      }
      if (waiting >= 0) parallelepipeds_->apply(waiting, -1, x, y);
      return;
    }
  }
  for (const int* batch = first; batch != last; ++batch)
    if (part_.empty() || part_[*batch]) apply_batch(*batch, x, y);
}

template <typename Number>
void HexOperator<Number>::set_part(std::vector<char> batches) {
  part_ = std::move(batches);
  std::vector<char> touched(local_ / 3, 0);
  for (std::size_t b = 0; b < part_.size(); ++b)
    if (part_[b])
      for (const auto& nodes : level_.batches()[b].node)
        for (const int node : nodes) touched[node] = 1;
  for (const auto& face : level_.interface_faces())
    for (const long node : face.node) {
      const auto& partitioner = *level_.partitioner();
      const auto dof = 3 * static_cast<dealii::types::global_dof_index>(node);
      if (partitioner.in_local_range(dof)) touched[partitioner.global_to_local(dof) / 3] = 1;
    }
  lines_.emplace(level_.lines().of_nodes(touched));
}

template <typename Number>
void HexOperator<Number>::take_cells_as_parallelepipeds() {
  if constexpr (std::is_same_v<Number, float>)
    parallelepipeds_ = std::make_unique<ParallelepipedBatches>(level_, single_positions_, shear_, bulk_);
}

template <typename Number>
void HexOperator<Number>::cell_matrices(int index, CellMatrices& matrices) const {
  using V = Simd<Number>;
  V nodes[3][8];
  HexStrain<V> strain;
  load_nodes(level_.batches()[index], positions_, nodes);
  evaluate_geometry<Number>(nodes, strain);
  for (int j = 0; j < 24; ++j) {
    for (auto& component : nodes)
      for (auto& value : component) value = V{};
    nodes[j % 3][j / 3] = V{} + Number(1);
    forces_of(index, strain, nodes);
    for (int i = 0; i < 24; ++i) matrices[i][j] = nodes[i % 3][i / 3];
  }
}

template <typename Number>
void HexOperator<Number>::forces_of(int index, HexStrain<Simd<Number>>& strain,
                                    Simd<Number> (&nodes)[3][8]) const {
  using V = Simd<Number>;
  const CellBatch& batch = level_.batches()[index];
  evaluate_strain<Number>(nodes, strain);
  V two_shear, bulk;
  for (int l = 0; l < lanes; ++l) {
    two_shear[l] = 2 * shear_[batch.material[l]];
    bulk[l] = bulk_[batch.material[l]];
  }
  const auto* yielding = yields(index) ? tangent_->batch[index].get() : nullptr;
  std::array<SymmetricTensor<V>, points_per_hex> stress;
  for (int q = 0; q < points_per_hex; ++q) {
    if (!yielding) {
      for (int c = 0; c < 6; ++c) stress[q][c] = two_shear * strain.deviator[q][c];
      continue;
    }
    const auto& tangent = (*yielding)[q];
    V theta, theta_bar;
    SymmetricTensor<V> normal;
    for (int l = 0; l < lanes; ++l) {
      theta[l] = tangent.theta[l];
      theta_bar[l] = tangent.theta_bar[l];
      for (int c = 0; c < 6; ++c) normal[c][l] = tangent.normal[c][l];
    }
    const V along = theta_bar * double_contraction(normal, strain.deviator[q]);
    for (int c = 0; c < 6; ++c)
      stress[q][c] = two_shear * (theta * strain.deviator[q][c] - along * normal[c]);
  }
  integrate_stress<Number>(strain, stress, bulk * strain.dilatation, nodes);
}

template <typename Number>
void HexOperator<Number>::multiply(Parts parts, Vector<Number>& dst, const Vector<Number>& src) const {
  const bool parallel = level_.partitioner()->n_mpi_processes() > 1;
  if (parallel) src.update_ghost_values();
  // Constrained entries of a vector carry no information of their own: they are slaves of the free ones.
  Number* x = const_cast<Number*>(src.begin());
  lines_ ? lines_->distribute(x) : level_.distribute(x);
  Number* y = dst.begin();
  for_entries(static_cast<int>(local_), [=](int i) { y[i] = 0; });  // ghosts too
  if (parts != Parts::contact)
    level_.for_each_run([&](const int* first, const int* last) { apply_run(first, last, x, y); });
  if (parts != Parts::bodies) {
    if (interface_) interface_->apply(x, y);
    if (driven_spring_ != 0 && level_.owns_driven_dof())
      y[level_.local_driven_dof()] += driven_spring_ * x[level_.local_driven_dof()];
  }
  lines_ ? lines_->condense(y) : level_.condense(y);
  if (parallel) {
    dst.compress(dealii::VectorOperation::add);
    src.zero_out_ghost_values();
  }
}

template <typename Number>
void HexOperator<Number>::find_bulk_diagonal() const {
  using V = Simd<Number>;
  bulk_diagonal_.assign(local_, Number(0));
  Number* d = bulk_diagonal_.data();
  level_.for_each_batch([&](int index) {
    const CellBatch& batch = level_.batches()[index];
    V nodes[3][8];
    HexStrain<V> strain;
    load_nodes(batch, positions_, nodes);
    evaluate_geometry<Number>(nodes, strain);
    for (int v = 0; v < 8; ++v) {
      V mean[3] = {}, entry[3] = {};
      for (int q = 0; q < points_per_hex; ++q) {
        // Shape function gradient of vertex v at point q on the unit cube.
        Number n[3], dn[3];
        for (int c = 0; c < 3; ++c) {
          const bool same = ((v >> c) & 1) == ((q >> c) & 1);
          n[c] = static_cast<Number>(same ? gauss_near : gauss_far);
          dn[c] = ((v >> c) & 1) ? Number(1) : Number(-1);
        }
        const Number r[3] = {dn[0] * n[1] * n[2], n[0] * dn[1] * n[2], n[0] * n[1] * dn[2]};
        const auto& inv = strain.inverse_jacobian[q];
        V g[3];
        for (int k = 0; k < 3; ++k) g[k] = r[0] * inv[k] + r[1] * inv[3 + k] + r[2] * inv[6 + k];
        const V square = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
        for (int c = 0; c < 3; ++c) {
          entry[c] += strain.volume[q] * (square + g[c] * g[c] * Number(1.0 / 3.0));
          mean[c] += strain.volume[q] * g[c];
        }
      }
      for (int l = 0; l < batch.count; ++l)
        for (int c = 0; c < 3; ++c)
          d[3 * batch.node[v][l] + c] +=
              shear_[batch.material[l]] * entry[c][l] +
              bulk_[batch.material[l]] * mean[c][l] * mean[c][l] / strain.cell_volume[l];
    }
  });
}

template <typename Number>
Vector<Number> HexOperator<Number>::diagonal() const {
  if (bulk_diagonal_.empty()) find_bulk_diagonal();
  Vector<double> diagonal(level_.partitioner());
  double* d = diagonal.begin();
  const Number* bulk = bulk_diagonal_.data();
  for_entries(static_cast<int>(bulk_diagonal_.size()), [=](int i) { d[i] = static_cast<double>(bulk[i]); });
  if (interface_) interface_->add_diagonal(d);
  if (driven_spring_ != 0 && level_.owns_driven_dof()) d[level_.local_driven_dof()] += driven_spring_;
  level_.condense_diagonal(d);
  diagonal.compress(dealii::VectorOperation::add);
  Vector<Number> result(level_.partitioner());
  const int own = static_cast<int>(result.locally_owned_size());
  for (const int c : level_.constrained())
    if (c < own) d[c] = 1;
  Number* r = result.begin();
  const double not_positive = sum_over_entries(own, [=](int i) {
    r[i] = static_cast<Number>(d[i]);
    return r[i] > 0 ? 0.0 : 1.0;
  });
  if (not_positive > 0)
    throw WorkError(
        "the mesh is torn between its trees on this number of processes (an error of p4est); use another "
        "number");
  return result;
}

template class HexOperator<double>;
template class HexOperator<float>;

}  // namespace asperity::fem
