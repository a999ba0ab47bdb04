// What drives the laws of a simulation: control by force or displacement, runs and rows, and the root that
// both need.
#include <gtest/gtest.h>

#include <cmath>

#include "core/shear_moduli.h"
#include "diagnosis/mechanics/scalar_root.h"
#include "tests/diagnosis/support/assembled_mechanics.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

using test::nm;

/// One effect with its values, or none.
Mechanics driven(const Experiment& e, const std::string& id, const std::vector<double>& values,
                 double friction = 0.2) {
  if (id.empty()) return test::with(e, {}, friction);
  return test::with(e, {{id, values}}, friction);
}

/// What displacement control says of creep, tilt and compliance together, force control turns back.
TEST(Simulate_behaviour, force_control_turns_all_parts_back_at_once) {
  const Experiment e = test::experiment(Motion::normal);
  Mechanics m = driven(e, "creep", {5 * nm, 12});
  const double slope[] = {300}, compliance[] = {5e-6}, offset[] = {3 * nm};
  effect_of("baseline_tilt").assemble(m, slope);
  effect_of("instrument_compliance").assemble(m, compliance);
  effect_of("contact_point_offset").assemble(m, offset);
  Samples path = test::approach_and_back(5 * nm, 50 * nm, 40);
  const auto force = simulate(m, path);
  path.runs[0].response_is_displacement = true;
  for (std::size_t i = 0; i < force.size(); ++i) path.list[i].normal_force = force[i];
  const auto back = simulate(m, path);
  for (std::size_t i = 0; i < 40; ++i) EXPECT_NEAR(back[i], path.list[i].normal_displacement, 1e-3 * nm) << i;
}

TEST(Simulate_analytic, a_record_that_begins_under_a_force_begins_with_it) {
  const Experiment e = test::experiment(Motion::sliding);
  for (const char* stick : {"", "partial_slip"})
    for (const double start : {-0.15e-3, -0.02e-3, 0.1e-3}) {
      Samples path = test::lateral_path(1e-3, {0, 1 * nm}, 11);
      path.runs[0].first_response = start;
      EXPECT_NEAR(simulate(driven(e, stick, {}), path)[0], start, 2e-3 * 0.2e-3) << stick << start;
      // More than the limit is not held.
      path.runs[0].first_response = 4 * start;
      const double most = std::min(4 * std::abs(start), 0.2e-3);
      EXPECT_NEAR(simulate(driven(e, stick, {}), path)[0], std::copysign(most, start), 2e-3 * 0.2e-3)
          << stick << start;
    }
  Samples path = test::lateral_path(1e-3, {0, 1 * nm}, 11);
  path.runs[0].first_response = 0.1e-3;
  // What lies on top of the contact's force is no part of it: the record still begins where it did.
  EXPECT_NEAR(simulate(driven(e, "lateral_zero_offset", {0.04e-3}), path)[0], 0.1e-3, 1e-12);
}

/// Cattaneo & Mindlin with a compliance in series: x = 3 mu f_n/(2 k) [1 - (1 - q)^(2/3)] + C q mu f_n.
TEST(Simulate_analytic, a_compliance_in_series_with_partial_slip_takes_its_part) {
  const Experiment e = test::experiment(Motion::sliding);
  const double load = 1e-3, most = 0.2 * load, C = 2e-6;
  const double k = 8 * reduced_shear_modulus(e.particle, e.substrate) * e.hertz().contact_radius(load);
  Mechanics m = driven(e, "partial_slip", {});
  m.lateral.compliance = C;
  const auto path_to = [&](double q) {
    return 1.5 * most / k * (1 - std::pow(1 - q, 2.0 / 3)) + C * q * most;
  };
  for (const double q : {0.3, 0.8})
    for (const double sign : {1.0, -1.0})
      EXPECT_NEAR(
          simulate(m, test::lateral_path(load, {0, sign * path_to(q)}, 41)).back() / (sign * q * most), 1,
          5e-3)
          << q;
}

TEST(Simulate_analytic, a_spring_that_the_load_softens_keeps_its_stretch_and_one_that_it_stiffens_its_force) {
  const Experiment e = test::experiment(Motion::sliding);
  const auto after = [&](double first, double second) {
    Samples path = test::lateral_path(first, {0, 0.5 * nm}, 6);
    path.list.push_back(path.list.back());  // the load changes, the place does not
    path.list.back().normal_force = second;
    test::close_run(path, false);
    return simulate(driven(e, "", {}), path);
  };
  const double k = 8 * reduced_shear_modulus(e.particle, e.substrate) * e.hertz().contact_radius(1e-3);
  const auto softer = after(1e-3, 0.5e-3), stiffer = after(1e-3, 2e-3);
  EXPECT_NEAR(softer[5], k * 0.5 * nm, 1e-12);
  EXPECT_NEAR(softer[6], k * 0.5 * nm / std::cbrt(2.0), 1e-12);
  EXPECT_NEAR(stiffer[6], k * 0.5 * nm, 1e-12);
}

TEST(Simulate_analytic, a_row_resists_its_own_direction) {
  const Experiment e = test::experiment(Motion::rolling);
  Samples row = test::row(e, 2e-3);
  row.list[0].direction = -1;
  EXPECT_NEAR(simulate(driven(e, "", {}, 5e-4), row)[0], -1e-6, 1e-15);
  EXPECT_NEAR(simulate(driven(e, "surface_tilt", {0.01}, 5e-4), row)[0], -1e-6 + std::tan(0.01) * 2e-3,
              1e-15);
}

TEST(Simulate_behaviour, rows_of_a_series_do_not_know_of_each_other) {
  const Experiment e = test::experiment(Motion::normal);
  Samples path = test::approach_and_back(10 * nm, 60 * nm, 30);
  const Mechanics m = driven(e, "bulk_plasticity", {0.5e9, 2.84});
  const auto trace = simulate(m, path);
  EXPECT_LT(trace[45], 0.9 * trace[14]);  // the imprint
  path.runs[0].independent_rows = true;
  const auto rows = simulate(m, path);
  EXPECT_EQ(rows[45], rows[14]);
  EXPECT_EQ(rows[14], trace[14]);
}

TEST(Simulate_behaviour, runs_begin_anew) {
  const Experiment e = test::experiment(Motion::sliding);
  Samples path = test::lateral_path(1e-3, {0, 100 * nm, 0}, 51);
  const auto one = simulate(driven(e, "", {}), path);
  Samples twice = path;
  twice.list.insert(twice.list.end(), path.list.begin(), path.list.end());
  twice.runs.push_back(twice.runs[0]);
  twice.runs[1].begin = path.list.size(), twice.runs[1].end = twice.list.size();
  const auto two = simulate(driven(e, "", {}), twice);
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(two[one.size() + i], one[i]);
}

TEST(ScalarRoot_analytic, finds_roots_on_either_side_of_its_guess) {
  for (const double guess : {-50.0, 0.0, 1.9, 2.0, 2.1, 300.0})
    EXPECT_NEAR(increasing_root([](double x) { return x * x * x - 8; }, guess, 0.1, 1e-12), 2, 1e-11)
        << guess;
  // Of two branches that of the larger place: the function rises, falls and rises through its last root at 3.
  const auto wavy = [](double x) { return (x - 1) * (x - 2) * (x - 3); };
  EXPECT_NEAR(increasing_root(wavy, 10, 0.05, 1e-12), 3, 1e-11);
  // Held by nothing: as far down as it looked.
  EXPECT_LT(increasing_root([](double) { return 1.0; }, 5, 0.1, 1e-12), -1e6);
  EXPECT_GT(increasing_root([](double) { return -1.0; }, 5, 0.1, 1e-12), 1e6);
  // A root beyond which a step is lost in rounding is no reason to stop.
  EXPECT_GE(increasing_root([](double x) { return x < 2e30 ? -1.0 : 1.0; }, 1e30, 1e10, 1e-12), 1e30);
}

}  // namespace
}  // namespace asperity
