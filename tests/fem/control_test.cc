// Force and displacement control of the same contact.
#include <gtest/gtest.h>

#include <cmath>

#include "fem/contact/contact_solver.h"
#include "tests/fem/support/wavy_contact.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity::fem;

ContactSystemOptions options_under_control(Control control, double yield_stress) {
  ContactSystemOptions o = asperity::test::wavy_contact(yield_stress);
  o.control = control;
  return o;
}

ContactSolverOptions accurate() {
  ContactSolverOptions o;
  o.residual_tolerance = 1e-7;
  o.penetration_tolerance = 1e-5;
  return o;
}

struct Driver {
  explicit Driver(Control control, double yield_stress = std::numeric_limits<double>::infinity())
      : system(MPI_COMM_WORLD, options_under_control(control, yield_stress)),
        solver(system, accurate()),
        state(solver.first_touch()) {}
  ContactResultants to(double target) {
    const Vector<double> before = state.displacement;
    EXPECT_TRUE(solver.solve(state, target).converged);
    system.bodies().accept(before, state.displacement);
    return solver.resultants(state);
  }
  ContactSystem system;
  ContactSolver solver;
  ContactState state;
};

TEST(DisplacementControl_analytic, an_elastic_contact_unloads_on_its_loading_path) {
  Driver run(Control::displacement);
  const auto up = run.to(4e-9);
  run.to(8e-9);
  const auto down = run.to(4e-9);
  EXPECT_GT(up.force, 0);
  const auto verified = [](const char* what) {
    return asperity::test::Verified{"Solver", std::string("displacement control, elastic unloading: ") + what,
                                    "the loading path"};
  };
  EXPECT_TRUE(verified("force").below(down.force / up.force - 1, 1e-5));
  EXPECT_TRUE(verified("largest pressure").below(down.largest_pressure / up.largest_pressure - 1, 1e-4));
  EXPECT_EQ(down.active, up.active);
  EXPECT_NEAR(down.reaction_driven / down.force, 1, 1e-6);
  EXPECT_NEAR(down.reaction_fixed / down.force, 1, 1e-6);
}

TEST(DisplacementControl_behaviour, gives_the_states_of_force_control_of_yielding_bodies) {
  Driver given(Control::force, 2e9), driven(Control::displacement, 2e9);
  EXPECT_NEAR(driven.solver.far_field_compliance(150e-9) / given.solver.far_field_compliance(150e-9), 1,
              1e-4);
  given.solver.push_rigidly(given.state, 2e-9);
  asperity::test::Largest force, pressure, stiffness;
  for (const double load : {40e-6, 100e-6, 30e-6}) {
    const auto a = given.to(load), b = driven.to(given.state.approach);
    force.count(b.force / load - 1);
    pressure.count(b.largest_pressure / a.largest_pressure - 1);
    EXPECT_EQ(b.active, a.active) << load;
    stiffness.count(
        driven.solver.elastic_stiffness(driven.state) / given.solver.elastic_stiffness(given.state) - 1);
  }
  const auto verified = [](const char* what) {
    return asperity::test::Verified{
        "Solver", std::string("displacement control of yielding bodies, load and unload: ") + what,
        "force control"};
  };
  EXPECT_TRUE(verified("force").below(force, 1e-5));
  EXPECT_TRUE(verified("largest pressure").below(pressure, 1e-4));
  EXPECT_TRUE(verified("stiffness").below(stiffness, 1e-4));
}

TEST(DisplacementControl_behaviour, separates_without_losing_the_particle) {
  Driver run(Control::displacement, 2e9);
  run.to(6e-9);
  const auto apart = run.to(-1e-9);
  EXPECT_EQ(apart.force, 0);
  EXPECT_EQ(apart.active, 0);
  const auto again = run.to(6e-9);
  EXPECT_GT(again.force, 0);
}

}  // namespace
