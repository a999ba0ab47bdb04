// Bodies whose shear modulus relaxes: at a point, pressed, and rolled.
#include "fem/materials/relaxation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.h"
#include "core/printed.h"
#include "fem/case/fine_path.h"
#include "tests/fem/support/relaxing_half_space.h"
#include "tests/fem/support/solved_experiment.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;
using fem::Relaxation;
using fem::RelaxationStep;
using test::SolvedExperiment;
using test::Verified;

constexpr double relaxing_share = 0.6, relaxing_time = 2.0;

/// Shear stress over 2G after strains that change evenly between the times.
double stress_at_point(const std::vector<double>& times, const std::vector<double>& strains) {
  fem::SymmetricTensor<fem::Simd<double>> before{}, now{}, viscous{};
  double last = 0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    before = now;
    now[3] = fem::Simd<double>{} + strains[k];
    fem::relax(RelaxationStep({relaxing_share, relaxing_time}, times[k] - last), before, now, 0, viscous);
    last = times[k];
  }
  return now[3][0] - viscous[3][0];
}

TEST(Relaxation_analytic, a_ramp_and_a_hold_are_exact_whatever_the_steps) {
  constexpr double ramp = 0.7, until = 3.1, rate = 1e-3;
  const double g = relaxing_share, tau = relaxing_time;
  // int_0^ramp [1 - g (1 - exp(-(t - s)/tau))] rate ds
  const double expected =
      rate * ((1 - g) * ramp + g * tau * (std::exp(-(until - ramp) / tau) - std::exp(-until / tau)));
  EXPECT_TRUE((Verified{"Material law", "standard linear solid, ramp and hold in two steps: stress",
                        "hereditary integral"}
                   .below(stress_at_point({ramp, until}, {rate * ramp, rate * ramp}) / expected - 1, 1e-12)));
  EXPECT_NEAR(stress_at_point({0.2, 0.7, 0.8, 2.0, 3.1}, {0.2e-3, 0.7e-3, 0.7e-3, 0.7e-3, 0.7e-3}) / expected,
              1, 1e-12);
}

TEST(Relaxation_analytic, fast_and_slow_strain_meet_their_moduli) {
  EXPECT_NEAR(stress_at_point({1e-9}, {1e-3}) / 1e-3, 1, 1e-8);
  EXPECT_NEAR(stress_at_point({1e-9, 1e3}, {1e-3, 1e-3}) / 1e-3, 1 - relaxing_share, 1e-12);
}

/// A polymer sphere, nearly incompressible, on a block that hardly gives way.
CaseInput pressed_polymer(double share, double time) {
  CaseInput c;
  c.file = "test.prm";
  c.radius = 8.5e-6;
  c.particle.youngs_modulus = 3e9, c.particle.poisson_ratio = 0.49;
  c.substrate.youngs_modulus = 3e12, c.substrate.poisson_ratio = 0.25;
  if (share > 0) c.particle.parameters = {{"Relaxing share", share}, {"Relaxation time", time}};
  c.experiment.load_time = 1;
  c.experiment.unload = false;
  c.mesh.interface_spacing = 40e-9;
  c.mesh.layers = 2;
  c.solver.threads = 1;
  c.output.fields = false;
  return c;
}

/// The elastic body that is left in the end.
BodyInput relaxed_polymer(BodyInput body) {
  const double E = body.youngs_modulus, nu = body.poisson_ratio, K = E / (3 * (1 - 2 * nu)),
               left = (1 - body.parameters.at("Relaxing share")) * E / (2 * (1 + nu));
  body.parameters.clear();
  body.youngs_modulus = 9 * K * left / (3 * K + left);
  body.poisson_ratio = (3 * K - 2 * left) / (2 * (3 * K + left));
  return body;
}

SolvedExperiment solved_in_time(const CaseInput& input) {
  const test::TemporaryFolder folder;
  return test::solve_experiment(input, folder.path);
}

/// M(t) = E/(1 - nu^2) under a held strain over its first value: the bulk modulus stays (Lee & Radok 1960).
class RelaxingIndentation {
 public:
  RelaxingIndentation(double nu, double share, double time) : time_(time) {
    const double G = 1, K = 2 * (1 + nu) / (3 * (1 - 2 * nu)), slow = 1 - share;
    // Carson transform with p = s tau: G(p) = (p + slow)/(p + 1), M = 4 G (3K + G)/(3K + 4G).
    const auto numerator = [&](double p) {
      return 4 * G * (p + slow) * ((3 * K + G) * p + 3 * K + G * slow);
    };
    const double lead = 3 * K + 4 * G;
    rate_[0] = 1, rate_[1] = (3 * K + 4 * G * slow) / lead;
    const double fast = 4 * G * (3 * K + G) / lead;
    for (int i = 0; i < 2; ++i) {
      const double p = -rate_[i], other = p + rate_[1 - i];
      part_[i] = numerator(p) / (lead * other) / p / fast;
    }
    end_ = 4 * G * slow * (3 * K + G * slow) / (3 * K + 4 * G * slow) / fast;
  }
  double at(double t) const {
    double sum = end_;
    for (int i = 0; i < 2; ++i) sum += part_[i] * std::exp(-rate_[i] * t / time_);
    return sum;
  }

 private:
  double time_, end_ = 1, part_[2]{}, rate_[2]{};
};

/// Pressed to an approach at an even rate and held there, the force is int M(t - s) dF(d(s)) of the elastic
/// force F: the contact is that of the elastic body.
TEST(Relaxation_analytic, a_held_approach_relaxes_as_the_hereditary_integral) {
  constexpr double tau = 0.8;
  constexpr std::size_t loading = 8, holding = 5;
  CaseInput relaxing = pressed_polymer(relaxing_share, tau);
  relaxing.experiment.control = ExperimentInput::Control::displacement;
  relaxing.experiment.normal_approach = 20e-9;
  relaxing.experiment.load_steps = loading;
  relaxing.experiment.hold_steps = holding, relaxing.experiment.hold_time = 2;
  CaseInput elastic = relaxing;
  elastic.particle.parameters.clear();
  const SolvedExperiment of_relaxing = solved_in_time(relaxing), of_elastic = solved_in_time(elastic);
  const RelaxingIndentation modulus(0.49, relaxing_share, tau);
  EXPECT_NEAR(modulus.at(0), 1, 1e-12);
  // Between the steps the elastic force grows as Hertz', times what this mesh makes of it.
  const auto elastic_force = [&](double t) {
    const double steps = t * loading;
    const auto k = static_cast<std::size_t>(std::clamp(std::ceil(steps) - 1, 1.0, loading - 1.0));
    const auto beside_hertz = [&](std::size_t step) {
      return of_elastic.at("normal_force [N]", step) / std::pow((step + 1.0) / loading, 1.5);
    };
    const double part = std::max(0.0, steps - static_cast<double>(k));
    return std::pow(t, 1.5) * ((1 - part) * beside_hertz(k - 1) + part * beside_hertz(k));
  };
  test::Largest as_it_grows, held;
  for (std::size_t k = 2; k < loading + holding; ++k) {
    const double t = of_relaxing.at("time [s]", k), until = std::min(t, 1.0);
    constexpr int parts = 2000;
    double expected = 0;
    for (int i = 0; i < parts; ++i) {
      const double from = i * until / parts, to = (i + 1) * until / parts;
      expected += modulus.at(t - 0.5 * (from + to)) * (elastic_force(to) - elastic_force(from));
    }
    (k < loading ? as_it_grows : held).count(of_relaxing.at("normal_force [N]", k) / expected - 1);
  }
  const auto verified = [](const std::string& when) {
    return Verified{"Hertz", "relaxing sphere, approach in 8 steps and 5 of hold: force " + when,
                    "Lee & Radok 1960"};
  };
  EXPECT_TRUE(verified("as it grows").below(100 * as_it_grows, 0.5, "%"));
  EXPECT_TRUE(verified("held").below(100 * held, 0.2, "%"));
  EXPECT_LT(of_relaxing.result["balance"]["energy"].get<double>(), 0.01);
}

/// In the end a held load stands on elastic bodies of the modulus that is left.
TEST(Relaxation_analytic, a_held_load_ends_on_the_relaxed_modulus_and_balances_energy) {
  CaseInput relaxing = pressed_polymer(relaxing_share, 0.1);
  relaxing.particle.poisson_ratio = 0.3, relaxing.substrate.youngs_modulus = 5e9;
  relaxing.experiment.normal_load = 10e-6;
  relaxing.experiment.load_steps = 4;
  relaxing.experiment.hold_steps = 4, relaxing.experiment.hold_time = 20;
  CaseInput slow = relaxing;
  slow.particle = relaxed_polymer(relaxing.particle);
  const SolvedExperiment of_relaxing = solved_in_time(relaxing), of_slow = solved_in_time(slow);
  const double approach = of_relaxing.at("normal_displacement [m]", 7);
  EXPECT_GT(approach, 1.02 * of_relaxing.at("normal_displacement [m]", 3));
  EXPECT_TRUE((Verified{"Hertz", "relaxing sphere under a held load: approach in the end",
                        "elastic bodies of the relaxed modulus"}
                   .within(approach, of_slow.at("normal_displacement [m]", 7), 2e-3)));
  EXPECT_TRUE((Verified{"Experiment", "relaxing sphere under a held load: energy left open", "balance"}.below(
      100 * of_relaxing.result["balance"]["energy"].get<double>(), 1, "%")));
}

/// Stuck and moved aside after it has relaxed, it gives way in the end as elastic bodies of the modulus that
/// is left, far from the contact too.
TEST(Relaxation_analytic, a_held_shift_ends_on_the_relaxed_shear_modulus) {
  CaseInput relaxing = pressed_polymer(relaxing_share, 0.1);  // whose pressure and shear hardly couple
  relaxing.interface.parameters["Friction coefficient"] = 5;
  relaxing.experiment.type = Motion::program;
  relaxing.experiment.normal_load = 10e-6;
  relaxing.experiment.load_steps = 3;
  relaxing.experiment.hold_steps = 2, relaxing.experiment.hold_time = 20;
  relaxing.experiment.program = "slide 1 nm and hold 1 s in 2 steps; hold 20 s in 3 steps";
  CaseInput slow = relaxing;
  slow.particle = relaxed_polymer(relaxing.particle);
  const SolvedExperiment of_relaxing = solved_in_time(relaxing), of_slow = solved_in_time(slow);
  const std::size_t last = of_slow.history.rows.size() - 1;
  const auto stiffness = [last](const SolvedExperiment& solved) {
    return solved.at("lateral_force [N]", last) / solved.at("lateral_displacement [m]", last);
  };
  EXPECT_GT(of_relaxing.at("lateral_force [N]", last - 3) / of_relaxing.at("lateral_force [N]", last), 1.02);
  EXPECT_TRUE(
      (Verified{"Sliding", "relaxing sphere, a stuck shift that is held: lateral stiffness in the end",
                "elastic bodies of the relaxed modulus"}
           .within(stiffness(of_relaxing), stiffness(of_slow), 2e-3)));
}

TEST(Relaxation_analytic, the_mesh_holds_the_relaxed_contact_and_does_not_travel) {
  CaseInput c = pressed_polymer(0.9, 1);
  c.experiment.normal_load = 10e-6;
  CaseInput slow = c;
  slow.particle = relaxed_polymer(c.particle);
  EXPECT_NEAR(fem::set_up_sizes(c).largest_radius / fem::set_up_sizes(slow).hertz_radius, 1, 1e-9);
  c.experiment.type = slow.experiment.type = Motion::rolling;
  c.experiment.distance = slow.experiment.distance = 4e-6;
  const auto travels = [](const CaseInput& input) {
    const fem::CaseSetup setup = fem::set_up_sizes(input);
    return fem::FinePath(input, setup, fem::make_program(input.experiment, setup.motion)).travels();
  };
  EXPECT_TRUE(travels(slow));
  EXPECT_FALSE(travels(c));
}

/// Rough, both bodies relaxing, pressed, held and drawn back: resumed in the hold, and by the other solver
/// until the end of it.
TEST(Relaxation_behaviour, of_rough_bodies_resumes_balances_and_is_the_same_by_both_solvers) {
  const test::TemporaryFolder folder;
  CaseInput c = pressed_polymer(0.4, 3);
  c.substrate = c.particle;
  c.substrate.parameters["Relaxation time"] = 0.7;
  c.particle.poisson_ratio = c.substrate.poisson_ratio = 0.34;
  c.substrate.topography = "generated(rms=2 nm, hurst=0.8, rolloff=700 nm, cutoff=440 nm, seed=4)";
  c.experiment.normal_load = 10e-6;
  c.experiment.load_steps = 2, c.experiment.hold_steps = 2, c.experiment.hold_time = 2;
  c.experiment.unload = true, c.experiment.unload_steps = 2;
  c.mesh.interface_spacing = 110e-9;
  const auto whole = test::solve_and_copy_after(c, folder.path / "whole", folder.path / "cut", 3);
  const SolvedExperiment resumed = test::solve_experiment(c, folder.path / "cut", true);
  c.solver.backend = "assembled";
  c.experiment.unload = false;
  const SolvedExperiment assembled = test::solve_experiment(c, folder.path / "assembled");
  const std::size_t held = assembled.history.rows.size();
  ASSERT_EQ(held, 4u);
  EXPECT_LT(whole.result["balance"]["force"].get<double>(), 1e-5);
  EXPECT_LT(whole.result["balance"]["energy"].get<double>(), 0.02);
  for (std::size_t k = 0; k < whole.history.rows.size(); ++k)
    for (const char* column :
         {"time [s]", "normal_displacement [m]", "plastic_work [J]", "elastic_energy [J]"}) {
      const double expected = whole.at(column, k);
      EXPECT_NEAR(resumed.at(column, k), expected, 1e-6 * std::abs(expected)) << column << k;
      if (k < held) EXPECT_NEAR(assembled.at(column, k), expected, 1e-3 * std::abs(expected)) << column << k;
    }
  const auto dissipated = whole.history.numbers("dissipated_energy [J]");
  EXPECT_GT(dissipated.front(), 0);
  for (std::size_t k = 1; k < dissipated.size(); ++k) EXPECT_GE(dissipated[k], dissipated[k - 1]) << k;
  EXPECT_EQ(whole.at("plastic_volume [m^3]", 3), 0);
  EXPECT_EQ(whole.at("largest_plastic_strain", 3), 0);
}

/// Moment about the contact of steady rolling, the lag times `speed` [contact radii per second] behind which
/// stress stays, and cells per contact radius: over lag, speed and load, at the end of `path` contact radii.
double rolled_moment(double speed, double cells, double path) {
  CaseInput c = pressed_polymer(0.5, 1);  // a lag g tau/(1 - g) of a second
  c.experiment.type = Motion::rolling;
  c.experiment.normal_load = 100e-6;
  c.experiment.load_steps = 2, c.experiment.load_time = 30;
  c.experiment.reverse = false;
  const double a = hertz_of(c).contact_radius(c.experiment.normal_load) * std::cbrt(2.0);
  c.experiment.distance = path * a;
  c.mesh.interface_spacing = a / cells;
  c.experiment.speed = speed * a;
  const SolvedExperiment rolled = solved_in_time(c);
  const std::size_t last = rolled.history.rows.size() - 1,
                    steps = static_cast<std::size_t>(std::lround(cells)) - 1;
  double sum = 0;
  for (std::size_t k = last - steps; k <= last; ++k) sum += rolled.at("rolling_moment [N m]", k);
  EXPECT_LT(rolled.result["balance"]["energy"].get<double>(), 0.01);
  return sum / static_cast<double>(steps + 1) / (speed * a * c.experiment.normal_load);
}

/// Slowly, the moment is lag times speed times load (docs/theory.md), and less as the lag grows beside the
/// contact radius.
void expect_lag_to_resist(double speed, double cells, double path) {
  const double E = 3e9 / (1 - 0.49 * 0.49);
  test::RelaxingHalfSpace half_space(8.5e-6, E, 0.5, 1, 100e-6);
  const double expected = half_space.steady_moment(speed);
  EXPECT_LT(expected, 1);
  EXPECT_TRUE((Verified{
      "Rolling",
      printed("relaxing sphere, %g contact radii in the lag of stress, a/h %g: moment", speed, cells),
      "boundary elements in time"}
                   .within(rolled_moment(speed, cells, path), expected, 0.03)));
}

TEST(Relaxation_other_code, a_rolling_sphere_is_resisted_by_the_lag_of_its_stress) {
  expect_lag_to_resist(0.1, 5, 1.6);
}

TEST(RelaxationNightly_other_code, and_on_a_finer_mesh_at_half_the_speed) {
  expect_lag_to_resist(0.05, 8, 2);
}

TEST(Relaxation_behaviour, without_a_duration_is_refused) {
  CaseInput c = pressed_polymer(0.5, 1);
  c.experiment.normal_load = 1e-6;
  c.experiment.load_time = 0;
  const auto message = [&] {
    try {
      solved_in_time(c);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no refusal");
  };
  EXPECT_NE(message().find("set Experiment/Load time"), std::string::npos) << message();
  c.experiment.load_time = 1, c.experiment.hold_steps = 2;
  EXPECT_NE(message().find("set Experiment/Hold time"), std::string::npos) << message();
  c.experiment.hold_steps = 0, c.experiment.type = Motion::rolling;
  EXPECT_NE(message().find("set Experiment/Speed"), std::string::npos) << message();
  c.particle.parameters["Yield stress"] = 1e8;
  EXPECT_NE(message().find("law of a body"), std::string::npos) << message();
}

}  // namespace
