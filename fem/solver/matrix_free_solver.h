// The matrix-free path: SIMD kernels for the operator, geometric multigrid in single precision as
// preconditioner.
#pragma once

#include "fem/solver/linear_solver.h"
#include "fem/solver/multigrid.h"

namespace asperity::fem {

class MatrixFreeSolver : public LinearSolver {
 public:
  explicit MatrixFreeSolver(const LinearProblem& problem);
  void update(const std::vector<RowStiffness>& row_stiffness, const TangentField* tangent,
              double driven_spring) override;
  void recouple(const RigidMotion& motion) override;
  void follow_slopes() override { multigrid_.set_interface_slopes(rows_); }
  int solve(Vector<double>& x, const Vector<double>& rhs, double relative_tolerance) const override;
  std::string description() const override {
    return std::to_string(multigrid_.levels()) + " multigrid levels";
  }

  HexOperator<double>& matrix() { return matrix_; }
  Multigrid& multigrid() { return multigrid_; }

 private:
  const MeshLevel& level_;
  InterfaceOperator& interface_;
  const std::vector<GapRow>& rows_;
  HexOperator<double> matrix_;
  Multigrid multigrid_;
};

}  // namespace asperity::fem
