// The whole experiment with normal load: programs of steps, balances, what is left after an interruption.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/atomic_file.h"
#include "core/csv.h"
#include "core/error.h"
#include "fem/solve_case.h"
#include "tests/fem/support/solved_experiment.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;
using asperity::test::solve_experiment;
using asperity::test::SolvedExperiment;

CaseInput coarse_case() {
  CaseInput c;
  c.file = "test.prm";
  c.radius = 8.5e-6;
  c.particle.youngs_modulus = 71e9, c.particle.poisson_ratio = 0.17;
  c.particle.parameters["Yield stress"] = 1.2e9;
  c.particle.topography = "generated(rms=0.7 nm, hurst=0.8, rolloff=300 nm, cutoff=150 nm, seed=1)";
  c.substrate.youngs_modulus = 179e9, c.substrate.poisson_ratio = 0.25;
  c.substrate.parameters["Yield stress"] = 2.5e9;
  c.substrate.topography = "generated(rms=1.5 nm, hurst=0.8, rolloff=300 nm, cutoff=150 nm, seed=2)";
  c.experiment.normal_load = 100e-6;
  c.experiment.load_steps = 4;
  c.experiment.unload_steps = 3;
  c.mesh.interface_spacing = 37e-9;
  c.mesh.layers = 2;
  c.solver.threads = 1;
  c.output.fields = false;
  return c;
}

void expect_same(const SolvedExperiment& a, const SolvedExperiment& b, double tolerance) {
  ASSERT_EQ(a.history.rows.size(), b.history.rows.size());
  test::Largest difference;
  for (const std::string column :
       {"normal_force [N]", "normal_displacement [m]", "contact_area [m^2]", "max_pressure [Pa]",
        "plastic_work [J]", "elastic_energy [J]", "work [J]", "plastic_volume [m^3]", "load_step_error [m]"})
    for (std::size_t k = 0; k < a.history.rows.size(); ++k) {
      const double before = a.at(column, k), after = b.at(column, k);
      difference.count(before == after ? 0 : (after - before) / before);
    }
  difference.count(b.result["effective"]["normal_stiffness"]["value"].get<double>() /
                       a.result["effective"]["normal_stiffness"]["value"].get<double>() -
                   1);
  const test::Verified verified{
      "Interruption", "stopped after a step and resumed: eight columns of the history, normal stiffness",
      "the uninterrupted run"};
  EXPECT_TRUE(verified.below(difference, tolerance));
}

void expect_balance(const SolvedExperiment& s) {
  ASSERT_EQ(s.history.rows.size(), 7u);
  const auto verified = [](const std::string& what) {
    return test::Verified{"Experiment", "rough yielding contact, 7 steps: " + what, "balance"};
  };
  EXPECT_TRUE(verified("energy left open").below(100 * s.result["balance"]["energy"].get<double>(), 1, "%"));
  EXPECT_TRUE(verified("force left open, of the load").below(s.result["balance"]["force"], 1e-6));
  EXPECT_TRUE(verified("moment left open, of load times radius").below(s.result["balance"]["moment"], 1e-9));
  EXPECT_TRUE(verified("force reached against force asked for")
                  .below(s.at("normal_force [N]", 3) / 100e-6 - 1, 1e-6));
  EXPECT_GT(s.at("plastic_work [J]", 3), 0);
  for (std::size_t k = 0; k + 1 < s.history.rows.size(); ++k) {
    const double real_area = s.at("contact_area [m^2]", k);
    EXPECT_NEAR(s.at("mean_pressure [Pa]", k) * real_area / s.at("normal_force [N]", k), 1, 1e-8)
        << "step " << k + 1;
  }
  EXPECT_NEAR(s.result["effective"]["mean_pressure"]["value"].get<double>() / s.at("mean_pressure [Pa]", 3),
              1, 1e-8);
  double before = 0;
  for (const double dissipated : s.history.numbers("dissipated_energy [J]")) {
    EXPECT_GE(dissipated, before);
    before = dissipated;
  }
  EXPECT_GT(s.at("normal_displacement [m]", 6), 0) << "yielding leaves an imprint";
}

void expect_area_approach_imprint_and_each_body(const SolvedExperiment& s) {
  const auto& effective = s.result["effective"];
  const auto value = [&](const char* name) { return effective[name]["value"].get<double>(); };
  constexpr std::size_t peak = 3, last = 6;
  EXPECT_NEAR(s.at("contact_radius [m]", peak) / std::sqrt(s.at("contact_area [m^2]", peak) / M_PI), 1, 1e-8)
      << "nine digits are written";
  EXPECT_GT(s.at("pressure_radius [m]", peak), s.at("contact_radius [m]", peak))
      << "a rough contact spreads further than its area";
  // Asperities meet before the mean planes do.
  EXPECT_LT(value("first_touch"), 0);
  EXPECT_NEAR(value("approach_from_first_touch") - value("approach"), -value("first_touch"), 1e-15);
  EXPECT_NEAR(s.at("mean_plane_approach [m]", 0) - s.at("normal_displacement [m]", 0), value("first_touch"),
              1e-15);
  EXPECT_GT(value("residual_imprint"), 0);
  EXPECT_LT(value("residual_imprint"), s.at("normal_displacement [m]", last))
      << "what elastic bodies would keep of the last load is not of the imprint";
  EXPECT_GE(s.at("spots", peak), 1);
  EXPECT_GT(s.at("contact_perimeter [m]", peak), 2 * M_PI * s.at("contact_radius [m]", peak));
  EXPECT_LT(std::hypot(s.at("load_centre_x [m]", peak), s.at("load_centre_y [m]", peak)),
            s.at("contact_radius [m]", peak));
  // The particle yields at 1.2 GPa, the substrate at 2.5: each says its own.
  EXPECT_NEAR(s.at("particle_von_mises [Pa]", peak), 1.2e9, 1e-3 * 1.2e9);
  EXPECT_NEAR(std::max(s.at("particle_von_mises [Pa]", peak), s.at("substrate_von_mises [Pa]", peak)) /
                  s.at("largest_von_mises [Pa]", peak),
              1, 1e-8);
  EXPECT_GT(s.at("particle_plastic_strain", peak), s.at("substrate_plastic_strain", peak));
  EXPECT_GT(s.at("load_step_error [m]", peak), 0);
}

/// One solution for all that is asked of it.
TEST(NormalExperiment_analytic, rough_yielding_contact_balances_energy_force_and_moment) {
  const test::TemporaryFolder folder;
  const SolvedExperiment s = solve_experiment(coarse_case(), folder.path);
  expect_balance(s);
  expect_area_approach_imprint_and_each_body(s);
}

TEST(NormalExperiment_behaviour, steps_that_fail_are_halved_and_reach_the_same_states) {
  const test::TemporaryFolder folder, halving;
  CaseInput c = coarse_case();
  c.experiment.unload = false;
  c.experiment.load_step_error = 0;  // halved for the solver alone
  const SolvedExperiment whole = solve_experiment(c, folder.path);
  const auto needed = whole.history.numbers("newton_iterations");
  c.solver.newton_steps = static_cast<int>(*std::max_element(needed.begin(), needed.end())) - 1;
  const SolvedExperiment halved = solve_experiment(c, halving.path);
  const auto made = halved.history.numbers("newton_iterations");
  // The iterations of a step count those of the attempt that failed.
  EXPECT_GT(*std::max_element(made.begin(), made.end()), c.solver.newton_steps);
  ASSERT_EQ(halved.history.rows.size(), whole.history.rows.size());
  for (const std::string column :
       {"normal_force [N]", "normal_displacement [m]", "contact_area [m^2]", "elastic_energy [J]"})
    EXPECT_NEAR(halved.at(column, 3) / whole.at(column, 3), 1, 0.005) << column;
  // Where yielding is followed in smaller steps, a little more of it is seen.
  EXPECT_NEAR(halved.at("plastic_work [J]", 3) / whole.at("plastic_work [J]", 3), 1, 0.05);
  EXPECT_LT(halved.result["balance"]["energy"].get<double>(), 0.01);
}

/// A failure at one point, in a parallel loop, is one of the step.
TEST(NormalExperiment_behaviour, a_step_whose_material_has_no_answer_is_halved_and_named) {
  const test::TemporaryFolder folder;
  CaseInput input = coarse_case();
  BodyInput& body = input.particle;
  body.parameters["Hardening modulus"] = -3 * body.youngs_modulus / (2 * (1 + body.poisson_ratio));
  body.parameters["Voce saturation"] = 0.01 * body.parameters["Yield stress"],
  body.parameters["Voce rate"] = 10;
  input.solver.threads = 2;
  const std::string message = test::message_of<WorkError>([&] { solve_experiment(input, folder.path); });
  EXPECT_NE(message.find("return map"), std::string::npos) << message;
  EXPECT_NE(message.find("after halving the step six times"), std::string::npos) << message;
}

TEST(LoadStepChoice_analytic,
     steps_of_a_perfectly_plastic_contact_state_what_they_leave_and_are_divided_until_it_is_what_is_asked) {
  // A substrate of 0.4 GPa under a sphere that stays elastic: 29 times the load of first yield.
  CaseInput c = coarse_case();
  c.particle.topography = c.substrate.topography = "smooth";
  c.particle.parameters["Yield stress"] = std::numeric_limits<double>::infinity();
  c.substrate.parameters["Yield stress"] = 0.4e9;
  c.experiment.normal_load = 1e-3, c.experiment.unload = false;
  c.mesh.interface_spacing = 90e-9;
  const auto solved = [&](int steps, double share) {
    const test::TemporaryFolder folder;
    c.experiment.load_steps = steps, c.experiment.load_step_error = share;
    return solve_experiment(c, folder.path);
  };
  const SolvedExperiment few = solved(3, 0), more = solved(6, 0), many = solved(12, 0),
                         divided = solved(3, 0.005);
  ASSERT_EQ(divided.history.rows.size(), 3u) << "what lies between recorded steps is not recorded";
  const auto approach = [](const SolvedExperiment& s) {
    return s.at("normal_displacement [m]", s.history.rows.size() - 1);
  };
  // Of first order, so that twice as many steps tell how far they still are.
  const double limit = 2 * approach(many) - approach(more);
  const auto error = [&](const SolvedExperiment& s) { return approach(s) / limit - 1; };
  const auto stated = [](const SolvedExperiment& s) {
    return s.result["effective"]["load_step_error"]["value"].get<double>();
  };
  for (const auto* s : {&few, &more, &many, &divided})
    std::printf("error of the approach %.5f, stated %.5f\n", error(*s), stated(*s));
  EXPECT_GT(error(few), 0.01) << "else nothing had to be divided";
  const auto verified = [](const std::string& what) {
    return test::Verified{"Stated errors",
                          what + ", perfectly plastic, 29 times the load of first yield, a/h 5",
                          "twice as many load steps, extrapolated"};
  };
  for (const auto* s : {&few, &more, &many}) {
    const std::string steps = std::to_string(s->history.rows.size());
    const double share = stated(*s) / error(*s);
    EXPECT_TRUE(verified("error of the approach by " + steps + " load steps, stated over true")
                    .between(share, 0.8, 2));
  }
  EXPECT_LT(stated(divided), 0.0055);
  EXPECT_TRUE(verified("approach, 3 load steps that were divided").within(approach(divided), limit, 0.005));
}

TEST(NormalExperiment_behaviour, a_second_cycle_repeats_the_unloading_path_and_holding_changes_nothing) {
  const test::TemporaryFolder folder;
  CaseInput c = coarse_case();
  c.experiment.cycles = 2;
  c.experiment.hold_steps = 1;
  c.experiment.load_steps = 3;
  const SolvedExperiment s = solve_experiment(c, folder.path);
  ASSERT_EQ(s.history.rows.size(), 14u);  // (3 + 1 + 3) twice
  EXPECT_NEAR(s.at("normal_displacement [m]", 3) / s.at("normal_displacement [m]", 2), 1, 1e-4);
  // Without hardening, the second cycle yields hardly more than the first left to do.
  const auto verified = [](const std::string& what) {
    return test::Verified{"Experiment", "second of two cycles with hold: " + what, "the first"};
  };
  const double first = s.at("plastic_work [J]", 6), second = s.at("plastic_work [J]", 13) - first;
  EXPECT_TRUE(verified("plastic work over the first cycle's").below(100 * second / first, 5, "%"));
  EXPECT_TRUE(verified("approach at the peak")
                  .within(s.at("normal_displacement [m]", 9), s.at("normal_displacement [m]", 2), 0.01));
  EXPECT_LT(s.result["balance"]["energy"].get<double>(), 0.01);
}

TEST(NormalExperiment_behaviour, under_displacement_control_passes_through_the_same_states) {
  const test::TemporaryFolder given, driven;
  CaseInput c = coarse_case();
  c.experiment.load_steps = 2, c.experiment.unload = false;
  const SolvedExperiment force = solve_experiment(c, given.path);
  c.experiment.control = ExperimentInput::Control::displacement;
  c.experiment.normal_approach = force.at("driven_displacement [m]", 1);
  c.mesh.contact_region = force.result["mesh"]["contact_region"];
  c.experiment.load_steps = 4;
  const SolvedExperiment displacement = solve_experiment(c, driven.path);
  EXPECT_NEAR(displacement.at("driven_displacement [m]", 3) / c.experiment.normal_approach, 1, 1e-12);
  // Yielding depends on the path a little: four steps against two.
  EXPECT_NEAR(displacement.at("normal_force [N]", 3) / force.at("normal_force [N]", 1), 1, 0.01);
  EXPECT_NEAR(displacement.result["effective"]["normal_stiffness"]["value"].get<double>() /
                  force.result["effective"]["normal_stiffness"]["value"].get<double>(),
              1, 0.02);
}

TEST(NormalExperiment_behaviour, stopped_after_any_step_resumes_to_the_same_answer) {
  const test::TemporaryFolder whole, halved;
  CaseInput c = coarse_case();
  c.experiment.load_steps = 3, c.experiment.unload_steps = 2;
  const SolvedExperiment expected = solve_experiment(c, whole.path);
  int lines = 0;
  SolveOptions options;
  options.output = halved.path;
  options.progress = [&](const std::string& line) {
    if (line.rfind("step 4/", 0) == 0 && ++lines) throw std::runtime_error("stopped");
  };
  EXPECT_THROW(solve_case(c, options), std::runtime_error);
  EXPECT_EQ(read_csv(halved.path / "history.csv").rows.size(), 4u);
  EXPECT_FALSE(std::filesystem::exists(halved.path / "result.json"));
  expect_same(expected, solve_experiment(c, halved.path, true), 1e-6);
}

}  // namespace
