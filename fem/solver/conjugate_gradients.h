// Preconditioned conjugate gradients on the unknowns of a mesh level, for all linear solvers.
#pragma once

#include <deal.II/lac/solver_cg.h>

#include "fem/levels/mesh_level.h"
#include "fem/solver/linear_solver.h"

namespace asperity::fem {

/// See LinearSolver::solve.
/// relative_tolerance [-].
template <typename Matrix, typename Preconditioner>
int conjugate_gradients(const MeshLevel& level, const Matrix& matrix, const Preconditioner& preconditioner,
                        Vector<double>& x, const Vector<double>& rhs, double relative_tolerance) {
  x = 0.0;
  if (rhs.l2_norm() == 0) return 0;
  dealii::ReductionControl control(LinearSolver::most_iterations, 0.0, relative_tolerance, false, false);
  dealii::SolverCG<Vector<double>> solver(control);
  try {
    solver.solve(matrix, x, rhs, preconditioner);
  } catch (const dealii::SolverControl::NoConvergence&) {
    // An inexact direction is still one of descent; the Newton iteration judges it by its residual.
  }
  x.update_ghost_values();
  level.distribute(x.begin());
  return static_cast<int>(control.last_step());
}

}  // namespace asperity::fem
