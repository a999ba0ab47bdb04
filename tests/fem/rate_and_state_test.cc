// Friction with a rate and a state: the law, a sphere that slides at two speeds and rests between, against a
// spring slider that is integrated on its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/error.h"
#include "fem/contact/rate_limited_shear.h"
#include "fem/interface/friction/rate_and_state.h"
#include "tests/fem/support/frictional_contact.h"
#include "tests/fem/support/glass_sphere.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace asperity;

/// Weakens with the speed in steady sliding: b > a.
constexpr fem::RateAndStateConstants ageing{0.3, 0.01, 0.015, 50e-9, 1e-6};

test::Verified of_rates(const std::string& what, const char* source) {
  return {"Sliding", "rate and state: " + what, source};
}

/// mu + a ln(V/V0) + b ln(V0 theta/L): not regularised.
double logarithmic_friction(double rate, double age) {
  return ageing.coefficient + ageing.direct * std::log(rate / ageing.reference) +
         ageing.evolution * std::log(ageing.reference * age / ageing.length);
}

TEST(RateAndState_analytic, is_the_logarithmic_law_above_creep_and_zero_at_rest) {
  const fem::RateAndState law(ageing);
  test::Largest error;
  for (const double rate : {1e-9, 1e-6, 1e-3})
    for (const double age : {1e-3, 1.0, 1e4})
      error.count(law.friction(rate, age) / logarithmic_friction(rate, age) - 1);
  EXPECT_TRUE(of_rates("coefficient from 1 nm/s to 1 mm/s", "Ruina (1983)").below(error, 1e-9));
  EXPECT_EQ(law.friction(0, 1), 0);
  EXPECT_LT(law.friction(1e-25, 1), 0.01);
}

/// Age of a point that slips at a rate for a time.
TEST(RateAndState_analytic, ages_at_rest_and_is_renewed_by_slip) {
  const fem::RateAndState law(ageing);
  const auto aged = [&](double before, double rate, double time) {
    fem::InterfacePoint point;
    point.pressure = 1e9, point.slip_rate = rate, point.time_step = time, point.slip = {rate * time, 0};
    double history = before;
    law.remember(point, &history);
    return history;
  };
  EXPECT_DOUBLE_EQ(aged(3, 0, 5), 8);
  const double steady = ageing.length / 1e-6;
  EXPECT_NEAR(aged(3, 1e-6, 1), steady, 1e-6 * steady);
  EXPECT_NEAR(aged(3, 1e-6, 0.05), steady + (3 - steady) / M_E, 1e-12);
}

/// A law whose limit is linear in the slip of the step, solved by hand.
class Viscous : public fem::FrictionLaw {
 public:
  fem::ShearLimit limit(const fem::InterfacePoint& point, const double*) const override {
    return {1e9 * point.slip_rate, 0};
  }
};

TEST(RateLimitedShear_analytic, is_that_of_a_dashpot_in_series_with_the_penalty) {
  fem::InterfacePoint point;
  point.pressure = 1e9, point.time_step = 0.5;
  const double c = 1e9 / 0.5, k = 1e10, share = c / (c + k);
  const fem::PlaneVector trial{3e7, -4e7};
  const fem::Shear shear = fem::return_to_rate(Viscous(), point, nullptr, trial, k);
  for (int i = 0; i < 2; ++i) EXPECT_NEAR(shear.traction[i] / trial[i], share, 1e-9);
  EXPECT_NEAR(shear.secant(), share, 1e-9);
  EXPECT_TRUE(shear.slips);
  // Linear, so that the tangent is the secant in all directions.
  EXPECT_NEAR(shear.xx, share, 1e-6);
  EXPECT_NEAR(shear.xy, 0, 1e-6);
  EXPECT_NEAR(shear.yy, share, 1e-6);
}

TEST(RateLimitedShear_analytic, has_the_derivative_of_the_traction_as_its_tangent) {
  const fem::RateAndState law(ageing);
  fem::InterfacePoint point;
  point.pressure = 1e9, point.time_step = 1e-3;
  const double age = 0.1, k = 1e17;
  test::Largest error;
  for (const double size : {1e8, 2.8e8, 3.2e8, 6e8}) {
    const fem::PlaneVector trial{0.6 * size, -0.8 * size};
    const fem::Shear shear = fem::return_to_rate(law, point, &age, trial, k);
    for (int j = 0; j < 2; ++j) {
      const double step = 1e-5 * size;
      fem::PlaneVector up = trial, down = trial;
      up[j] += step, down[j] -= step;
      const auto above = fem::return_to_rate(law, point, &age, up, k).traction,
                 below = fem::return_to_rate(law, point, &age, down, k).traction;
      error.count((j == 0 ? shear.xx : shear.xy) - (above[0] - below[0]) / (2 * step));
      error.count((j == 0 ? shear.xy : shear.yy) - (above[1] - below[1]) / (2 * step));
    }
  }
  EXPECT_TRUE(of_rates("tangent of the shear", "finite differences").below(error, 1e-3, "of the penalty"));
}

/// A rigid slider on a spring under a load P, whose friction is the law's: stiffness dx/dt = V - v, with v of
/// friction = P f(v, theta), d theta/dt = 1 - v theta/L, by steps of Runge and Kutta.
struct SpringSlider {
  double load, stiffness, force = 0, age = 1;
  double slipped = 0, work = 0;

  double rate(double q, double theta) const {
    const double exponent =
        (ageing.coefficient + ageing.evolution * std::log(ageing.reference * theta / ageing.length)) /
        ageing.direct;
    return ageing.reference * (std::exp(q / (ageing.direct * load) - exponent) -
                               std::exp(-q / (ageing.direct * load) - exponent));
  }
  void pull(double speed, double time) {
    while (time > 0) {
      const double v = std::max({std::abs(rate(force, age)), speed, 1e-12});
      const double step =
          std::min({time, 0.2 * ageing.direct * load / (stiffness * v), 0.02 * ageing.length / v});
      double dq[4], da[4];
      for (int stage = 0; stage < 4; ++stage) {
        const double share = stage == 0 ? 0 : stage == 3 ? 1 : 0.5;
        const double q = force + share * step * (stage == 0 ? 0 : dq[stage - 1]),
                     theta = age + share * step * (stage == 0 ? 0 : da[stage - 1]);
        const double slip_rate = rate(q, theta);
        dq[stage] = stiffness * (speed - slip_rate), da[stage] = 1 - slip_rate * theta / ageing.length;
      }
      force += step / 6 * (dq[0] + 2 * dq[1] + 2 * dq[2] + dq[3]);
      age += step / 6 * (da[0] + 2 * da[1] + 2 * da[2] + da[3]);
      time -= step;
    }
  }
};

/// A sphere that is slid as the slider is pulled.
struct SlidByRate {
  test::FrictionalContactOptions options;
  test::FrictionalContact contact;
  fem::ContactSolver solver;
  fem::ContactState state;
  SpringSlider slider;
  double position = 0, work = 0, dissipated = 0, force = 0;
  test::Largest difference;  ///< of the coefficients of sphere and slider

  static test::FrictionalContactOptions sphere() {
    test::FrictionalContactOptions o;
    o.cells_per_radius = 6, o.path_length = 1.0e-6, o.loaded = false, o.slip_tolerance = 3e-4;
    return o;
  }
  static fem::ContactSolverOptions solving(const test::FrictionalContactOptions& o) {
    auto options = test::FrictionalContact::solver_options(o);
    options.friction = std::make_shared<fem::RateAndState>(ageing);
    return options;
  }
  SlidByRate()
      : options(sphere()),
        contact(options),
        solver(contact.system, solving(options)),
        state(solver.first_touch()) {
    state.motion.x = position = -0.5e-6;
    const double a = contact.contact_radius;
    // Points give way by 0.8 of 3 C/(16 a) on average over the pressure (Mindlin 1949).
    const double give =
        0.8 * 3 * test::GlassSphere::lateral_compliance / (16 * a) + contact.lateral_far_field;
    slider = {options.load, 1 / give};
    solver.push_rigidly(state, 0.8 * a * a / options.radius);
    go(0, 1);
    slider.age = 1, slider.force = 0;
  }
  /// Coefficient of friction at the end of a step.
  double go(double shift, double time) {
    fem::RigidMotion motion = state.motion;
    motion.x = position += shift;
    const auto before = state.displacement;
    const auto report = solver.solve(state, options.load, motion, time);
    EXPECT_TRUE(report.converged) << position << " " << time;
    contact.system.bodies().accept(before, state.displacement);
    const double now = solver.resultants(state).lateral_force[0];
    work += 0.5 * (force + now) * shift, force = now;
    dissipated += report.friction_work;
    slider.pull(shift / time, time);
    return now / options.load;
  }
  double slide(const std::vector<double>& steps, double speed, bool largest = false) {
    double last = 0, most = 0;
    constexpr double begun = 4.5e-9;  // the bodies have given way
    double way = 0;
    for (const double step : steps) {
      most = std::max(most, last = go(step, step / speed)), way += step;
      if (way > begun) difference.count(last - slider.force / options.load);
    }
    return largest ? most : last;
  }
};

TEST(RateAndStateSphere_analytic, jumps_with_the_speed_comes_back_over_its_length_and_heals_at_rest) {
  constexpr double slow = 1e-6, fast = 1e-5, nm = 1e-9;
  SlidByRate s;
  const std::vector<double> fine{0.25 * nm, 0.25 * nm, 0.5 * nm, 1 * nm, 2 * nm, 4 * nm, 8 * nm, 12 * nm},
      on(10, 40 * nm);
  s.slide(fine, slow);
  const double before = s.slide(on, slow), jump = s.slide(fine, fast, true), after = s.slide(on, fast);
  const double a = ageing.direct, b = ageing.evolution;
  EXPECT_TRUE(of_rates("coefficient at two speeds, beyond 4 nm", "spring slider, integrated on its own")
                  .below(s.difference, 5e-4));
  EXPECT_TRUE(of_rates("direct effect of ten times the speed", "a ln 10")
                  .within(jump - before, a * std::log(10.0), 0.08));
  EXPECT_TRUE(of_rates("steady friction at ten times the speed", "(a - b) ln 10")
                  .within(after - before, (a - b) * std::log(10.0), 0.05));
  for (int k = 0; k < 21; ++k) s.go(0, 100 * std::pow(2.0, k) / ((1 << 21) - 1));
  const double held = s.force / s.options.load, slider_held = s.slider.force / s.options.load;
  EXPECT_TRUE(of_rates("creep in 100 s of rest, steps that double: coefficient",
                       "spring slider, integrated on its own")
                  .within(held, slider_held, 0.03));
  s.difference = {};
  const double peak = s.slide({0.5 * nm, 1 * nm, 1.5 * nm, 2 * nm, 4 * nm, 8 * nm, 12 * nm}, fast, true);
  EXPECT_TRUE(of_rates("friction after 100 s of rest", "spring slider, integrated on its own")
                  .below(s.difference, 5e-4));
  EXPECT_TRUE(of_rates("peak after 100 s of rest over steady friction", "b ln(1 + t V/L)")
                  .within(peak - after, b * std::log(1 + 100 * fast / ageing.length), 0.03));
  const double stored = 0.5 * s.force * s.force / s.slider.stiffness;
  EXPECT_TRUE(of_rates("work less friction and what the bodies store", "balance")
                  .below((s.work - s.dissipated - stored) / s.work, 0.01));
}

/// As a case: two parts of a program at their speeds.
TEST(RateAndStateCase_analytic, weakens_with_the_speed_that_a_program_says) {
  const test::TemporaryFolder folder;
  const std::string law =
      "set Friction coefficient = 0.3\n set Direct effect = 0.01\n set Evolution effect = 0.015\n"
      " set Renewal length = 20 nm\n set Reference speed = 1 um/s\n";
  const auto input = [&](const std::string& program) {
    return test::glass_case(
        folder.path, law,
        "set Type = program\n set Normal load = 100 uN\n set Load steps = 2\n set Unload = "
        "false\n set Load time = 1 s\n set Program = " +
            program + "\n",
        "set Interface spacing = 43 nm\n set Contact region = 320 nm\n");
  };
  const auto s = test::solve_experiment(input("slide 200 nm at 1 um/s; slide 200 nm at 10 um/s"),
                                        folder.path / "solved");
  const auto force = s.history.numbers("lateral_force [N]"),
             shift = s.history.numbers("lateral_displacement [m]");
  double slow = 0;
  for (std::size_t k = 0; k < shift.size(); ++k)
    if (shift[k] < 199.9e-9) slow = force[k];
  EXPECT_TRUE(of_rates("case of two speeds: difference of friction", "(a - b) ln 10 P")
                  .within(force.back() - slow, -0.005 * std::log(10.0) * 100e-6, 0.05));
  EXPECT_TRUE(
      of_rates("case of two speeds: friction at the reference speed", "mu P").within(slow, 30e-6, 0.01));
  EXPECT_TRUE(test::leaves_no_energy_open("Sliding", "rate and state", s));
  const auto message = [&](const std::string& program) {
    return test::message_of<InputError>([&] { check_case(input(program)); });
  };
  EXPECT_NE(message("slide 120 nm").find("set Experiment/Speed, e.g. 1 um/s"), std::string::npos)
      << message("slide 120 nm");
  EXPECT_NO_THROW(check_case(input("slide 120 nm at 1 um/s; hold 10 s in 3 steps")));
}

}  // namespace
