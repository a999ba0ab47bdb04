// Matrix-free stiffness of both bodies plus the interface's stiffness on one mesh level: y = C^T (K + G^T E
// G) C x.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "fem/cells/hex_kernel.h"
#include "fem/levels/cell_materials.h"
#include "fem/levels/mesh_level.h"
#include "fem/mortar/interface_operator.h"
#include "fem/solver/parallelepiped_batches.h"

namespace asperity::fem {

/// Consistent tangents of the cell batches that yield, single precision; null: the batch is elastic.
struct TangentField {
  using Batch = std::array<J2Tangent<Simd<float>>, points_per_hex>;
  std::vector<std::unique_ptr<Batch>> batch;
};

template <typename Number>
class HexOperator {
 public:
  /// positions: of the nodes, ghosts up to date; in double precision they must outlive the operator.
  HexOperator(const MeshLevel& level, const Vector<double>& positions, const CellMaterials& materials);

  /// Interface stiffness and tangents that vmult adds; null: none. Not owned.
  void set_interface(const InterfaceOperator* interface) { interface_ = interface; }
  void set_tangent(const TangentField* tangent) { tangent_ = tangent; }
  /// A spring [N/m] from the driven plane to the ground (force control): grounds a body that no contact holds
  /// yet.
  void set_driven_spring(double stiffness) { driven_spring_ = static_cast<Number>(stiffness); }

  /// Takes elastic cells as parallelepipeds where they nearly are, which is several times faster: for a
  /// preconditioner. In single precision only.
  void take_cells_as_parallelepipeds();

  /// Leaves batches out of vmult: all whose flag is not set. Its result is then that of K at nodes without
  /// such batches, and where src is 0 around them.
  void set_part(std::vector<char> batches);

  /// dst = (C^T (K + G^T E G) C) src.
  void vmult(Vector<Number>& dst, const Vector<Number>& src) const { multiply(Parts::all, dst, src); }
  /// The same without the bodies (K = 0), and of the bodies alone (no interface, no spring).
  void vmult_of_contact(Vector<Number>& dst, const Vector<Number>& src) const {
    multiply(Parts::contact, dst, src);
  }
  void vmult_of_bodies(Vector<Number>& dst, const Vector<Number>& src) const {
    multiply(Parts::bodies, dst, src);
  }
  /// The same: the matrix is symmetric.
  void Tvmult(Vector<Number>& dst, const Vector<Number>& src) const { vmult(dst, src); }
  /// Diagonal of the condensed operator without plastic tangents, 1 at constrained unknowns. The bodies' part
  /// is kept from call to call.
  Vector<Number> diagonal() const;

  /// Stiffness matrices of the cells of a batch: entry [i][j], unknown 3 * vertex + component, one value per
  /// lane [N/m].
  using CellMatrices = std::array<std::array<Simd<Number>, 24>, 24>;
  void cell_matrices(int batch, CellMatrices& matrices) const;

  dealii::types::global_dof_index m() const { return level_.size(); }
  dealii::types::global_dof_index n() const { return level_.size(); }
  Number el(dealii::types::global_dof_index, dealii::types::global_dof_index) const { return Number(0); }
  /// As deal.II's smoothers ask for it.
  void initialize_dof_vector(Vector<Number>& vector) const { level_.initialise(vector); }
  const MeshLevel& level() const { return level_; }
  /// Of the local nodes [m].
  const Number* positions() const { return positions_; }

 private:
  enum class Parts { all, bodies, contact };
  void multiply(Parts parts, Vector<Number>& dst, const Vector<Number>& src) const;
  void find_bulk_diagonal() const;
  bool yields(int batch) const { return tangent_ && !tangent_->batch.empty() && tangent_->batch[batch]; }
  void apply_batch(int batch, const Number* x, Number* y) const;
  void apply_run(const int* first, const int* last, const Number* x, Number* y) const;
  /// Replaces displacements [component][vertex] by nodal forces; `strain` holds the geometry.
  void forces_of(int batch, HexStrain<Simd<Number>>& strain, Simd<Number> (&nodes)[3][8]) const;

  const MeshLevel& level_;
  std::vector<float> single_positions_;        ///< a copy; empty in double precision
  const Number* positions_;                    ///< local, owned then ghosts [m]
  std::size_t local_;                          ///< how many
  std::vector<Number> shear_, bulk_;           ///< by number of the material [Pa]
  mutable std::vector<Number> bulk_diagonal_;  ///< of K, local, not condensed [N/m]; empty: not yet asked for
  std::unique_ptr<ParallelepipedBatches> parallelepipeds_;  ///< null: all cells as they are
  const InterfaceOperator* interface_ = nullptr;
  const TangentField* tangent_ = nullptr;
  std::vector<char> part_;                      ///< by batch, whether it takes part in vmult; empty: all do
  std::optional<ConstraintLines::Part> lines_;  ///< constraints at the part's nodes and at the interface
  Number driven_spring_ = 0;
};

/// Gathers three components at the eight vertices of eight cells.
template <typename Number>
inline void load_nodes(const CellBatch& batch, const Number* field, Simd<Number> (&values)[3][8]) {
  for (int v = 0; v < 8; ++v)
    for (int l = 0; l < lanes; ++l) {
      const Number* node = field + 3 * batch.node[v][l];
      values[0][v][l] = node[0];
      values[1][v][l] = node[1];
      values[2][v][l] = node[2];
    }
}

/// Adds the values of a batch's nodes to a field.
template <typename Number>
inline void add_nodes(const CellBatch& batch, const Simd<Number> (&values)[3][8], Number* field) {
  for (int l = 0; l < batch.count; ++l)
    for (int v = 0; v < 8; ++v) {
      Number* node = field + 3 * batch.node[v][l];
      node[0] += values[0][v][l];
      node[1] += values[1][v][l];
      node[2] += values[2][v][l];
    }
}

}  // namespace asperity::fem
