// Geometric multigrid V-cycle in single precision for the bulk of both bodies and the interface between them.
//
// Levels are forests refined by the same rule up to a rising depth: nested meshes of their own, with hanging
// nodes. Chebyshev-Jacobi smoothing; a dense Cholesky factor on the coarsest level. The bulk is rediscretised
// elastically, the interface enters through G_level (exact on every level).
#pragma once

#include <Eigen/Cholesky>
#include <memory>
#include <vector>

#include "fem/solver/chebyshev.h"
#include "fem/solver/hex_operator.h"
#include "fem/solver/level_transfer.h"

namespace asperity::fem {

class Multigrid {
 public:
  /// finest: level of the full mesh of `options`; coarser levels are made here.
  Multigrid(const meshing::ContactMeshOptions& options, const MeshLevel& finest, Control control,
            const meshing::RoughGeometry& geometry, const CellMaterials& materials);

  /// Builds the interface on every level from the rows of the finest mesh, or builds it anew, with the
  /// particle moved by `motion`.
  void set_interface_rows(const std::vector<GapRow>& rows, const InterfaceNodes& fine_nodes,
                          const RigidMotion& motion);

  /// Takes new slopes of the interface to every level.
  void set_interface_slopes(const std::vector<GapRow>& rows) {
    for (auto& level : level_) level.interface->set_slopes(rows);
  }

  /// Adapts to a new active set (stiffness per row [N/m]), tangent of the finest level and driven spring.
  void update(const std::vector<RowStiffness>& row_stiffness, const TangentField* tangent,
              double driven_spring);

  /// dst = approximate inverse times src, which is 0 at constrained unknowns; dst is unspecified there.
  void vmult(Vector<double>& dst, const Vector<double>& src) const;

  int levels() const { return static_cast<int>(level_.size()); }

 private:
  struct Level {
    const MeshLevel* mesh;
    std::unique_ptr<MeshLevel> owned_mesh;
    std::unique_ptr<HexOperator<float>> matrix;
    std::unique_ptr<InterfaceOperator> interface;
    Chebyshev smoother;
    std::unique_ptr<LevelTransfer> transfer;  ///< from the next coarser level
    mutable Vector<float> solution, defect, scratch;
  };
  void find_coarse_unknowns();
  void cycle(int level) const;
  /// Of the coarsest level's matrix that `multiply` stands for: columns of some of its free unknowns, in
  /// their places.
  template <typename Multiply>
  Eigen::MatrixXd coarse_columns(const std::vector<int>& of, const Multiply& multiply) const;
  void factor_coarsest();
  void solve_coarsest() const;

  std::vector<Level> level_;  ///< coarsest first
  std::vector<dealii::types::global_dof_index> coarse_free_;
  std::vector<int> coarse_at_contact_;  ///< of these, numbers of those that move the interface or the drive
  double roll_ = 0;                     ///< [rad]
  Eigen::MatrixXd coarse_bodies_;       ///< of the bodies alone [N/m]; empty: to be made
  Eigen::LLT<Eigen::MatrixXd> coarse_factor_;
};

}  // namespace asperity::fem
