// The experiments of sliding and torsion, as `asperity solve` runs them.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/atomic_file.h"
#include "core/build_commit.h"
#include "core/csv.h"
#include "core/error.h"
#include "fem/case/case_setup.h"
#include "fem/output/checkpoint.h"
#include "fem/programs/program.h"
#include "fem/solve_case.h"
#include "tests/fem/support/solved_experiment.h"
#include "tests/fem/support/sphere_on_silicon.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;
using asperity::test::generated;
using asperity::test::solve_experiment;
using asperity::test::sphere_on_silicon;

CaseInput sliding(const std::string& substrate, double spacing) {
  CaseInput input = sphere_on_silicon("smooth", substrate, spacing, 300e-9);
  input.interface.parameters["Friction coefficient"] = 0.3;
  input.experiment.type = Motion::sliding;
  input.experiment.load_steps = 3;
  input.experiment.unload = false;
  input.output.fields = false;
  return input;
}

/// Energy left open of a whole experiment, of its largest work.
testing::AssertionResult balances_energy(const std::string& topic, const std::string& what,
                                         const test::SolvedExperiment& s, double per_cent) {
  return test::Verified{topic, what + ": energy left open", "balance"}.below(
      100 * s.result["balance"]["energy"].get<double>(), per_cent, "%");
}

/// Largest difference of a column of the history in `unit`; it has as many rows in both.
double largest_difference(const CsvTable& history, const CsvTable& other_history, const std::string& column,
                          double unit) {
  const auto one = history.numbers(column), other = other_history.numbers(column);
  EXPECT_EQ(one.size(), other.size());
  test::Largest difference;
  for (std::size_t k = 0; k < std::min(one.size(), other.size()); ++k)
    difference.count((other[k] - one[k]) / unit);
  return difference;
}

/// Dissipated energy of each mechanism, but for what the solver's tolerance leaves: nodes that stick creep by
/// it, either way.
void expect_never_to_fall(const CsvTable& history, const std::vector<std::string>& columns) {
  const double left = 1e-5 * history.numbers("dissipated_energy [J]").back();
  for (const auto& column : columns) {
    const auto values = history.numbers(column);
    for (std::size_t k = 1; k < values.size(); ++k)
      EXPECT_GE(values[k], values[k - 1] - left) << column << " in row " << k;
    EXPECT_GT(values.back(), 0) << column;
  }
}

TEST(Program_behaviour, of_sliding_begins_finely_and_comes_back) {
  ExperimentInput e;
  e.type = Motion::sliding;
  e.load_steps = 2, e.unload_steps = 2, e.distance = 100;
  const auto program = fem::make_program(e, {10, 0, 8, 0});
  EXPECT_EQ(program[1].load, 1);
  EXPECT_EQ(program[2].motion.x, 1);
  double farthest = 0, longest = 0;
  for (std::size_t k = 1; k < program.size(); ++k) {
    farthest = std::max(farthest, program[k].motion.x);
    longest = std::max(longest, std::abs(program[k].motion.x - program[k - 1].motion.x));
  }
  EXPECT_EQ(farthest, 100);
  EXPECT_LE(longest, 1.5 * 8);
  EXPECT_EQ(program.back().motion.x, 0);
  EXPECT_EQ(program.back().load, 1e-3);
  // A short way back: what comes before is the same, so that a solved case can be gone on with.
  e.return_distance = 30, e.unload = false;
  const auto shorter = fem::make_program(e, {10, 0, 8, 0});
  ASSERT_LT(shorter.size(), program.size());
  EXPECT_EQ(shorter.back().motion.x, 70);
  for (std::size_t k = 0; program[k].motion.x < 100; ++k) EXPECT_EQ(shorter[k].motion, program[k].motion);
}

/// Friction tilts the interface by a strain, mu p / E = 3e-3, and pressure acts along its normal: mu P is met
/// to that order.
TEST(Sliding_analytic, of_a_smooth_elastic_sphere_costs_mu_P_beyond_full_slip) {
  const test::TemporaryFolder folder;
  CaseInput input = sliding("smooth", 24e-9);
  input.substrate.youngs_modulus = 71e9, input.substrate.poisson_ratio = 0.17;
  input.mesh.contact_region = 320e-9;
  input.experiment.distance = 120e-9;
  input.experiment.reverse = false;
  const auto s = solve_experiment(input, folder.path);
  const std::string what = "smooth sphere slid by 120 nm, a/h 11";
  const auto verified = [&](const char* quantity, const char* source) {
    return test::Verified{"Sliding", what + ": " + quantity, source};
  };
  EXPECT_TRUE(
      verified("friction", "mu P").within(s.result["effective"]["sliding_friction"]["value"], 0.3, 0.01));
  EXPECT_LT(s.result["effective"]["sliding_friction"]["sd"], 0.01 * 0.3);
  const double expected = 8 * 8.2901e9 * 0.2593e-6;  // 8 G* a
  EXPECT_TRUE(verified("lateral stiffness", "8 G* a, Mindlin (1949)")
                  .within(s.result["effective"]["lateral_stiffness"]["value"], expected, 0.02));
  EXPECT_TRUE(verified("force left open, of the load", "balance").below(s.result["balance"]["force"], 1e-6));
  EXPECT_TRUE(balances_energy("Sliding", what, s, 1));
}

TEST(Sliding_analytic, of_rough_yielding_bodies_balances_energy_and_resumes_after_any_step) {
  const test::TemporaryFolder folder;
  CaseInput input = sliding(generated(1.0, 160, 3, "1.6 um"), 34e-9);
  input.particle.parameters["Yield stress"] = 1.5e9;  // its asperities reach 1.8 GPa
  input.experiment.distance = 10e-9;
  // Stopped after a few steps of sliding.
  const auto whole = test::solve_and_copy_after(input, folder.path / "whole", folder.path / "cut", 6);
  const std::string what = "rough yielding sliding, half a loop";
  EXPECT_LT(whole.result["balance"]["force"], 1e-5);
  EXPECT_TRUE(balances_energy("Sliding", what, whole, 1));
  const auto friction = whole.history.numbers("friction_work [J]"),
             plastic = whole.history.numbers("plastic_work [J]");
  int falls = 0;
  for (std::size_t k = 1; k < friction.size(); ++k)
    falls += !(friction[k] >= friction[k - 1] * (1 - 1e-9)) + !(plastic[k] >= plastic[k - 1] * (1 - 1e-9));
  EXPECT_TRUE(
      (test::Verified{"Sliding", what + ": steps in which friction's or plastic work falls", "none"}.below(
          falls, 0)));
  EXPECT_GT(plastic.back(), 0);
  // Another version's checkpoint is refused, not misread.
  const auto manifest = folder.path / "whole" / "checkpoint" / "latest.json";
  const Provenance ours{"", build_commit()};
  EXPECT_EQ(fem::objection_to_resume(manifest.parent_path(), ours), "");
  auto written = nlohmann::json::parse(read_file(manifest));
  written["format"] = "asperity-checkpoint/1";
  write_file_atomically(manifest, written.dump());
  EXPECT_NE(fem::objection_to_resume(manifest.parent_path(), ours), "");
  EXPECT_THROW(solve_experiment(input, folder.path / "whole", true), WorkError);
  const auto resumed = solve_experiment(input, folder.path / "cut", true);
  const double difference =
      largest_difference(whole.history, resumed.history, "lateral_force [N]", 0.3 * 100e-6);
  EXPECT_TRUE((
      test::Verified{"Interruption", "rough yielding sliding resumed: lateral force", "the uninterrupted run"}
          .below(difference, 1e-6, "mu P")));
}

/// Without friction: nodes in contact count as stuck for the lateral and the torsion stiffness.
TEST(PressedExperiment_analytic, tells_the_stiffness_of_all_three_directions) {
  const test::TemporaryFolder folder;
  CaseInput input = sliding("smooth", 20e-9);
  input.substrate.youngs_modulus = 71e9, input.substrate.poisson_ratio = 0.17;
  input.experiment.type = Motion::normal;
  input.experiment.distance = 0;
  input.interface = {};
  input.mesh.contact_region = 320e-9;
  const auto s = solve_experiment(input, folder.path);
  const double a = 0.2593e-6;
  const auto stiffness = [&](const char* direction) {
    return s.result["effective"][direction]["value"].get<double>();
  };
  const auto verified = [](const char* quantity, const char* source) {
    return test::Verified{"Sliding", std::string("smooth sphere pressed, a/h 13: ") + quantity, source};
  };
  EXPECT_TRUE(verified("lateral stiffness", "8 G* a, Mindlin (1949)")
                  .within(stiffness("lateral_stiffness"), 8 * 8.2901e9 * a, 0.02));
  EXPECT_TRUE(verified("torsion stiffness", "16/3 G a^3")
                  .within(stiffness("torsion_stiffness"), 16.0 / 3 * 15.171e9 * a * a * a, 0.03));
}

TEST(TorsionExperiment_analytic, reaches_the_moment_of_full_slip) {
  const test::TemporaryFolder folder;
  CaseInput input = sliding("smooth", 20e-9);
  input.substrate.youngs_modulus = 71e9, input.substrate.poisson_ratio = 0.17;
  input.experiment.type = Motion::torsion;
  input.mesh.contact_region = 320e-9;
  input.experiment.angle = 0.04;
  input.experiment.reverse = false;
  const auto s = solve_experiment(input, folder.path);
  const double a = 0.2593e-6, full = 3 * M_PI / 16 * 0.3 * 100e-6 * a,
               stiffness = 16.0 / 3 * 15.171e9 * a * a * a;
  const std::string what = "smooth sphere turned by 40 mrad, a/h 13";
  const auto verified = [&](const char* quantity, const char* source) {
    return test::Verified{"Torsion", what + ": " + quantity, source};
  };
  EXPECT_TRUE(verified("moment of full slip", "3 pi mu P a/16")
                  .within(s.result["effective"]["torsion_moment"]["value"], full, 0.01));
  // Of third order in a radius that is known to a tenth of a spacing, a/h = 13: 2.4 %.
  EXPECT_TRUE(verified("stiffness", "16/3 G a^3")
                  .within(s.result["effective"]["torsion_stiffness"]["value"], stiffness, 0.03));
  EXPECT_TRUE(balances_energy("Torsion", what, s, 1));
}

/// Under little friction unlike bodies slip radially as they are pressed (Spence 1975), so that no node
/// sticks when the spin begins: its rise is no part of the moment of full slip (4 % low with it, at a stated
/// 23 %).
TEST(TorsionExperiment_analytic, under_little_friction_reaches_the_moment_of_full_slip) {
  const test::TemporaryFolder folder;
  CaseInput input = sliding("smooth", 20e-9);
  input.interface.parameters["Friction coefficient"] = 0.014;
  input.experiment.type = Motion::torsion;
  input.mesh.contact_region = 320e-9;
  input.experiment.angle = 0.0075;
  input.experiment.reverse = false;
  const auto s = solve_experiment(input, folder.path);
  const double a = 0.22931e-6, full = 3 * M_PI / 16 * 0.014 * 100e-6 * a;  // Lubkin (1951)
  const auto& moment = s.result["effective"]["torsion_moment"];
  EXPECT_NEAR(moment["value"].get<double>() / full, 1, 0.015);
  EXPECT_LT(moment["sd"].get<double>() / full, 0.025);
  EXPECT_LT(std::abs(moment["value"].get<double>() - full), 2 * moment["sd"].get<double>());
}

/// The surfaces are coupled where they have turned elastically; 0.3 % is open then, and 0.9 % where only
/// their frames turn.
TEST(TorsionExperiment_analytic, of_a_rough_yielding_contact_beside_the_axis_balances_its_energy) {
  const test::TemporaryFolder folder;
  CaseInput input = sliding(
      "generated(rms=2.7 nm, window=2.5 um, hurst=0.8, rolloff=200 nm, cutoff=128 nm, seed=1002)", 40e-9);
  input.substrate.parameters["Yield stress"] = 4e9;
  input.particle.parameters["Yield stress"] = 3e9;
  input.interface.parameters["Friction coefficient"] = 0.5;
  input.experiment.type = Motion::torsion;
  input.experiment.angle = 0.2;
  input.experiment.reverse = false;
  const auto s = solve_experiment(input, folder.path);
  EXPECT_TRUE(balances_energy("Torsion", "rough yielding torsion by 0.2 rad, contact beside the axis, 40 nm",
                              s, 0.5));
  EXPECT_GT(s.history.numbers("plastic_work [J]").back(), 0);
  expect_never_to_fall(s.history, {"friction_work [J]", "plastic_work [J]"});
}

TEST(Program_analytic,
     of_rolling_moves_by_the_radius_times_the_angle_and_begins_half_of_its_way_before_the_axis) {
  ExperimentInput e;
  e.type = Motion::rolling;
  e.load_steps = 2, e.unload = false, e.distance = 100, e.reverse = false;
  fem::MotionScales scales;
  scales.largest_shift = scales.largest_roll = 8, scales.rolling_radius = 1000;
  const auto program = fem::make_program(e, scales);
  EXPECT_EQ(program.front().motion.x, -50);
  EXPECT_NEAR(program.back().motion.x, 50, 1e-12);
  for (const auto& station : program) EXPECT_NEAR(station.motion.roll * 1000, station.motion.x, 1e-12);
}

TEST(RollingExperiment_analytic, with_hysteresis_of_adhesion_dissipates_balances_its_energy_and_resumes) {
  const test::TemporaryFolder folder;
  CaseInput input = sliding(generated(1.0, 160, 3), 40e-9);
  input.experiment.type = Motion::rolling;
  input.experiment.distance = 200e-9;
  input.experiment.motion_steps = 5;
  input.experiment.load_steps = 8;
  input.experiment.return_distance = 60e-9;  // where slip turns within steps
  input.interface.work_of_adhesion = 0.05, input.interface.work_of_separation = 0.3;
  input.interface.adhesion_law = "exponential", input.interface.parameters["Adhesion range"] = 2e-9;
  input.particle.parameters["Yield stress"] = 1.5e9, input.substrate.parameters["Yield stress"] = 2e9;
  const auto whole = test::solve_and_copy_after(input, folder.path / "whole", folder.path / "cut", 10);
  EXPECT_LT(whole.result["balance"]["force"], 1e-5);
  EXPECT_TRUE(balances_energy("Adhesion", "rough yielding rolling with hysteresis, 8 load steps", whole, 1));
  expect_never_to_fall(whole.history, {"friction_work [J]", "plastic_work [J]"});
  const auto lost = whole.history.numbers("adhesion_loss [J]");
  for (std::size_t k = 1; k < lost.size(); ++k) EXPECT_GE(lost[k], lost[k - 1]);
  EXPECT_GT(whole.result.at("effective").at("dissipated_energy").at("value").get<double>(), 0);
  EXPECT_FALSE(whole.result.at("effective")
                   .contains("rolling_dissipation"));  // less than a contact radius: not steady
  // Free of lateral force but for a small part of the friction that could hold it.
  EXPECT_LT(std::abs(whole.history.numbers("lateral_force [N]").back()), 0.05 * 0.3 * 100e-6);
  const auto resumed = solve_experiment(input, folder.path / "cut", true);
  const double difference =
      largest_difference(whole.history, resumed.history, "rolling_moment [N m]", 100e-6 * 0.23e-6);
  const test::Verified resumption{"Interruption", "rough rolling with hysteresis resumed: moment",
                                  "the uninterrupted run"};
  EXPECT_TRUE(resumption.below(difference, 1e-5, "of load times contact radius"));
}

/// A step that fails leaves slip, bonds, coupling and the learned way per angle as they were accepted.
TEST(RollingExperiment_behaviour, steps_that_fail_are_halved_and_reach_the_same_states) {
  const test::TemporaryFolder folder;
  CaseInput input = sliding(generated(1.0, 160, 3), 40e-9);
  input.experiment.type = Motion::rolling;
  input.experiment.distance = 100e-9;
  input.experiment.motion_steps = 2;
  input.experiment.load_steps = 4;
  input.experiment.reverse = false;
  input.particle.parameters["Yield stress"] = 1.5e9, input.substrate.parameters["Yield stress"] = 2e9;
  input.interface.work_of_adhesion = 0.05, input.interface.work_of_separation = 0.1;
  input.interface.adhesion_law = "exponential", input.interface.parameters["Adhesion range"] = 2e-9;
  // Pressed as before; contacts that jump may take ten times as many iterations as the input says.
  const auto whole = test::solve_and_copy_after(input, folder.path / "whole", folder.path / "halved",
                                                input.experiment.load_steps);
  const auto needed = whole.history.numbers("newton_iterations");
  CaseInput hurried = input;
  hurried.solver.newton_steps =
      (static_cast<int>(*std::max_element(needed.begin() + input.experiment.load_steps, needed.end())) - 1) /
      10;
  ASSERT_GE(hurried.solver.newton_steps, 1);
  const auto halved = solve_experiment(hurried, folder.path / "halved", true);
  const auto made = halved.history.numbers("newton_iterations");
  // The iterations of a step count those of the attempt that failed.
  EXPECT_GT(*std::max_element(made.begin() + input.experiment.load_steps, made.end()),
            10 * hurried.solver.newton_steps);
  ASSERT_EQ(made.size(), needed.size());
  // Micro-slip and with it the moment are seen in smaller steps.
  const std::vector<std::pair<std::string, double>> within{{"adhesion_loss [J]", 1e-3},
                                                           {"contact_area [m^2]", 1e-3},
                                                           {"rolling_moment [N m]", 0.03},
                                                           {"friction_work [J]", 0.1}};
  for (const auto& [column, bound] : within)
    EXPECT_NEAR(halved.history.numbers(column).back() / whole.history.numbers(column).back(), 1, bound)
        << column;
}

TEST(SolveCase_behaviour, derives_a_way_of_two_steady_contact_diameters) {
  CaseInput input = sliding("smooth", 25e-9);
  input.experiment.distance = 0;
  const double a = fem::set_up(input).hertz_radius;
  EXPECT_DOUBLE_EQ(fem::with_derived_path_length(input).experiment.distance, 5 * a);
  input.experiment.type = Motion::rolling;
  EXPECT_DOUBLE_EQ(fem::with_derived_path_length(input).experiment.distance, 6 * a);
  input.experiment.distance = 1e-7;
  EXPECT_EQ(fem::with_derived_path_length(input).experiment.distance, 1e-7);
  input.experiment.type = Motion::torsion;
  // Six times 0.64 mu P (1/G1 + 1/G2) / a^2 (Lubkin 1951).
  const auto shear = [](const BodyInput& b) { return b.youngs_modulus / (2 * (1 + b.poisson_ratio)); };
  const double compliance = 1 / shear(input.particle) + 1 / shear(input.substrate);
  EXPECT_NEAR(fem::with_derived_path_length(input).experiment.angle,
              3.84 * input.interface.parameters["Friction coefficient"] * input.experiment.normal_load *
                  compliance / (a * a),
              1e-9);
}

TEST(SolveCase_behaviour, derives_a_region_over_which_the_attraction_ends) {
  CaseInput input = sliding("smooth", 25e-9);
  input.mesh.contact_region = 0;
  const double without = fem::set_up(input).system.mesh.sizes.region_particle;
  input.interface.work_of_adhesion = input.interface.work_of_separation = 0.05;
  input.interface.adhesion_law = "dugdale", input.interface.parameters["Adhesion range"] = 10e-9;
  const auto setup = fem::set_up(input);
  // Gap beside Hertz' contact (Johnson 1985, eq. 3.42a).
  const double a = setup.hertz_radius, s = setup.system.mesh.sizes.region_particle / a;
  const double gap = a * a / (M_PI * input.radius) * ((s * s - 2) * std::acos(1 / s) + std::sqrt(s * s - 1));
  EXPECT_GT(gap, 10e-9);
  EXPECT_LT(gap, 15e-9);
  EXPECT_GT(s * a, 1.5 * without);
}

TEST(SolveCase_behaviour, refuses_motions_that_it_cannot_make) {
  const auto message = [](const CaseInput& input) {
    try {
      solve_case(input, {});
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CaseInput input = sliding("smooth", 25e-9);
  input.experiment.distance = 1e-3;
  EXPECT_NE(message(input).find("Distance"), std::string::npos);
  input.experiment.type = Motion::rolling;
  input.experiment.distance = 1e-5;
  EXPECT_NE(message(input).find("cap"), std::string::npos);
  input.experiment.distance = 1e-7;
  input.interface.work_of_adhesion = 0.1;
  EXPECT_NE(message(input).find("Adhesion range"), std::string::npos);
  input.interface.parameters["Adhesion range"] = 1e-9;
  input.interface.work_of_separation = 0.05;
  EXPECT_NE(message(input).find("Work of adhesion on separation"), std::string::npos);
  input.interface.work_of_separation = 0.2;
  input.experiment.return_distance = 1e-8;
  input.experiment.type = Motion::torsion;
  EXPECT_NE(message(input).find("Return distance"), std::string::npos);
}

}  // namespace
