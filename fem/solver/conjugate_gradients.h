// Preconditioned conjugate gradients on the unknowns of a mesh level, for all linear solvers.
//
// Hestenes, Stiefel (1952). deal.II's own leave the loops over vectors to threads of another pool than the
// operators', which then compete for the cores.
#pragma once

#include <deal.II/lac/vector_memory.h>

#include <cmath>

#include "core/threads.h"
#include "fem/levels/mesh_level.h"
#include "fem/solver/linear_solver.h"

namespace asperity::fem {

/// See LinearSolver::solve. The preconditioner may leave anything at constrained unknowns.
/// relative_tolerance [-].
template <typename Matrix, typename Preconditioner>
int conjugate_gradients(const MeshLevel& level, const Matrix& matrix, const Preconditioner& preconditioner,
                        Vector<double>& x, const Vector<double>& rhs, double relative_tolerance) {
  const int count = static_cast<int>(rhs.locally_owned_size());
  const auto sum_of_ranks = [&](double own) {
    return dealii::Utilities::MPI::sum(own, level.communicator());
  };
  dealii::GrowingVectorMemory<Vector<double>> memory;
  const dealii::VectorMemory<Vector<double>>::Pointer residual(memory), preconditioned(memory),
      direction(memory), product(memory);
  for (const auto* vector : {&residual, &preconditioned, &direction, &product}) level.initialise(**vector);
  double* r = residual->begin();
  double* p = direction->begin();
  double* solution = x.begin();
  const double* z = preconditioned->begin();
  const double* q = product->begin();

  const double* right = rhs.begin();
  double square = sum_of_ranks(sum_over_entries(count, [=](int i) {
    solution[i] = 0;
    r[i] = right[i];
    return right[i] * right[i];
  }));
  const double goal = relative_tolerance * std::sqrt(square);
  double before = 1;
  int made = 0;
  while (std::sqrt(square) > goal && made < LinearSolver::most_iterations) {
    preconditioner.vmult(*preconditioned, *residual);
    const double now = sum_of_ranks(sum_over_entries(count, [=](int i) { return r[i] * z[i]; }));
    const double beta = made == 0 ? 0 : now / before;
    before = now;
    for_entries(count, [=](int i) { p[i] = z[i] + beta * p[i]; });
    matrix.vmult(*product, *direction);
    const double curvature = sum_of_ranks(sum_over_entries(count, [=](int i) { return p[i] * q[i]; }));
    if (curvature <= 0) {
      // Negative curvature: the matrix is indefinite. The iterate so far is a direction of descent (Steihaug
      // 1983), and so is the preconditioned residual.
      if (made == 0) for_entries(count, [=](int i) { solution[i] = p[i]; });
      break;
    }
    const double step = now / curvature;
    square = sum_of_ranks(sum_over_entries(count, [=](int i) {
      solution[i] += step * p[i];
      r[i] -= step * q[i];
      return r[i] * r[i];
    }));
    ++made;
  }
  x.update_ghost_values();
  level.distribute(x.begin());
  return made;
}

}  // namespace asperity::fem
