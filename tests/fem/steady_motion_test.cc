// Steady rolling as histories tell it.
#include "fem/output/steady_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/hertz.h"
#include "fem/case/case_setup.h"
#include "tests/fem/support/solved_experiment.h"
#include "tests/fem/support/sphere_on_silicon.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;
using namespace asperity::fem;

constexpr double radius = 1e-5, contact_radius = 1e-7, resistance = 3e-13;  // [m], [m], [N m]

/// Steps of a tenth of the contact radius; six of them are rolled before anything is dissipated, as after
/// each turn.
std::vector<HistoryRow> rolled(int out, int back) {
  std::vector<HistoryRow> records(1);
  records.front().pressure_radius = contact_radius;
  const double step = 0.1 * contact_radius / radius;
  for (const auto& [count, direction] : {std::pair{out, 1}, std::pair{back, -1}})
    for (int i = 1; i <= count; ++i) {
      HistoryRow next = records.back();
      next.rolling_angle += direction * step;
      next.rolling_moment = i > 6 ? direction * resistance : 0;
      if (i > 6) next.dissipated_energy += resistance * step;
      records.push_back(next);
    }
  return records;
}

TEST(SteadyRolling_analytic, counts_after_two_contact_radii_of_the_first_way) {
  for (const int back : {0, 5, 40}) {
    EXPECT_NEAR(rolling_dissipation(rolled(50, back), radius)->per_angle, resistance, 1e-9 * resistance)
        << back;
    const auto steady = steady_rolling(rolled(50, back), radius);
    ASSERT_TRUE(steady);
    EXPECT_NEAR(steady->mean, resistance, 1e-9 * resistance);
    EXPECT_NEAR(steady->path_length, 30 * 0.1 * contact_radius / radius, 1e-9);
  }
}

/// What the balance left open under the load that came on is there before and after the path.
TEST(SteadyRolling_analytic, leaves_open_what_the_energy_balance_drifts_by_on_the_path) {
  constexpr double work = 2e-14, loading = 0.01, drift = 0.002;
  std::vector<HistoryRow> records = rolled(50, 5);
  for (std::size_t k = 0; k < records.size(); ++k) {
    records[k].work = work;
    records[k].energy_error = -loading + drift * double(std::min<std::size_t>(k, 50)) / 50;
  }
  // From the twentieth of fifty steps on, of a tenth of the contact radius each.
  const double drifts = drift * work / (50 * 0.1 * contact_radius / radius);
  EXPECT_NEAR(rolling_dissipation(records, radius)->unbalanced, drifts, 1e-9 * drifts);
  EXPECT_DOUBLE_EQ(rolling_dissipation(rolled(50, 0), radius)->unbalanced, 0);
  // What comes and goes from step to step is no drift: of 31 rows the standard error of a slope alone, by
  // hand the deviation over the root of 30 * 31 * 32/12 = 2480 squared steps.
  for (std::size_t k = 0; k < records.size(); ++k) records[k].energy_error = drift * (k % 2 == 0 ? 1 : -1);
  const double step = 0.1 * contact_radius / radius;
  EXPECT_NEAR(rolling_dissipation(records, radius)->unbalanced / (drift * work / (step * std::sqrt(2480))), 1,
              0.05);
}

TEST(SteadyRolling_analytic, of_a_way_shorter_than_that_is_not_known) {
  EXPECT_FALSE(rolling_dissipation(rolled(18, 0), radius));
  EXPECT_FALSE(steady_rolling(rolled(18, 0), radius));
  EXPECT_FALSE(rolling_dissipation(rolled(0, 0), radius));
}

/// Bodies of two materials slip as they are pressed, and go on slipping until the contact they were pressed
/// in has been left. What is counted as steady is what they dissipate much later, at the end of a path of ten
/// radii.
TEST(SteadyRollingNightly_behaviour, of_bodies_of_two_materials_is_what_they_dissipate_ten_radii_on) {
  CaseInput c = test::sphere_on_silicon("smooth", "smooth", 35e-9, 0);
  c.experiment.type = Motion::rolling;
  c.experiment.normal_load = 3e-4;
  c.experiment.load_steps = 4;
  c.experiment.unload = c.experiment.reverse = false;
  const double a = hertz_of(c).contact_radius(c.experiment.normal_load);
  for (const auto& [friction, asked] : {std::pair{0.1, 2.0}, std::pair{0.5, 8.0}}) {
    c.interface.parameters["Friction coefficient"] = friction;
    c.experiment.distance = 0;  // six radii
    const test::TemporaryFolder usual, longer;
    const double said =
        test::solve_experiment(c, usual.path).result["effective"]["rolling_dissipation"]["value"];
    c.experiment.distance = 10 * a;
    const auto solved = test::solve_experiment(c, longer.path);
    const auto angle = solved.history.numbers("rolling_angle [rad]"),
               lost = solved.history.numbers("dissipated_energy [J]");
    std::size_t from = 0;
    while (angle[from] < 6 * a / c.radius) ++from;
    const double late = (lost.back() - lost[from]) / (angle.back() - angle[from]);
    EXPECT_TRUE((test::Verified{"Rolling",
                                "smooth glass on silicon, friction " + std::to_string(friction).substr(0, 3) +
                                    ": dissipation counted as steady over that six to ten radii on",
                                "the same contact, later"}
                     .below(100 * (said / late - 1), asked, " %")));
  }
}

TEST(RollingSteps_analytic, are_a_twentieth_of_the_contact_radius_where_smooth_bodies_of_two_materials_slip) {
  CaseInput c = test::sphere_on_silicon("smooth", "smooth", 35e-9, 0);
  c.experiment.type = Motion::rolling;
  c.experiment.normal_load = 3e-4;
  c.interface.parameters["Friction coefficient"] = 0.3;
  const double a = hertz_of(c).contact_radius(c.experiment.normal_load);
  EXPECT_NEAR(set_up(c).motion.largest_roll, a / 20, 1e-6 * a);
  EXPECT_NEAR(set_up(c).motion.largest_shift, 35e-9, 1e-15);
  CaseInput equal = c, frictionless = c;
  equal.substrate.youngs_modulus = c.particle.youngs_modulus;
  equal.substrate.poisson_ratio = c.particle.poisson_ratio;
  frictionless.interface.parameters["Friction coefficient"] = 0;
  for (const CaseInput& one : {equal, frictionless})
    EXPECT_NEAR(set_up(one).motion.largest_roll, 35e-9, 1e-15);
}

/// Stated on coarse meshes, and in steps of a tenth of the contact radius, against a/h 19 and steps of a/40.
TEST(SteadyRollingNightly_behaviour, what_coarse_meshes_and_steps_leave_of_two_materials_slip_is_stated) {
  const auto rolled = [](double friction, double spacing, int steps) {
    CaseInput c = test::sphere_on_silicon("smooth", "smooth", spacing, 0);
    c.experiment.type = Motion::rolling;
    c.experiment.normal_load = 3e-4;
    c.experiment.load_steps = 4;
    c.experiment.unload = c.experiment.reverse = false;
    c.interface.parameters["Friction coefficient"] = friction;
    c.experiment.distance = 4 * hertz_of(c).contact_radius(c.experiment.normal_load);
    c.experiment.motion_steps = steps;
    const test::TemporaryFolder folder;
    return test::solve_experiment(c, folder.path).result["effective"]["rolling_dissipation"];
  };
  for (const double friction : {0.1, 0.5}) {
    const double fine = rolled(friction, 17.5e-9, 160)["value"];
    for (const auto& [spacing, steps] : {std::pair{55e-9, 0}, std::pair{35e-9, 0}, std::pair{35e-9, 40}}) {
      const auto coarse = rolled(friction, spacing, steps);
      const std::string how = "friction " + std::to_string(friction).substr(0, 3) + ", a/h " +
                              (spacing > 40e-9 ? "6" : "9") + (steps > 0 ? ", steps of a/10" : "");
      EXPECT_TRUE(
          (test::Verified{"Stated errors", "rolling of smooth glass on silicon, " + how,
                          "a/h 19, steps of a/40"}
               .below(std::abs(coarse["value"].get<double>() - fine) / coarse["sd"].get<double>(), 2, "sd")));
    }
  }
}

/// A rough contact of asperities that yield and slip, four spacings over the shortest wave, on nodes half as
/// far apart.
TEST(SteadyRollingNightly_behaviour, what_a_coarse_mesh_leaves_of_rough_bodies_is_stated) {
  for (const int seed : {1, 3}) {
    const auto rolled = [&](double spacing) {
      CaseInput c = test::sphere_on_silicon("smooth",
                                            "generated(rms=1.427 nm, window=2.5 um, hurst=0.797, rolloff=208 "
                                            "nm, cutoff=69.4 nm, seed=" +
                                                std::to_string(seed) + ")",
                                            spacing, 0);
      c.experiment.type = Motion::rolling;
      c.experiment.normal_load = 3e-5;
      c.experiment.load_steps = 4;
      c.experiment.unload = c.experiment.reverse = false;
      c.interface.parameters["Friction coefficient"] = 0.3;
      c.particle.parameters["Yield stress"] = 3e9, c.substrate.parameters["Yield stress"] = 4e9;
      c.mesh.layers = 2;
      const test::TemporaryFolder folder;
      return test::solve_experiment(c, folder.path).result["effective"]["rolling_dissipation"];
    };
    const auto coarse = rolled(17.35e-9), fine = rolled(8.675e-9);
    EXPECT_TRUE((
        test::Verified{
            "Stated errors",
            "rolling of rough bodies that yield, friction 0.3, surface " + std::to_string(seed) + ", 17 nm",
            "8.7 nm"}
            .below((coarse["value"].get<double>() - fine["value"].get<double>()) / coarse["sd"].get<double>(),
                   2, "sd")));
  }
}

/// Slips as a whole from the fourth step on; on the way back over its own track nothing yields any more.
TEST(SteadySliding_analytic, is_what_the_first_way_dissipates_and_not_the_mean_of_both) {
  constexpr double load = 1e-4, out = 3e-5, back = 1e-5, step = 1e-9;
  std::vector<HistoryRow> records(1);
  for (const auto& [force, direction] : {std::pair{out, 1}, std::pair{back, -1}})
    for (int i = 1; i <= 20; ++i) {
      HistoryRow next = records.back();
      next.shift += direction * step;
      next.normal_force = load, next.lateral_force = direction * force;
      next.sticking_share = i > 3 ? 0.01 : 0.6;
      next.dissipated_energy += force * step;
      records.push_back(next);
    }
  const auto steady = steady_sliding(records);
  ASSERT_TRUE(steady);
  EXPECT_NEAR(steady->mean, out / load, 1e-9);
  EXPECT_NEAR(steady->sd, 0, 1e-9);
  EXPECT_NEAR(steady->path_length, 16 * step, 1e-15);
}

}  // namespace
