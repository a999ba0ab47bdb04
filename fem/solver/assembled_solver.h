// The assembled path: a sparse matrix (Trilinos Epetra) and smoothed aggregation (ML) that knows the six
// rigid-body modes.
//
// Slower than the matrix-free path and several times its memory, but independent of the mesh's hierarchy: the
// reference that checks it, and the choice for operators without a matrix-free kernel. Vanek, Mandel &
// Brezina, Computing 56 (1996) 179: aggregation with rigid-body modes as near-kernel.
#pragma once

#include <deal.II/lac/affine_constraints.h>

#include "fem/solver/linear_solver.h"

namespace asperity::fem {

class AssembledSolver : public LinearSolver {
 public:
  explicit AssembledSolver(const LinearProblem& problem);
  ~AssembledSolver() override;
  void update(const std::vector<RowStiffness>& row_stiffness, const TangentField* tangent,
              double driven_spring) override;
  /// Throws InputError for a motion that rolls.
  void recouple(const RigidMotion& motion) override;
  void follow_slopes() override {}  // read from the interface at each update
  int solve(Vector<double>& x, const Vector<double>& rhs, double relative_tolerance) const override;
  std::string description() const override;

 private:
  struct Trilinos;  // kept out of this header: it is slow to compile
  using Row = std::vector<std::pair<dealii::types::global_dof_index, double>>;

  void resolve_rows();
  void make_pattern();
  void make_rigid_body_modes();
  void assemble_bodies(const TangentField* tangent);
  void assemble_interface(const std::vector<RowStiffness>& row_stiffness);
  bool needs_new_hierarchy(const std::vector<RowStiffness>& row_stiffness) const;
  void make_hierarchy();

  LinearProblem problem_;
  dealii::AffineConstraints<double> constraints_;
  HexOperator<double> cells_;
  std::vector<std::array<Row, 3>> row_;  ///< components of this rank's share of the contact rows, constrained
                                         ///< nodes replaced by their masters
  std::vector<double> modes_;
  std::vector<RowStiffness> row_stiffness_;  ///< with which the hierarchy was made
  mutable int iterations_at_first_ = 0,      ///< of the first solution with it, of the last [-]
      iterations_at_last_ = 0;
  std::unique_ptr<Trilinos> trilinos_;
};

}  // namespace asperity::fem
