// The same contact on one rank and on all ranks of MPI. ctest runs these tests under mpirun.
#include <gtest/gtest.h>

#include <cmath>

#include "fem/contact/contact_solver.h"
#include "fem/interface/friction/coulomb.h"
#include "fem/solver/matrix_free_solver.h"
#include "tests/fem/support/wavy_contact.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity::fem;

ContactSystemOptions wavy_options() { return asperity::test::wavy_contact(2e9); }

/// Displacements that depend on the place only.
Vector<double> wavy_displacement(const ContactSystem& system) {
  Vector<double> x = system.positions();
  x.zero_out_ghost_values();
  for (unsigned i = 0; i < x.locally_owned_size(); ++i)
    x.local_element(i) = std::sin(1e7 * x.local_element(i));
  for (const int c : system.level().constrained())
    if (c < static_cast<int>(x.locally_owned_size())) x.local_element(c) = 0;
  return x;
}

/// A quantity of all ranks against that of one; a rank against itself is no row.
testing::AssertionResult same_on_all_ranks(const std::string& what, double all, double one, double asked) {
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1)
    return testing::AssertionResult(std::abs(all / one - 1) <= asked) << what;
  return asperity::test::Verified{"Solver", "ranks of MPI against one: " + what, "one rank"}.below(
      all / one - 1, asked);
}

struct Products {
  double energy, diagonal, cycled, asymmetry, constrained;
};

Products products(MPI_Comm communicator) {
  ContactSystem system(communicator, wavy_options());
  std::vector<RowStiffness> stiffness;
  for (const double area : system.areas()) stiffness.push_back(area * system.reduced_modulus() / 20e-9);
  auto& solver = dynamic_cast<MatrixFreeSolver&>(system.linear());
  solver.update(stiffness, nullptr, 0);
  const Vector<double> x = wavy_displacement(system);
  Vector<double> y = x, ax, ay, bx;
  for (auto* v : {&ax, &ay, &bx}) system.level().initialise(*v);
  for (unsigned i = 0; i < y.locally_owned_size(); ++i) y.local_element(i) = std::pow(x.local_element(i), 3);
  solver.matrix().vmult(ax, x);
  solver.matrix().vmult(ay, y);
  Products p;
  p.energy = x * ax;
  p.asymmetry = std::abs(x * ay - y * ax) / (ax.l2_norm() * y.l2_norm());
  const auto diagonal = solver.matrix().diagonal();
  p.diagonal = diagonal.l1_norm();
  p.constrained = 0;
  for (const int c : system.level().constrained())
    if (c < static_cast<int>(ax.locally_owned_size()))
      p.constrained = std::max(p.constrained, std::abs(ax.local_element(c)));
  p.constrained = dealii::Utilities::MPI::max(p.constrained, communicator) / ax.linfty_norm();
  solver.multigrid().vmult(bx, ax);
  p.cycled = bx * ax;
  return p;
}

TEST(Parallel_behaviour, operator_and_cycle_are_those_of_one_rank) {
  const Products one = products(MPI_COMM_SELF), all = products(MPI_COMM_WORLD);
  EXPECT_TRUE(same_on_all_ranks("operator", all.energy, one.energy, 1e-12));
  EXPECT_TRUE(same_on_all_ranks("its diagonal", all.diagonal, one.diagonal, 1e-12));
  EXPECT_LT(all.asymmetry, 1e-13);
  EXPECT_EQ(all.constrained, 0);
  // In single precision; sums of the smoother's eigenvalue estimate are those of the numbering.
  EXPECT_TRUE(same_on_all_ranks("cycle of multigrid", all.cycled, one.cycled, 1e-6));
}

TEST(Parallel_behaviour, loading_and_unloading_give_the_states_of_one_rank) {
  struct Outcome {
    double approach, area, peak, plastic, far_field;
    int active;
  };
  const auto run = [](MPI_Comm communicator) {
    ContactSystem system(communicator, wavy_options());
    ContactSolverOptions accurate;
    accurate.residual_tolerance = 1e-8;
    accurate.penetration_tolerance = 1e-5;
    accurate.largest_newton = accurate.largest_updates = 300;
    ContactSolver solver(system, accurate);
    Outcome o{};
    o.far_field = solver.far_field_compliance(150e-9);
    ContactState state = solver.first_touch();
    for (const double load : {40e-6, 100e-6, 30e-6}) {
      const Vector<double> before = state.displacement;
      if (load == 40e-6) solver.push_rigidly(state, 2e-9);
      EXPECT_TRUE(solver.solve(state, load).converged);
      o.plastic += system.bodies().accept(before, state.displacement).plastic_work;
    }
    const auto c = solver.resultants(state);
    EXPECT_NEAR(c.reaction_driven / c.force, 1, 1e-7);
    EXPECT_NEAR(c.reaction_fixed / c.force, 1, 1e-7);
    o.approach = state.approach, o.area = c.area, o.peak = c.largest_pressure, o.active = c.active;
    return o;
  };
  const Outcome one = run(MPI_COMM_SELF), all = run(MPI_COMM_WORLD);
  EXPECT_TRUE(same_on_all_ranks("far field", all.far_field, one.far_field, 1e-4));
  EXPECT_TRUE(same_on_all_ranks("approach after load and unload", all.approach, one.approach, 1e-7));
  EXPECT_EQ(all.active, one.active);
  EXPECT_TRUE(same_on_all_ranks("area", all.area, one.area, 1e-6));  // its edge follows the pressures
  EXPECT_TRUE(same_on_all_ranks("largest pressure", all.peak, one.peak, 1e-6));
  EXPECT_TRUE(same_on_all_ranks("plastic work", all.plastic, one.plastic, 1e-6));
  EXPECT_GT(one.plastic, 0);
}

TEST(Parallel_behaviour, sliding_with_friction_gives_the_states_of_one_rank) {
  struct Outcome {
    double shear, spread, reaction, work;
    int sticking;
  };
  const auto run = [](MPI_Comm communicator) {
    ContactSystemOptions o = wavy_options();
    o.tilted_normals = true;
    ContactSystem system(communicator, o);
    ContactSolverOptions accurate;
    accurate.residual_tolerance = 1e-7;
    accurate.penetration_tolerance = accurate.slip_tolerance = 1e-4;
    accurate.largest_newton = accurate.largest_updates = 300;
    accurate.friction = std::make_shared<Coulomb>(0.3);
    ContactSolver solver(system, accurate);
    ContactState state = solver.first_touch();
    solver.push_rigidly(state, 8e-9);
    Outcome outcome{};
    for (const double shift : {0.4e-9, 10e-9}) {
      const Vector<double> before = state.displacement;
      RigidMotion motion;
      motion.x = shift;
      const auto report = solver.solve(state, 60e-6, motion);
      EXPECT_TRUE(report.converged);
      system.bodies().accept(before, state.displacement);
      outcome.work += report.friction_work;
      if (shift == 0.4e-9) outcome.sticking = solver.resultants(state).sticking;
    }
    const auto r = solver.resultants(state);
    outcome.shear = r.lateral_force[0], outcome.reaction = r.lateral_reaction[0];
    for (std::size_t k = 0; k < state.shear[0].size(); ++k)
      outcome.spread += std::pow(state.shear[0][k] * system.areas()[k], 2);
    return outcome;
  };
  const Outcome one = run(MPI_COMM_SELF), all = run(MPI_COMM_WORLD);
  EXPECT_GT(one.sticking, 10);
  EXPECT_EQ(all.sticking, one.sticking);
  EXPECT_TRUE(same_on_all_ranks("lateral force", all.shear, one.shear, 1e-4));
  EXPECT_TRUE(same_on_all_ranks("squared tractions along", all.spread, one.spread, 1e-4));
  EXPECT_TRUE(same_on_all_ranks("friction's work", all.work, one.work, 1e-4));
  EXPECT_NEAR(all.reaction / all.shear, 1, 1e-6);
}

}  // namespace
