// What the assembled mechanics of sliding, rolling and torsion says, against formulas worked out by hand.
#include "diagnosis/mechanics/mechanics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/shear_moduli.h"
#include "dem_compare/laws/mindlin_deresiewicz.h"
#include "dem_compare/laws/rail_balance.h"
#include "diagnosis/mechanics/strip_contact.h"
#include "tests/diagnosis/support/assembled_mechanics.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

using test::experiment;
using test::lateral_path;
using test::nm;
using test::row;
using test::uN;
using test::with;

TEST(LateralMechanics_analytic, lateral_stiffness_is_mindlins_with_the_compliance_in_series) {
  const Experiment e = experiment(Motion::sliding);
  const double load = 1e-3, a = e.hertz().contact_radius(load),
               k = 8 * reduced_shear_modulus(e.particle, e.substrate) * a, C = 3e-5;
  const auto alone = simulate(with(e, {}), lateral_path(load, {0, 1 * nm}, 11));
  const auto soft = simulate(with(e, {{"lateral_compliance", {C}}}), lateral_path(load, {0, 1 * nm}, 11));
  EXPECT_NEAR(alone[10], k * nm, 1e-9 * k * nm);
  EXPECT_NEAR(soft[10], nm / (1 / k + C), 1e-9 * k * nm);
}

TEST(LateralMechanics_analytic, sliding_ends_at_mu_times_load_and_reverses) {
  const Experiment e = experiment(Motion::sliding);
  const auto f = simulate(with(e, {}), lateral_path(1e-3, {0, 100 * nm, 0}, 101));
  EXPECT_NEAR(f[100], 0.2e-3, 1e-12);
  EXPECT_NEAR(f.back(), -0.2e-3, 1e-12);
}

TEST(LateralMechanics_analytic, friction_limits_change_as_their_equations_say) {
  const Experiment e = experiment(Motion::sliding);
  const double load = 1e-3, a = e.hertz().contact_radius(load);
  const Samples path = lateral_path(load, {0, 200 * nm}, 2001);
  const auto end = [&](const std::vector<std::pair<std::string, std::vector<double>>>& effects) {
    return simulate(with(e, effects), path).back();
  };
  EXPECT_NEAR(end({{"adhesion_offset", {0.2e-3}}}), 0.2 * 1.2e-3, 1e-12);
  EXPECT_NEAR(end({{"area_proportional_friction", {3e8}}}), 3e8 * M_PI * a * a, 1e-12);
  EXPECT_NEAR(end({{"surface_tilt", {0.02}}}), 0.2e-3 + std::tan(0.02) * load, 1e-12);
  EXPECT_NEAR(end({{"lateral_zero_offset", {5 * uN}}}), 0.2e-3 + 5 * uN, 1e-12);
  EXPECT_NEAR(end({{"velocity_dependence", {0.01}}}),
              (0.2 + 0.01 * std::log(path.list[9].speed / std::sqrt(e.slowest * e.fastest))) * load, 1e-12);
}

TEST(LateralMechanics_analytic, static_friction_decays_over_its_slip_length) {
  const Experiment e = experiment(Motion::sliding);
  const Samples path = lateral_path(1e-3, {0, 100 * nm}, 10001);
  const auto f = simulate(with(e, {{"static_friction_peak", {1.5, 20 * nm}}}), path);
  EXPECT_NEAR(*std::max_element(f.begin(), f.end()), 0.3e-3, 0.001e-3);
  const double k = 8 * reduced_shear_modulus(e.particle, e.substrate) * e.hertz().contact_radius(1e-3);
  const double slipped = 80 * nm - 0.3e-3 / k;  // sliding begins when the spring holds mu_s f_n
  EXPECT_NEAR(f[8000], 0.2e-3 * (1 + 0.5 * std::exp(-slipped / (20 * nm))), 0.001e-3);
}

TEST(LateralMechanics_analytic, running_in_fades_over_the_cycles) {
  const Experiment e = experiment(Motion::sliding);
  Samples path = lateral_path(1e-3, {0, 100 * nm}, 101);
  for (auto& s : path.list) s.cycles_passed = 4;
  EXPECT_NEAR(simulate(with(e, {{"run_in", {0.5, 2}}}), path).back(), 0.2e-3 * (1 + 0.5 * std::exp(-2)),
              1e-12);
}

TEST(LateralMechanics_analytic, stick_slip_drops_by_its_amplitude_and_comes_back_after_its_period) {
  const Experiment e = experiment(Motion::sliding);
  const Samples path = lateral_path(1e-3, {0, 200 * nm}, 20001);
  const auto f = simulate(with(e, {{"stick_slip", {50 * uN, 20 * nm}}}), path);
  double low = 1, high = 0;
  int drops = 0;
  for (std::size_t i = 6001; i < f.size(); ++i) {
    low = std::min(low, f[i]);
    high = std::max(high, f[i]);
    drops += f[i - 1] - f[i] > 40 * uN;
  }
  EXPECT_NEAR(high, 225 * uN, 0.1 * uN);
  EXPECT_NEAR(low, 175 * uN, 0.1 * uN);
  EXPECT_EQ(drops, 7);  // 140 nm of sliding
}

TEST(LateralMechanics_analytic, a_step_of_speed_jumps_by_a_and_settles_at_a_minus_b) {
  Experiment e = experiment(Motion::sliding);
  Samples path = lateral_path(1e-3, {0, 4000 * nm}, 4001);
  double time = 0;
  for (std::size_t i = 0; i < path.list.size(); ++i) {
    const double v = i < 2000 ? e.slowest : e.fastest;
    path.list[i].speed = v;
    path.list[i].time = time += 1 * nm / v;
  }
  const double a = 0.01, b = 0.015, L = 50 * nm, ratio = std::log(e.fastest / e.slowest);
  const auto f = simulate(with(e, {{"rate_and_state", {a, b, L}}}), path);
  EXPECT_NEAR((f[2000] - f[1999]) / 1e-3, a * ratio,
              0.05 * a * ratio);  // within a step of 1 nm some of the decay
  EXPECT_NEAR((f[4000] - f[1999]) / 1e-3, (a - b) * ratio, 1e-6);
}

TEST(LateralMechanics_other_code, strips_follow_mindlin_and_deresiewicz_through_load_and_shear) {
  const Experiment e = experiment(Motion::sliding);
  const double G = reduced_shear_modulus(e.particle, e.substrate), mu = 0.3;
  const MindlinDeresiewicz law{G, e.radius, {mu, 0}};
  SlidingHistory history;
  StripContact strips, next;
  const double loads[] = {1e-3, 1e-3, 1e-3, 2e-3, 2e-3, 1.2e-3, 1.2e-3};
  const double shifts[] = {3 * nm, -4 * nm, 2.5 * nm, 3 * nm, -8 * nm, 1 * nm, 5 * nm};
  double load = 1e-3;
  for (int leg = 0; leg < 7; ++leg)
    for (int step = 0; step < 100; ++step) {
      load += (loads[leg] - (leg ? loads[leg - 1] : 1e-3)) / 100;
      const double a = e.hertz().contact_radius(load);
      history = law.advance(history, {e.hertz().approach(load), load, a, 0, true}, {shifts[leg] / 100, 0, 0});
      const double force = strips.advance(8 * G * a, mu * load, a, shifts[leg] / 100, next);
      strips = next;
      EXPECT_NEAR(force, history.spring.resistance.x(), 0.006 * mu * load) << leg << " " << step;
    }
}

TEST(LateralMechanics_analytic, partial_slip_from_rest_is_mindlins_curve) {
  const Experiment e = experiment(Motion::sliding);
  const double load = 1e-3, a = e.hertz().contact_radius(load),
               G = reduced_shear_modulus(e.particle, e.substrate), x = 1.5 * nm;
  const auto f = simulate(with(e, {{"partial_slip", {}}}), lateral_path(load, {0, x}, 51));
  const double gross = 3 * 0.2 * load / (16 * G * a);
  EXPECT_NEAR(f.back(), 0.2 * load * (1 - std::pow(1 - x / gross, 1.5)), 0.001 * 0.2 * load);
}

TEST(LateralMechanics_analytic, a_contact_that_attracts_slips_partly_as_one_under_load_and_attraction) {
  // Derjaguin, Muller & Toporov (1975): the contact is Hertz's under both, and so is Mindlin's stiffness.
  const Experiment e = experiment(Motion::sliding);
  const double load = 1e-3, attraction = 5e-4, x = 1.5 * nm;
  const auto path = [&](double force) { return lateral_path(force, {0, x, -x}, 51); };
  const auto attracted =
      simulate(with(e, {{"partial_slip", {}}, {"adhesion_offset", {attraction}}}), path(load));
  const auto pressed = simulate(with(e, {{"partial_slip", {}}}), path(load + attraction));
  ASSERT_EQ(attracted.size(), pressed.size());
  for (std::size_t i = 0; i < pressed.size(); ++i) EXPECT_NEAR(attracted[i], pressed[i], 1e-9 * load) << i;
}

TEST(LateralMechanics_analytic, rolling_resistance_is_mu_times_load_with_an_offset) {
  const Experiment e = experiment(Motion::rolling);
  EXPECT_NEAR(simulate(with(e, {}, 5e-4), row(e, 2e-3))[0], 1e-6, 1e-15);
  EXPECT_NEAR(simulate(with(e, {{"rolling_adhesion_offset", {1e-3}}}, 5e-4), row(e, 2e-3))[0], 1.5e-6, 1e-15);
  EXPECT_NEAR(simulate(with(e, {{"viscous_rolling", {3.0}}}, 5e-4), row(e, 2e-3))[0],
              (5e-4 + 3 * 1e-5) * 2e-3, 1e-15);
}

TEST(LateralMechanics_analytic, rolling_over_the_contact_radius_sums_both_contacts) {
  const Experiment e = experiment(Motion::rolling);
  const Hertz above{reduced_modulus(e.particle, e.indenter), e.radius}, below = e.hertz();
  const double f = 2e-3, mu = 0.02;
  EXPECT_NEAR(simulate(with(e, {{"contact_radius_scaling", {mu}}}), row(e, f))[0],
              mu * f * (above.contact_radius(f) + below.contact_radius(f)) / (2 * e.radius), 1e-15);
}

TEST(LateralMechanics_analytic, rolling_friction_falls_with_roughness) {
  const Experiment e = experiment(Motion::rolling);
  Samples one = row(e, 2e-3);
  one.list[0].rms_roughness = 2 * nm;
  EXPECT_NEAR(simulate(with(e, {{"roughness_dependent_rolling", {3e-4, 6e-4, 1 * nm}}}), one)[0],
              (3e-4 + 6e-4 * std::exp(-2)) * 2e-3, 1e-15);
}

TEST(LateralMechanics_other_code, a_rail_resists_as_the_papers_balance_says) {
  const Experiment e = experiment(Motion::rail);
  for (const double degrees : {25.0, 45.0, 60.0}) {
    const double angle = degrees * (M_PI / 180), slope_force = 1e-3;
    Samples one = row(e, slope_force);
    one.list[0].rail_angle = angle;
    one.runs[0].at = ForcePlace::substrate;
    const double mu = rail_friction(angle, {4e-4, 5e-3, 0, 0});
    EXPECT_NEAR(simulate(with(e, {{"torsion_resistance", {5e-3}}}, 4e-4), one)[0], mu * slope_force,
                1e-12 * mu)
        << degrees;
    // At the plate: both slopes' lateral forces, and the load that stands on them.
    one.runs[0].at = ForcePlace::indenter;
    one.list[0].normal_force = 2 * std::cos(angle) * slope_force;
    EXPECT_NEAR(simulate(with(e, {{"torsion_resistance", {5e-3}}}, 4e-4), one)[0], 2 * mu * slope_force,
                1e-12 * mu)
        << degrees;
  }
}

TEST(LateralMechanics_analytic, torsion_over_the_contact_radius_follows_its_growth) {
  const Experiment e = experiment(Motion::torsion);
  EXPECT_NEAR(simulate(with(e, {}, 5e-3), row(e, 2e-3))[0], 1e-5, 1e-15);
  EXPECT_NEAR(simulate(with(e, {{"contact_radius_scaling", {0.064}}}), row(e, 2e-3))[0],
              0.064 * e.hertz().contact_radius(2e-3) / e.radius * 2e-3, 1e-15);
}

}  // namespace
}  // namespace asperity
