#include "fem/solver/matrix_free_solver.h"

#include <algorithm>

#include "fem/solver/conjugate_gradients.h"

namespace asperity::fem {

namespace {

/// Without the negative stiffness of attraction that falls with the gap: the preconditioner stays positive
/// definite.
std::vector<RowStiffness> without_softening(std::vector<RowStiffness> rows) {
  for (RowStiffness& row : rows) row.normal = std::max(0.0, row.normal);
  return rows;
}

}  // namespace

MatrixFreeSolver::MatrixFreeSolver(const LinearProblem& problem)
    : level_(problem.level),
      interface_(problem.interface),
      rows_(problem.rows),
      matrix_(problem.level, problem.positions, problem.materials),
      multigrid_(problem.mesh, problem.level, problem.control, problem.geometry, problem.materials) {
  multigrid_.set_interface_rows(problem.rows, interface_.nodes(), {});
  matrix_.set_interface(&interface_);
}

void MatrixFreeSolver::recouple(const RigidMotion& motion) {
  multigrid_.set_interface_rows(rows_, interface_.nodes(), motion);
}

void MatrixFreeSolver::update(const std::vector<RowStiffness>& row_stiffness, const TangentField* tangent,
                              double driven_spring) {
  interface_.set_stiffness(row_stiffness);
  matrix_.set_tangent(tangent);
  matrix_.set_driven_spring(driven_spring);
  multigrid_.update(without_softening(row_stiffness), tangent, driven_spring);
}

int MatrixFreeSolver::solve(Vector<double>& x, const Vector<double>& rhs, double relative_tolerance) const {
  return conjugate_gradients(level_, matrix_, multigrid_, x, rhs, relative_tolerance);
}

}  // namespace asperity::fem
