// Laws of effects on sliding, rolling and torsion against their own formulas.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <string>

#include "core/attraction_zone.h"
#include "diagnosis/catalogue/effect.h"
#include "tests/diagnosis/support/assembled_mechanics.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

using test::nm;
using test::uN;

/// Friction limit that an effect leaves of 0.2 under a sample.
double changed(const std::string& id, const std::vector<double>& values, const Sample& sample,
               double slip = 0, Motion mode = Motion::sliding) {
  Mechanics m = test::with(test::experiment(mode), {{id, values}}, 0.2);
  SlipState state;
  state.sample = &sample, state.speed = sample.speed, state.slip = slip;
  double mu = 0.2;
  for (auto& change : m.lateral.coefficient_changes) mu = change(mu, state);
  return mu;
}

TEST(VelocityDependence_analytic, adds_the_same_for_every_factor_of_speed_down_to_a_tenth_of_the_slowest) {
  Sample s;
  const auto at = [&](double speed) { return s.speed = speed, changed("velocity_dependence", {0.01}, s); };
  EXPECT_NEAR(at(std::sqrt(1e-6 * 1e-5)), 0.2, 1e-12);  // the geometric mean of the recorded speeds
  EXPECT_NEAR(at(1e-5) - at(1e-6), 0.01 * std::log(10), 1e-12);
  EXPECT_NEAR(at(1e-7), 0.2 + 0.01 * std::log(1e-7 / std::sqrt(1e-11)), 1e-12);
  EXPECT_EQ(at(1e-9), at(1e-7));
  EXPECT_EQ(at(0), at(1e-7));
}

TEST(ViscousRolling_analytic, adds_in_proportion_to_speed) {
  Sample s;
  s.speed = 2e-5;
  EXPECT_NEAR(changed("viscous_rolling", {300}, s, 0, Motion::rolling), 0.206, 1e-12);
  s.speed = 0;
  EXPECT_EQ(changed("viscous_rolling", {300}, s, 0, Motion::rolling), 0.2);
}

TEST(StaticFrictionPeak_analytic, decays_with_the_path_slipped) {
  const Sample s;
  EXPECT_NEAR(changed("static_friction_peak", {1.5, 20 * nm}, s, 0), 0.3, 1e-12);
  EXPECT_NEAR(changed("static_friction_peak", {1.5, 20 * nm}, s, 20 * nm), 0.2 * (1 + 0.5 * std::exp(-1)),
              1e-12);
  EXPECT_NEAR(changed("static_friction_peak", {1.5, 20 * nm}, s, 1000 * nm), 0.2, 1e-12);
}

TEST(RunIn_analytic, fades_with_cycles_and_their_parts) {
  Sample s;
  EXPECT_NEAR(changed("run_in", {0.5, 2}, s), 0.3, 1e-12);
  s.cycles_passed = 1.5;
  EXPECT_NEAR(changed("run_in", {0.5, 2}, s), 0.2 * (1 + 0.5 * std::exp(-0.75)), 1e-12);
  EXPECT_NEAR(changed("run_in", {-0.5, 2}, s), 0.2 * (1 - 0.5 * std::exp(-0.75)), 1e-12);
}

TEST(RoughnessDependentRolling_analytic, falls_from_b_plus_c_of_a_smooth_plane_to_b) {
  Sample s;
  EXPECT_NEAR(changed("roughness_dependent_rolling", {0.1, 0.3, 2 * nm}, s, 0, Motion::rolling), 0.4, 1e-12);
  s.rms_roughness = 4 * nm;
  EXPECT_NEAR(changed("roughness_dependent_rolling", {0.1, 0.3, 2 * nm}, s, 0, Motion::rolling),
              0.1 + 0.3 * std::exp(-2), 1e-12);
  s.rms_roughness = 1000 * nm;
  EXPECT_NEAR(changed("roughness_dependent_rolling", {0.1, 0.3, 2 * nm}, s, 0, Motion::rolling), 0.1, 1e-12);
}

/// mu = mu0 + a ln(v/v0) + b ln(v0 theta/L); at rest in time theta = L/v, and after a step over L it decays
/// by exp(-v t/L).
TEST(RateAndState_analytic, is_steady_at_a_minus_b_and_relaxes_over_its_slip_distance) {
  const Experiment e = test::experiment(Motion::sliding);
  const double a = 0.02, b = 0.05, L = 10 * nm, reference = std::sqrt(e.slowest * e.fastest);
  Mechanics m = test::with(e, {{"rate_and_state", {a, b, L}}}, 0.2);
  auto& change = m.lateral.coefficient_changes.at(0);
  Sample s;
  SlipState state;
  state.sample = &s;
  const auto at = [&](double speed, double time_step) {
    state.speed = speed, state.time_step = time_step;
    return change(0.2, state);
  };
  const double before = 0.2 + (a - b) * std::log(1e-6 / reference),
               after = 0.2 + (a - b) * std::log(1e-5 / reference);
  EXPECT_NEAR(at(1e-6, 0), before, 1e-12);
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(at(1e-6, 1e-3), before, 1e-12);
  EXPECT_NEAR(at(1e-5, 0), before + a * std::log(10), 1e-12);
  double last = before + a * std::log(10);
  for (int i = 0; i < 20; ++i) {
    const double now = at(1e-5, 0.2 * L / 1e-5);
    EXPECT_LT(now, last);
    last = now;
  }
  for (int i = 0; i < 100; ++i) last = at(1e-5, 0.2 * L / 1e-5);
  EXPECT_NEAR(last, after, 1e-9);
}

TEST(StickSlip_analytic, is_a_saw_tooth_about_the_limit_counted_from_the_middle_of_the_stroke) {
  Experiment e = test::experiment(Motion::sliding);
  Mechanics m = test::with(e, {{"stick_slip", {4 * uN, 10 * nm}}}, 0.2);
  const auto& change = m.lateral.limit_changes.at(0);
  SlipState state;
  const auto at = [&](double path) { return state.path = path, change(100 * uN, state); };
  const double middle = e.stroke / 2;
  EXPECT_NEAR(at(middle + 2.5 * nm), 100 * uN - 1 * uN, 1e-12);  // a quarter of the rise from -2 uN
  EXPECT_NEAR(at(middle + 5 * nm), 100 * uN, 1e-12);
  EXPECT_NEAR(at(middle + 15 * nm), at(middle + 5 * nm), 1e-12);
  EXPECT_NEAR(at(middle - 5 * nm), at(middle + 5 * nm), 1e-12);
  EXPECT_EQ(at(0), 100 * uN);  // before sliding there are no events
}

/// A saw-tooth in both directions.
TEST(StickSlip_analytic, reads_period_and_amplitude_off_the_residuals) {
  const double amplitude = 3 * uN, period = 9 * nm;
  Samples samples = test::lateral_path(1e-3, {0, 200 * nm, 0}, 800);
  samples.parts = 2;
  std::vector<double> residual;
  std::mt19937 random(21);
  std::normal_distribution<double> noise(0, 0.1 * amplitude);
  for (std::size_t i = 0; i < samples.list.size(); ++i) {
    Sample& s = samples.list[i];
    s.part = i < 800 ? 0 : 1;
    s.since_reversal = i < 800 ? s.lateral_displacement : 200 * nm - s.lateral_displacement;
    const double part = s.since_reversal / period;
    residual.push_back(s.direction * amplitude * (part - std::floor(part) - 0.5) + noise(random));
  }
  const auto starts = effect_of("stick_slip").starts(samples, residual);
  ASSERT_GE(starts.size(), 1u);
  EXPECT_NEAR(starts[0][0] / amplitude, 1, 0.1);
  EXPECT_NEAR(starts[0][1] / period, 1, 0.02);
  Samples few = test::lateral_path(1e-3, {0, 10 * nm}, 10);
  few.parts = 1;
  EXPECT_TRUE(effect_of("stick_slip").starts(few, std::vector<double>(10, 0.0)).empty());
}

/// Steady force under one load.
double steady_force(const Mechanics& law, double load) {
  Samples samples;
  Sample row;
  row.normal_force = load, row.radius = law.experiment.radius;
  samples.list = {row};
  test::close_run(samples, true);
  return simulate(law, samples).front();
}

/// Entries of a case that loses this work of adhesion [J/m^2] as it rolls.
std::map<std::string, double> lost_work_in_case(const Experiment& e, double lost) {
  std::map<std::string, double> values;
  for (const auto& change : effect_of("rolling_adhesion_hysteresis").case_changes(e, &lost))
    values[change.entry] = change.value;
  return values;
}

TEST(RollingAdhesionHysteresis_analytic, loses_its_work_over_the_width_of_Hertz_contact) {
  Experiment e = test::experiment(Motion::rolling);
  e.by_finite_elements = true, e.case_spacing = 20 * nm, e.case_work_of_adhesion = 0.02;
  const double load = 300 * uN, radius = std::cbrt(0.75 * load * e.radius / e.reduced_modulus());
  const Mechanics law = test::with(e, {{"rolling_adhesion_hysteresis", {0.05}}}, 1e-4);
  EXPECT_NEAR(steady_force(law, load) / (1e-4 * load + 2 * radius * 0.05), 1, 1e-9);
  const auto changes = lost_work_in_case(e, 0.05);
  const double opening = changes.at("Interface/Work of adhesion on separation"),
               closing = changes.at("Interface/Work of adhesion"),
               range = changes.at("Interface/Adhesion range");
  EXPECT_DOUBLE_EQ(closing, 0.02);
  EXPECT_DOUBLE_EQ(opening, 0.07);
  EXPECT_GT(attraction_zone(e.reduced_modulus(), opening, opening / range), 5 * e.case_spacing);
}

/// A case that derives its mesh from the load is given one whose cells the zone of attraction covers.
TEST(RollingAdhesionHysteresis_behaviour, resolves_its_zone_where_the_case_names_no_spacing) {
  Experiment e = test::experiment(Motion::rolling);
  e.by_finite_elements = true;
  auto changes = lost_work_in_case(e, 0.05);
  const double opening = changes.at("Interface/Work of adhesion on separation"),
               range = changes.at("Interface/Adhesion range"), spacing = changes["Mesh/Interface spacing"];
  ASSERT_GT(spacing, 0);
  EXPECT_GT(e.hertz().contact_radius(e.largest_force) / spacing, 15);
  EXPECT_GT(attraction_zone(e.reduced_modulus(), opening, opening / range), 5 * spacing);
}

/// M = (3 pi/16) mu f a (Lubkin 1951), over the particle's radius.
TEST(FrictionCoefficient_analytic, of_torsion_acts_over_the_radius_of_the_contact) {
  Experiment e = test::experiment(Motion::torsion);
  e.by_finite_elements = true, e.case_friction = 0.3;
  const double load = 300 * uN, radius = std::cbrt(0.75 * load * e.radius / e.reduced_modulus());
  const Mechanics law = test::with(e, {{"friction_coefficient", {0.4}}}, 1e-4);
  EXPECT_NEAR(steady_force(law, load) / (3 * M_PI / 16 * 0.4 * load * radius / e.radius), 1, 1e-9);
}

}  // namespace
}  // namespace asperity
