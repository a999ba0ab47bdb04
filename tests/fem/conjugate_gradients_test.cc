// Conjugate gradients of our own beside deal.II's, on the same contact with the same preconditioner.
#include "fem/solver/conjugate_gradients.h"

#include <deal.II/lac/solver_cg.h>
#include <gtest/gtest.h>

#include <cmath>

#include "fem/solver/matrix_free_solver.h"
#include "tests/fem/support/small_contact.h"

namespace {

using namespace asperity::fem;

/// The solver of a contact whose rows are all closed.
MatrixFreeSolver& with_closed_rows(ContactSystem& system) {
  auto& solver = dynamic_cast<MatrixFreeSolver&>(system.linear());
  std::vector<RowStiffness> stiffness;
  for (const double area : system.areas()) stiffness.emplace_back(area * system.reduced_modulus() / 20e-9);
  constexpr double no_spring = 0;
  solver.update(stiffness, nullptr, no_spring);
  return solver;
}

/// Components c sin(w i), as forces of a level.
void set_forces(const MeshLevel& level, double c, double w, Vector<double>& forces) {
  for (unsigned i = 0; i < forces.locally_owned_size(); ++i) forces.local_element(i) = c * std::sin(w * i);
  level.condense(forces.begin());
}

TEST(ConjugateGradients_other_code, iterations_and_solution_are_those_of_deal_ii) {
  ContactSystem system(MPI_COMM_WORLD, asperity::test::small_contact());
  MatrixFreeSolver& solver = with_closed_rows(system);

  const MeshLevel& level = system.level();
  Vector<double> rhs, ours, theirs;
  for (auto* v : {&rhs, &ours, &theirs}) level.initialise(*v);
  set_forces(level, 1e-6, 0.31, rhs);

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

/// The operator less a stiffness along one vector, which makes it indefinite.
struct Softened {
  const HexOperator<double>& matrix;
  const Vector<double>& along;
  double stiffness;

  void vmult(Vector<double>& to, const Vector<double>& from) const {
    matrix.vmult(to, from);
    to.add(-stiffness * (along * from), along);
  }
};

TEST(ConjugateGradients_behaviour, an_indefinite_matrix_gives_a_direction_of_descent_at_once) {
  ContactSystem system(MPI_COMM_WORLD, asperity::test::small_contact());
  MatrixFreeSolver& solver = with_closed_rows(system);
  const MeshLevel& level = system.level();
  Vector<double> rhs, along, whole, x, product;
  for (auto* v : {&rhs, &along, &whole, &x, &product}) level.initialise(*v);
  set_forces(level, 1e-6, 0.31, rhs);
  set_forces(level, 1, 0.07, along);
  constexpr double tolerance = 1e-8;
  const int iterations =
      conjugate_gradients(level, solver.matrix(), solver.multigrid(), whole, along, tolerance);
  // along . A^-1 along: a stiffness of more than its inverse is what the matrix does not have.
  const double compliance = whole * along;
  for (const double share : {0.5, 2.0, 1e6}) {
    const Softened softened{solver.matrix(), along, share / compliance};
    const int made = conjugate_gradients(level, softened, solver.multigrid(), x, rhs, tolerance);
    EXPECT_GT(rhs * x, 0) << share;
    softened.vmult(product, x);
    product -= rhs;
    const bool is_solved = product.l2_norm() < 2 * tolerance * rhs.l2_norm();
    EXPECT_EQ(is_solved, share < 1) << share << " after " << made;
    EXPECT_LE(made, 2 * iterations) << share;
  }
}

}  // namespace
