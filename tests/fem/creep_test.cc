// Creep under a held load of a body whose yield stress follows the strain rate.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/fem/support/solved_experiment.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;
using asperity::test::SolvedExperiment;

SolvedExperiment solved(const CaseInput& input) {
  const test::TemporaryFolder folder;
  return test::solve_experiment(input, folder.path);
}

constexpr std::size_t creep_loading = 3, creep_hold = 4;

/// Pressed in `load_time` [s] and held a thousand times as long.
CaseInput held_case(double sensitivity, double creep_time, double load_time) {
  CaseInput c;
  c.file = "test.prm";
  c.radius = 8.5e-6;
  c.particle.youngs_modulus = 71e9, c.particle.poisson_ratio = 0.17;
  c.substrate.youngs_modulus = 71e9, c.substrate.poisson_ratio = 0.17;
  c.substrate.parameters["Yield stress"] = 0.2e9;
  c.substrate.parameters["Rate sensitivity"] = sensitivity;
  c.substrate.parameters["Creep time"] = creep_time;
  c.experiment.normal_load = 100e-6;
  c.experiment.load_steps = creep_loading, c.experiment.hold_steps = creep_hold;
  c.experiment.load_time = load_time, c.experiment.hold_time = 1000 * load_time;
  c.experiment.unload = false;
  c.mesh.interface_spacing = 40e-9;
  c.mesh.layers = 2;
  c.solver.threads = 1;
  c.output.fields = false;
  return c;
}

TEST(Creep_analytic, is_of_the_ratio_of_times_alone_and_balances_energy) {
  const SolvedExperiment one = solved(held_case(0.1, 1e8, 1)), other = solved(held_case(0.1, 1e9, 10));
  const std::size_t last = creep_loading + creep_hold - 1;
  ASSERT_EQ(one.history.rows.size(), last + 1);
  for (std::size_t k = 0; k <= last; ++k)
    EXPECT_NEAR(other.at("normal_displacement [m]", k) / one.at("normal_displacement [m]", k), 1, 1e-6) << k;
  const auto grown = [&](std::size_t k) {
    return one.at("normal_displacement [m]", k) - one.at("normal_displacement [m]", k - 1);
  };
  for (std::size_t k = creep_loading; k <= last; ++k) {
    EXPECT_GT(grown(k), 0) << k;
    EXPECT_NEAR(one.at("normal_force [N]", k), 100e-6, 1e-10) << k;
    if (k > creep_loading) {
      EXPECT_LT(grown(k), grown(k - 1)) << k;
    }
  }
  EXPECT_GT(one.at("normal_displacement [m]", last),
            1.02 * one.at("normal_displacement [m]", creep_loading - 1));
  EXPECT_TRUE(
      (test::Verified{"Experiment", "contact that creeps under a held load: energy left open", "balance"}
           .below(100 * one.result["balance"]["energy"].get<double>(), 1, "%")));
}

TEST(Creep_analytic, is_none_where_the_rate_does_not_matter_and_ends_at_the_slow_limit) {
  CaseInput at_rest = held_case(0, 0, 1), slow = held_case(0.1, 1e-3, 1), fast = held_case(0.1, 1e8, 1);
  at_rest.substrate.parameters.erase("Rate sensitivity");
  at_rest.substrate.parameters.erase("Creep time");
  const SolvedExperiment rest = solved(at_rest), slowly = solved(slow), quickly = solved(fast);
  const std::size_t peak = creep_loading - 1, last = creep_loading + creep_hold - 1;
  EXPECT_NEAR(rest.at("normal_displacement [m]", last) / rest.at("normal_displacement [m]", peak), 1, 1e-6);
  EXPECT_NEAR(slowly.at("normal_displacement [m]", last) / rest.at("normal_displacement [m]", last), 1, 1e-3);
  EXPECT_LT(quickly.at("normal_displacement [m]", peak), 0.99 * rest.at("normal_displacement [m]", peak));
  EXPECT_LT(quickly.at("normal_displacement [m]", last), rest.at("normal_displacement [m]", last));
}

}  // namespace
