// The matrix-free and the assembled path behind the same Newton iteration.
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "fem/contact/contact_solver.h"
#include "fem/interface/friction/coulomb.h"
#include "tests/fem/support/wavy_contact.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity::fem;

ContactSystemOptions options_with_backend(const std::string& backend, Control control = Control::force) {
  ContactSystemOptions o = asperity::test::wavy_contact(2e9, 5);
  o.control = control;
  o.backend = backend;
  return o;
}

asperity::test::Verified backends(const std::string& what) {
  return {"Solver", "assembled against matrix-free: " + what, "the other backend"};
}

/// Response to a load on the driven plane (force control) or on an interface node with half of the contacts
/// closed; of the first `turned` rows the other half.
Vector<double> response(ContactSystem& system, int& iterations, std::size_t turned = 0) {
  std::vector<RowStiffness> stiffness;
  for (std::size_t r = 0; r < system.rows().size(); ++r) {
    const auto& p = system.interface_points()[system.rows()[r].node];
    const bool closed = (std::hypot(p[0], p[1]) < 150e-9) != (r < turned);
    stiffness.push_back(closed ? system.areas()[r] * system.reduced_modulus() / 20e-9 : 0.0);
  }
  system.linear().update(stiffness, nullptr, 0.0);
  Vector<double> x, load;
  system.level().initialise(x);
  system.level().initialise(load);
  std::vector<double> forces(system.rows().size(), 0.0);
  forces[forces.size() / 2] = 1e-6;
  system.interface().add_forces(forces, load.begin());
  system.level().condense(load.begin());
  load.compress(dealii::VectorOperation::add);
  iterations = system.linear().solve(x, load, 1e-10);
  return x;
}

TEST(Backend_behaviour, assembled_matrix_is_the_matrix_free_operator) {
  for (const Control control : {Control::force, Control::displacement}) {
    ContactSystem free(MPI_COMM_WORLD, options_with_backend("matrix-free", control)),
        assembled(MPI_COMM_WORLD, options_with_backend("assembled", control));
    int iterations = 0, algebraic = 0;
    const auto x = response(free, iterations);
    auto difference = response(assembled, algebraic);
    difference.zero_out_ghost_values();
    difference -= x;
    const std::string what = std::string("response to one load, ") +
                             (control == Control::force ? "force" : "displacement") + " control";
    EXPECT_TRUE(backends(what).below(difference.linfty_norm() / x.linfty_norm(), 1e-7));
    EXPECT_LT(iterations, 60);
    EXPECT_LT(algebraic, 200);
    std::printf("matrix-free %d, assembled %d iterations\n", iterations, algebraic);
  }
}

/// Of a matrix in which few contacts have changed, and of one with most of them changed, which needs another.
TEST(Backend_behaviour, a_hierarchy_of_an_earlier_matrix_gives_the_response_of_its_own) {
  ContactSystem kept(MPI_COMM_WORLD, options_with_backend("assembled"));
  int iterations = 0;
  response(kept, iterations);
  const std::size_t rows = kept.rows().size();
  ASSERT_GT(rows, 100u);
  for (const std::size_t turned : {std::size_t{6}, rows}) {
    ContactSystem fresh(MPI_COMM_WORLD, options_with_backend("assembled"));
    int anew = 0;
    const auto expected = response(fresh, anew, turned);
    auto difference = response(kept, iterations, turned);
    difference.zero_out_ghost_values();
    difference -= expected;
    EXPECT_LT(difference.linfty_norm() / expected.linfty_norm(), 1e-7) << turned;
    // The old hierarchy takes more iterations, and one that was made anew as many.
    EXPECT_LT(iterations, 2 * anew + 8) << turned;
    EXPECT_EQ(iterations > anew, turned < rows) << turned;
    std::printf("%zu of %zu contacts changed: %d iterations, with a hierarchy of its own %d\n", turned, rows,
                iterations, anew);
  }
}

TEST(Backend_behaviour, both_give_the_same_states_of_yielding_bodies) {
  struct Outcome {
    double approach, peak, plastic;
  };
  const auto run = [](const std::string& backend) {
    ContactSystem system(MPI_COMM_WORLD, options_with_backend(backend));
    ContactSolverOptions accurate;
    accurate.residual_tolerance = 1e-7;
    accurate.penetration_tolerance = 1e-5;
    ContactSolver solver(system, accurate);
    ContactState state = solver.first_touch();
    Outcome o{};
    for (const double load : {100e-6, 30e-6}) {
      const Vector<double> before = state.displacement;
      if (load == 100e-6) solver.push_rigidly(state, 4e-9);
      EXPECT_TRUE(solver.solve(state, load).converged);
      o.plastic += system.bodies().accept(before, state.displacement).plastic_work;
    }
    o.approach = state.approach;
    o.peak = solver.resultants(state).largest_pressure;
    return o;
  };
  const Outcome free = run("matrix-free"), assembled = run("assembled");
  const std::string wavy = " of a wavy yielding contact after load and unload";
  EXPECT_TRUE(backends("approach" + wavy).below(assembled.approach / free.approach - 1, 1e-5));
  EXPECT_TRUE(backends("largest pressure" + wavy).below(assembled.peak / free.peak - 1, 1e-4));
  EXPECT_TRUE(backends("plastic work" + wavy).below(assembled.plastic / free.plastic - 1, 1e-4));
  EXPECT_GT(free.plastic, 0);
}

TEST(Backend_behaviour, both_give_the_same_shear_of_a_sliding_contact) {
  const auto run = [](const std::string& backend) {
    ContactSystemOptions o = options_with_backend(backend);
    o.tilted_normals = true;
    ContactSystem system(MPI_COMM_WORLD, o);
    ContactSolverOptions accurate;
    accurate.residual_tolerance = 1e-7;
    accurate.penetration_tolerance = accurate.slip_tolerance = 1e-4;
    accurate.friction = std::make_shared<Coulomb>(0.3);
    ContactSolver solver(system, accurate);
    ContactState state = solver.first_touch();
    solver.push_rigidly(state, 8e-9);
    std::array<double, 2> force{};
    for (int k = 0; k < 2; ++k) {
      const Vector<double> before = state.displacement;
      RigidMotion motion;
      motion.x = k == 0 ? 0.4e-9 : 12e-9;  // partial slip, then sliding to another coupling
      EXPECT_TRUE(solver.solve(state, 60e-6, motion).converged);
      system.bodies().accept(before, state.displacement);
      force[k] = solver.resultants(state).lateral_force[0];
    }
    return force;
  };
  const auto free = run("matrix-free"), assembled = run("assembled");
  EXPECT_LT(free[0], 0.9 * free[1]);
  asperity::test::Largest difference;
  for (int k = 0; k < 2; ++k) difference.count(assembled[k] / free[k] - 1);
  EXPECT_TRUE(backends("lateral force of partial slip and of sliding").below(difference, 1e-4));
}

TEST(Backend_behaviour, an_unknown_name_is_refused) {
  EXPECT_THROW(ContactSystem(MPI_COMM_WORLD, options_with_backend("direct")), asperity::InputError);
}

}  // namespace
