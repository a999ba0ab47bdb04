// Conjugate gradients of our own beside deal.II's, on the same contact with the same preconditioner.
#include "fem/solver/conjugate_gradients.h"

#include <deal.II/lac/solver_cg.h>
#include <gtest/gtest.h>

#include <cmath>

#include "fem/solver/matrix_free_solver.h"
#include "tests/fem/support/small_contact.h"

namespace {

using namespace asperity::fem;

TEST(ConjugateGradients_other_code, iterations_and_solution_are_those_of_deal_ii) {
  ContactSystem system(MPI_COMM_WORLD, asperity::test::small_contact());
  auto& solver = dynamic_cast<MatrixFreeSolver&>(system.linear());
  std::vector<RowStiffness> stiffness;
  for (const double area : system.areas()) stiffness.emplace_back(area * system.reduced_modulus() / 20e-9);
  constexpr double no_spring = 0;
  solver.update(stiffness, nullptr, no_spring);

  const MeshLevel& level = system.level();
  Vector<double> rhs, ours, theirs;
  for (auto* v : {&rhs, &ours, &theirs}) level.initialise(*v);
  for (unsigned i = 0; i < rhs.locally_owned_size(); ++i) rhs.local_element(i) = 1e-6 * std::sin(0.31 * i);
  level.condense(rhs.begin());

  constexpr double tolerance = 1e-6;
  const int iterations =
      conjugate_gradients(level, solver.matrix(), solver.multigrid(), ours, rhs, tolerance);
  dealii::ReductionControl control(LinearSolver::most_iterations, 0, tolerance, false, false);
  dealii::SolverCG<Vector<double>> reference(control);
  reference.solve(solver.matrix(), theirs, rhs, solver.multigrid());
  level.distribute(theirs.begin());

  EXPECT_GT(iterations, 3);
  EXPECT_EQ(iterations, static_cast<int>(control.last_step()));
  theirs -= ours;
  EXPECT_LT(theirs.linfty_norm(), 1e-6 * ours.linfty_norm());
  // Nothing to do: no iteration, and what stood there is gone.
  Vector<double> nothing = rhs;
  nothing = 0;
  EXPECT_EQ(conjugate_gradients(level, solver.matrix(), solver.multigrid(), ours, nothing, tolerance), 0);
  EXPECT_EQ(ours.linfty_norm(), 0);
}

}  // namespace
