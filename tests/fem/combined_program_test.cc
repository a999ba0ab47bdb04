// Programs that combine motions: their stations, and what contacts answer to them.
#include "fem/programs/combined_program.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/atomic_file.h"
#include "core/csv.h"
#include "core/error.h"
#include "core/quantity.h"
#include "fem/solve_case.h"
#include "tests/fem/support/solved_experiment.h"
#include "tests/fem/support/sphere_on_silicon.h"
#include "tests/support/shared_files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;

CaseInput program_case(const std::string& substrate, double spacing, const std::string& program) {
  CaseInput input = test::sphere_on_silicon("smooth", substrate, spacing, 300e-9);
  input.interface.parameters["Friction coefficient"] = 0.3;
  input.experiment.type = Motion::program;
  input.experiment.program = program;
  input.experiment.load_steps = 3;
  input.experiment.unload = false;
  input.output.fields = false;
  return input;
}

CsvTable run(const CaseInput& input, const std::filesystem::path& folder) {
  return test::solve_experiment(input, folder).history;
}

double largest_of(const std::vector<double>& errors) {
  test::Largest largest;
  for (const double e : errors) largest.count(e);
  return largest;
}

fem::MotionScales scales() {
  fem::MotionScales s;
  s.full_slip_shift = 4, s.full_slip_angle = 0.02, s.largest_shift = s.largest_roll = 8,
  s.largest_angle = 0.05, s.rolling_radius = 1000;
  return s;
}

TEST(CombinedProgram_behaviour, moves_part_by_part_with_steps_no_wider_than_those_of_a_single_motion) {
  ExperimentInput e;
  e.type = Motion::program;
  e.normal_load = 2, e.load_steps = 4, e.unload = false;
  e.program = "slide 100 and spin 0.05; press 1; roll 0.1; slide -40 and slide across 30 in 5 steps";
  const auto program = fem::make_program(e, scales());
  double widest = 0;
  for (std::size_t k = 1; k < program.size(); ++k)
    widest = std::max(widest, std::hypot(program[k].motion.x - program[k - 1].motion.x,
                                         program[k].motion.y - program[k - 1].motion.y));
  EXPECT_LE(widest, 1.5 * 8 + 1e-9);
  const auto& first = program.front().motion;
  const auto& last = program.back();
  // Rolled along the direction to which the axis has spun.
  EXPECT_NEAR(last.motion.x - first.x, 60 + 100 * std::cos(0.05), 1e-9);
  EXPECT_NEAR(last.motion.y - first.y, 30 + 100 * std::sin(0.05), 1e-9);
  EXPECT_NEAR(last.motion.spin, 0.05, 1e-12);
  EXPECT_NEAR(last.motion.roll - first.roll, 0.1, 1e-12);
  EXPECT_NEAR(last.load, 0.5, 1e-12);
  // The contact's path lies evenly about the axis of the meshes: x from -x0 to 200 - x0.
  EXPECT_NEAR(first.x, -0.5 * (100 + 100 * std::cos(0.05)), 1e-9);
  EXPECT_NEAR(first.roll, -0.05, 1e-12);
  const auto free =
      std::count_if(program.begin(), program.end(), [](const auto& s) { return s.rolls_freely; });
  EXPECT_GE(free, 12);
  EXPECT_FALSE(last.rolls_freely);
}

TEST(CombinedProgram_behaviour, unloads_from_the_load_it_ends_with) {
  ExperimentInput e;
  e.type = Motion::program;
  e.normal_load = 2, e.load_steps = 2, e.unload_steps = 2, e.program = "press 1 in 1 step";
  const auto program = fem::make_program(e, scales());
  ASSERT_EQ(program.size(), 5u);
  EXPECT_DOUBLE_EQ(program[2].load, 0.5);
  EXPECT_DOUBLE_EQ(program[3].load, 0.5 * std::pow(0.5, 1.5));
}

/// Far beyond full slip the past is forgotten: friction mu P against the motion across, and nothing along the
/// direction before.
TEST(CombinedProgram_analytic, a_sphere_slid_along_and_then_across_is_held_back_against_its_last_way) {
  const test::TemporaryFolder folder;
  CaseInput input = program_case("smooth", 24e-9, "slide 60 nm; slide across 100 nm");
  input.substrate.youngs_modulus = 71e9, input.substrate.poisson_ratio = 0.17;
  const auto history = run(input, folder.path);
  const auto along = history.numbers("lateral_force [N]"),
             across = history.numbers("lateral_force_across [N]");
  const auto y = history.numbers("shift_across [m]"), energy = history.numbers("energy_error");
  std::size_t turn = 0;
  while (y[turn + 1] == 0) ++turn;
  const double friction = 0.3 * 100e-6;
  std::printf("along %+.2f %%, across %+.2f %%, left along %.4f, open %.2g\n",
              100 * (along[turn] / friction - 1), 100 * (across.back() / friction - 1),
              along.back() / friction, *std::max_element(energy.begin(), energy.end()));
  const auto verified = [](const std::string& what) {
    return test::Verified{"Sliding", "program: slid along, then across, smooth, a/h 10: " + what, "mu P"};
  };
  EXPECT_TRUE(verified("friction along").within(along[turn], friction, 0.01));
  EXPECT_NEAR(across[turn], 0, 0.005 * friction);
  EXPECT_TRUE(verified("friction across").within(across.back(), friction, 0.01));
  EXPECT_TRUE(verified("what is left along").below(100 * along.back() / friction, 0.5, "% of mu P"));
  EXPECT_TRUE(verified("energy left open").below(100 * largest_of(energy), 1, "%"));
}

/// A sphere that rolls along a rail spins on its flanks: no more than full slip, and less the shallower the
/// rail, for rolling brings fresh surface that has not slipped. Smooth equal bodies; the path between the
/// flanks is held, as symmetry does on a rail. `largest_across`: relative error of the force across; it falls
/// with the first power of the spacing, here and in the reference.
void expect_steady_spin(double spin_number, double largest_across) {
  const auto path = asperity::test::reference_table("05_rolling_table_spin.csv");
  const auto table = read_csv(path);
  const auto nu = table.numbers("nu"), numbers = table.numbers("G*a^3*phi/(mu*P)");
  std::size_t row = 0;
  while (nu[row] != 0.17 || numbers[row] != spin_number) ++row;
  const double across_expected = table.numbers("Fy/muP_extrap")[row],
               moment_expected = table.numbers("Mz/muPa_extrap")[row];
  const test::TemporaryFolder folder;
  CaseInput input = program_case("smooth", 36e-9, "");
  input.substrate.youngs_modulus = 71e9, input.substrate.poisson_ratio = 0.17;
  const double G = 71e9 / 2 / 1.17, E = 71e9 / 2 / (1 - 0.17 * 0.17), R = input.radius, P = 100e-6,
               mu = input.interface.parameters["Friction coefficient"];
  const double a = std::cbrt(0.75 * P * R / E), spin_per_length = spin_number * mu * P / (G * a * a * a),
               path_length = 5 * a;
  input.experiment.program = "roll " + format_quantity(path_length, Dimension::length, 8) + " and spin " +
                             format_quantity(spin_per_length * path_length, Dimension::angle, 8);
  const auto history = run(input, folder.path);
  const auto along = history.numbers("lateral_force [N]"),
             across = history.numbers("lateral_force_across [N]"),
             heading = history.numbers("torsion_angle [rad]"),
             moment = history.numbers("torsion_moment [N m]"), slip = history.numbers("friction_work [J]"),
             rolled = history.numbers("rolling_angle [rad]"), energy = history.numbers("energy_error");
  const std::size_t last = heading.size() - 1;
  const double c = std::cos(heading[last]), s = std::sin(heading[last]);
  const double forward = (c * along[last] + s * across[last]) / (mu * P),
               sideways = std::abs(c * across[last] - s * along[last]) / (mu * P);
  const double spun_back = moment[last] / (mu * P * a), lost = (slip[last] - slip[last - 2]) /
                                                               (rolled[last] - rolled[last - 2]) / R /
                                                               spin_per_length / (mu * P * a);
  std::printf(
      "G a^3 phi/(mu P) %.2f, spun by %.3f rad: forward %.4f, across %.4f (%.4f), moment %.4f (%.4f), slip "
      "per angle of spin %.4f, open %.2g\n",
      spin_number, heading[last], forward, sideways, across_expected, spun_back, moment_expected, lost,
      *std::max_element(energy.begin(), energy.end()));
  char place[96];
  std::snprintf(place, sizeof place,
                "rolled freely while it spins, G a^3 phi/(mu P) %g, a/h 7: ", spin_number);
  const auto verified = [&](const std::string& what, const char* source) {
    return test::Verified{"Rolling", place + what, source};
  };
  const char* const elements = "boundary elements, 2 %";
  EXPECT_TRUE(verified("force forward, over mu P", "none").below(forward, 0.01));
  EXPECT_TRUE(verified("force across", elements).within(sideways, across_expected, largest_across));
  EXPECT_TRUE(verified("moment of spin", elements).within(spun_back, moment_expected, 0.05));
  EXPECT_TRUE(verified("friction's work per angle of spin", "the moment").within(lost, spun_back, 0.03));
  EXPECT_TRUE(verified("energy left open", "balance").below(100 * largest_of(energy), 1, "%"));
}

TEST(CombinedProgramNightly_other_code, a_rolling_sphere_that_spins_meets_steady_rolling_with_spin) {
  expect_steady_spin(0.7, 0.05);
}
TEST(CombinedProgramNightly_other_code, a_rolling_sphere_that_spins_fast_nears_full_slip) {
  expect_steady_spin(2, 0.15);
}

/// From Cattaneo's shift to Carter's rolling with creep: friction takes all the work that shift and roll put
/// in. A moment whose lever arm is not that of the centre the roll turns about would leave Q times approach
/// over radius per path length: an eighth of it.
TEST(CombinedProgram_analytic, friction_takes_all_the_work_of_a_sphere_that_is_shifted_and_then_rolled) {
  const test::TemporaryFolder folder;
  CaseInput input = program_case("smooth", 34e-9, "slide 3 nm; slide 2 nm and roll 400 nm");
  input.substrate.youngs_modulus = 71e9, input.substrate.poisson_ratio = 0.17;
  const auto history = run(input, folder.path);
  const auto force = history.numbers("lateral_force [N]"), roll = history.numbers("rolling_angle [rad]"),
             work = history.numbers("work [J]"), stored = history.numbers("elastic_energy [J]"),
             slip = history.numbers("friction_work [J]"),
             approach = history.numbers("normal_displacement [m]");
  std::size_t begin = 0;
  while (roll[begin + 1] == 0) ++begin;
  const std::size_t last = roll.size() - 1;
  const double into_friction = slip[last] - slip[begin],
               put_in = work[last] - work[begin] - (stored[last] - stored[begin]);
  const double lever = force[last] * approach[last] * (roll[last] - roll[begin]);
  std::printf(
      "Q/(mu P) %.3f, put in over friction's work %.4f, force times approach times angle %.3f of it\n",
      force[last] / (0.3 * 100e-6), put_in / into_friction, lever / into_friction);
  EXPECT_GT(std::abs(lever), 0.05 * into_friction);  // else the case would not tell
  EXPECT_TRUE(
      (test::Verified{"Rolling", "shifted, then rolled with creep: work put in", "friction's work"}.within(
          put_in, into_friction, 0.01)));
}

/// Between two planes, of which the upper moves: half of its path, and no lateral force that a particle
/// without drive could hold.
TEST(CombinedProgram_analytic, of_rough_yielding_bodies_balances_its_energy_and_resumes_within_any_part) {
  const test::TemporaryFolder folder;
  CaseInput input =
      program_case(test::generated(1.0, 160, 3), 40e-9,
                   "slide 8 nm and spin 8 mrad; press 60 uN in 2 steps; indenter 200 nm in 4 steps; "
                   "roll 1 mrad and slide -6 nm and slide across 6 nm; press 100 uN in 2 steps");
  input.particle.parameters["Yield stress"] = 2e9;
  const auto [whole, result] =
      test::solve_and_copy_after(input, folder.path / "whole", folder.path / "cut", 10);
  EXPECT_EQ(result["experiment"], "program");
  const auto verified = [](const std::string& what, const char* source) {
    return test::Verified{"Experiment", "program of five parts, rough yielding bodies: " + what, source};
  };
  EXPECT_TRUE(verified("force left open, of the load", "balance").below(result["balance"]["force"], 1e-5));
  EXPECT_TRUE(
      verified("energy left open", "balance").below(100 * result["balance"]["energy"].get<double>(), 1, "%"));
  const auto angle = whole.numbers("rolling_angle [rad]"), force = whole.numbers("lateral_force [N]"),
             load = whole.numbers("normal_force [N]");
  std::size_t rolled = 0;
  while (angle[rolled] * input.radius < 99e-9) ++rolled;
  EXPECT_NEAR(angle[rolled] * input.radius, 100e-9, 1e-12);
  EXPECT_NEAR(load[rolled], 60e-6, 1e-9);
  EXPECT_LT(std::abs(force[rolled]), 0.1 * 0.3 * 60e-6);
  EXPECT_NEAR(load.back(), 100e-6, 1e-9);
  for (const std::string sum : {"friction_work [J]", "plastic_work [J]"}) {
    const auto w = whole.numbers(sum);
    for (std::size_t k = 1; k < w.size(); ++k) EXPECT_GE(w[k], w[k - 1] * (1 - 1e-9)) << sum << k;
  }
  const auto resumed = test::solve_experiment(input, folder.path / "cut", true).history;
  test::Largest difference;
  for (const std::string column : {"lateral_force [N]", "lateral_force_across [N]"}) {
    const auto one = whole.numbers(column), other = resumed.numbers(column);
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t k = 0; k < one.size(); ++k) difference.count((other[k] - one[k]) / 100e-6);
  }
  const test::Verified resumption{"Interruption",
                                  "program of five parts resumed within a part: lateral forces, of the load",
                                  "the uninterrupted run"};
  EXPECT_TRUE(resumption.below(difference, 1e-5));
}

TEST(CombinedProgram_behaviour, is_refused_with_what_would_do) {
  const auto message = [](const std::string& program, auto&& change) {
    CaseInput input = program_case("smooth", 25e-9, program);
    change(input);
    try {
      solve_case(input, {});
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const auto as_it_is = [](CaseInput&) {};
  const auto expect = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  expect(message("", as_it_is), "needs Experiment/Program");
  expect(message("press 200 uN", as_it_is), "at most the 100 uN");
  expect(message("press 5 nm", as_it_is), "Control is force");
  expect(message("roll 1", as_it_is), "cap; let the contact move by");
  expect(message("slide 1 mm", as_it_is), "middle half");
  expect(message("slide 1 nm", [](CaseInput& input) { input.experiment.cycles = 2; }), "Cycles = 1");
  expect(message("slide 1 nm", [](CaseInput& input) { input.experiment.type = Motion::sliding; }),
         "set Type = program");
}

}  // namespace
