// Intervals of parameters by the rise of the cost, and the search beneath them, where both can be worked out
// by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/fit/model_fit.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

using Eigen::VectorXd;

/// Torsion at one load, a hundred rows that the coefficient 0.01 explains without residual: f = mu f_n.
struct TorsionRows {
  static constexpr double load = 1e-3, coefficient = 0.01;
  static constexpr std::size_t count = 100;
  FitProblem problem;
  ModelFit fit;

  /// `sd`: of the coefficient's logarithm, as the rows say; `stated`: as the covariance says.
  TorsionRows(double sd, double stated, const std::vector<const Effect*>& effects = {}) {
    problem.experiment = test::experiment(Motion::torsion);
    problem.choice.parameters["torsion_friction"] = {coefficient, true};
    for (std::size_t i = 0; i < count; ++i)
      problem.samples.list.push_back(test::row(problem.experiment, load).list[0]);
    test::close_run(problem.samples, true);
    for (auto& s : problem.samples.list) s.response = coefficient * load;
    problem.thin = problem.samples;
    problem.noise.sd.assign(count, sd * std::sqrt(double(count)) * coefficient * load);
    problem.noise.shared = {{}};
    fit.explanation = std::make_shared<Explanation>(problem.experiment, problem.choice, effects);
    fit.values = {coefficient};
    fit.count = count;
    fit.covariance = Eigen::MatrixXd::Constant(1, 1, stated * stated);
  }
  std::pair<double, double> stretch() const { return with_intervals(problem, fit).stretch.at(0); }
};

constexpr double within = 1.15;  // a rise within a factor of 1.3 of a parabola is taken for one

void expect_factor(double found, double expected) {
  EXPECT_LT(found, expected * within);
  EXPECT_GT(found, expected / within);
}

TEST(Intervals_analytic, are_left_as_they_are_where_the_cost_rises_as_a_parabola) {
  EXPECT_EQ(TorsionRows(0.001, 0.001).stretch(), (std::pair<double, double>{1, 1}));
  EXPECT_EQ(TorsionRows(0.001, 0.0011).stretch(), (std::pair<double, double>{1, 1}));
}

TEST(Intervals_analytic, are_widened_or_narrowed_to_where_the_cost_has_risen_by_four) {
  for (const double factor : {3.0, 10.0, 30.0}) {
    const auto narrow = TorsionRows(0.001, 0.001 / factor).stretch(),
               wide = TorsionRows(0.001, 0.001 * factor).stretch();
    expect_factor(narrow.first, factor), expect_factor(narrow.second, factor);
    // What is wide bends: the cost is that of e^x - 1.
    expect_factor(wide.first * factor, 1), expect_factor(wide.second * factor, 1);
  }
}

/// Cost ((e^x - 1)/sd)^2: it has risen by four where e^x = 1 -+ 2 sd.
TEST(Intervals_analytic, are_skew_where_the_parameter_enters_by_its_exponential) {
  constexpr double sd = 0.48;
  const auto stretch = TorsionRows(sd, sd).stretch();
  expect_factor(stretch.first, -std::log(1 - 2 * sd) / (2 * sd));
  expect_factor(stretch.second, std::log(1 + 2 * sd) / (2 * sd));
}

TEST(Intervals_analytic, go_no_further_than_sixty_four_standard_deviations_of_the_parabola) {
  // Twice the noise downwards never makes a rise of four: mu cannot fall below zero.
  const auto open = TorsionRows(0.6, 0.6).stretch();
  EXPECT_GT(open.first, 40);
  EXPECT_LE(open.first, 64);
  const auto tight = TorsionRows(1e-6, 1e-3).stretch();
  EXPECT_LT(tight.second, 1.0 / 40);
  EXPECT_GE(tight.second, 1.0 / 128);
}

TEST(Intervals_analytic, are_inflated_by_a_cost_above_one_per_sample) {
  TorsionRows rows(0.001, 0.001);
  // Residuals of two standard deviations, half above and half below: a cost of four per sample, and twice as
  // wide.
  for (std::size_t i = 0; i < TorsionRows::count; ++i)
    rows.problem.samples.list[i].response += (i % 2 ? 2 : -2) * rows.problem.noise.sd[i];
  rows.fit.cost = 4 * double(TorsionRows::count);
  expect_factor(rows.stretch().first, 2);
  expect_factor(rows.stretch().second, 2);
}

TEST(Intervals_analytic, of_a_parameter_are_two_standard_deviations_times_their_stretch_within_its_bounds) {
  TorsionRows rows(0.001, 0.1);
  DiagnosedParameter plain = rows.fit.parameter(0, 1);
  EXPECT_EQ(plain.value, 0.01);
  EXPECT_NEAR(std::log(plain.high / 0.01), 1.959964 * 0.1, 1e-9);
  EXPECT_NEAR(std::log(plain.low / 0.01), -1.959964 * 0.1, 1e-9);
  EXPECT_NEAR(std::log(rows.fit.parameter(0, 4).high / 0.01), 1.959964 * 0.2, 1e-9);
  rows.fit.stretch = {{0.5, 3}};
  EXPECT_NEAR(std::log(rows.fit.parameter(0, 1).low / 0.01), -1.959964 * 0.05, 1e-9);
  EXPECT_NEAR(std::log(rows.fit.parameter(0, 1).high / 0.01), 1.959964 * 0.3, 1e-9);
  rows.fit.stretch = {{1000, 1000}};
  const FreeParameter& p = rows.fit.explanation->parameters()[0];
  EXPECT_EQ(rows.fit.parameter(0, 1).low, p.low);
  EXPECT_EQ(rows.fit.parameter(0, 1).high, p.high);
  rows.fit.covariance.resize(0, 0);
  EXPECT_EQ(rows.fit.parameter(0, 1).low, p.low);
}

/// Of a thin film the data show thickness and modulus together far better than either: each end of an
/// interval is where the cost, with the best of the other parameter, has risen by four. noise: over the
/// largest force [-]; thickness and depth [m]. Returns how much lower than a parabola's the first one ends
/// [-].
double expect_ends_at_a_rise_of_four(double modulus_ratio, double film_thickness, double depth,
                                     double noise) {
  const Effect& film = effect_of("film");
  FitProblem problem;
  problem.experiment = test::experiment(Motion::normal);
  problem.experiment.largest_displacement = depth;
  problem.samples = test::approach_and_back(0, depth, 200);
  ModelFit fit;
  fit.explanation =
      std::make_shared<Explanation>(problem.experiment, problem.choice, std::vector<const Effect*>{&film});
  fit.values = {modulus_ratio, film_thickness};
  const std::vector<double> force = fit.simulate(problem.samples);
  for (std::size_t i = 0; i < force.size(); ++i) problem.samples.list[i].response = force[i];
  problem.thin = problem.samples;
  problem.noise.sd.assign(force.size(), noise * *std::max_element(force.begin(), force.end()));
  problem.noise.shared = {{}};
  fit = with_intervals(problem, finished(problem, fit));
  const auto cost_at = [&](double modulus, double thickness) {
    ModelFit at = fit;
    at.values = {modulus, thickness};
    double sum = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      const FreeParameter& p = fit.explanation->parameters()[k];
      if (at.values[k] < p.low || at.values[k] > p.high) return 1e300;
    }
    for (const double r : at.residual(problem.samples)) sum += std::pow(r / problem.noise.sd[0], 2);
    return sum;
  };
  const auto floor_at = [&](double value, bool of_modulus) {
    double least = 1e300;
    for (double ln = std::log(0.02); ln < std::log(3); ln += 0.002)
      least = std::min(least, of_modulus ? cost_at(value, std::exp(ln) * film_thickness)
                                         : cost_at(std::exp(ln) * modulus_ratio, value));
    return least;
  };
  for (const std::size_t k : {0u, 1u}) {
    const DiagnosedParameter p = fit.parameter(k, 1);
    for (const double end : {p.low, p.high}) {
      const double rise = floor_at(end, k == 0);
      EXPECT_GT(rise, 4 / 1.7) << p.name << " " << end;
      EXPECT_LT(rise, 4 * 1.7) << p.name << " " << end;
    }
  }
  return fit.stretch[0].first;
}

TEST(Intervals_analytic, end_where_the_floor_of_a_winding_valley_has_risen_by_four) {
  EXPECT_GT(expect_ends_at_a_rise_of_four(0.23, 56e-9, 15e-9, 0.004), 1.5);
  // Straight along the covariance the cost of this one rises as a parabola's, and on the floor much later.
  expect_ends_at_a_rise_of_four(1.5, 130e-9, 10e-9, 0.004);
}

TEST(Intervals_analytic, of_a_fit_are_those_of_the_mean_of_its_rows) {
  constexpr double sd = 0.01;
  TorsionRows rows(sd, 1);
  rows.fit.values = {0.013};
  const ModelFit found = finished(rows.problem, fit_explanation(rows.problem, {}));
  EXPECT_NEAR(found.values[0], TorsionRows::coefficient, 1e-6);
  EXPECT_NEAR(found.cost, 0, 1e-3);
  EXPECT_EQ(found.count, TorsionRows::count);
  EXPECT_NEAR(std::sqrt(found.covariance(0, 0)), sd, 0.03 * sd);
  EXPECT_NEAR(refitted(rows.problem, rows.fit, rows.problem.samples, false, 15).values[0],
              TorsionRows::coefficient, 1e-5);
}

TEST(ModelFit_behaviour, keeps_the_values_of_the_effects_that_stay) {
  const Effect &offset = effect_of("adhesion_offset"), &speed = effect_of("velocity_dependence");
  TorsionRows rows(0.01, 0.01, {&speed, &offset});
  ModelFit both = rows.fit, alone = rows.fit;
  both.values = {0.02, 3e-4, 0.004};  // in the order of assembly: the offset before the rate
  EXPECT_EQ(*both.value_of("torsion_friction", nullptr), 0.02);
  EXPECT_EQ(*both.value_of("adhesion_force", &offset), 3e-4);
  EXPECT_EQ(*both.value_of("coefficient", &speed), 0.004);
  EXPECT_EQ(both.value_of("coefficient", &offset), nullptr);
  alone.explanation = std::make_shared<Explanation>(rows.problem.experiment, rows.problem.choice,
                                                    std::vector<const Effect*>{});
  EXPECT_EQ(both.only(rows.problem, {&speed}, alone).values, (std::vector<double>{0.02, 0.004}));
  EXPECT_EQ(both.only(rows.problem, {}, alone).values, (std::vector<double>{0.02}));
  EXPECT_TRUE(both.is_itself());
}

TEST(ModelFit_analytic, residual_is_recorded_less_simulated_where_a_sample_counts) {
  Samples samples = test::approach_and_back(0, 1, 2);
  for (std::size_t i = 0; i < 4; ++i) samples.list[i].response = static_cast<double>(i);
  samples.list[2].counts = false;
  EXPECT_EQ(FitProblem::residual(samples, {1, 1, 1, 1}), (std::vector<double>{-1, 0, 0, 2}));
}

TEST(FreeParameter_analytic, coordinate_is_the_logarithm_or_the_value_over_its_scale) {
  FreeParameter p;
  p.scale = 4;
  EXPECT_EQ(p.coordinate(-2), -0.5);
  EXPECT_EQ(p.value(-0.5), -2);
  p.logarithmic = true;
  EXPECT_NEAR(p.coordinate(M_E), 1, 1e-12);
  EXPECT_NEAR(p.value(1), M_E, 1e-12);
  EXPECT_TRUE(std::isfinite(p.coordinate(0)));
}

TEST(BoundedFit_analytic, cost_is_the_square_up_to_the_bend_and_its_tangent_beyond) {
  EXPECT_EQ(huber_cost(2), 4);
  EXPECT_EQ(huber_cost(-3), 9);
  EXPECT_EQ(huber_cost(5), 21);
  EXPECT_EQ(huber_cost(-5), 21);
  EXPECT_NEAR((huber_cost(3.001) - huber_cost(3)) / 0.001, 6, 1e-6);
}

/// A step next to a slope: the slope's covariance says how far to look, steps lead to the only place where
/// both fit.
TEST(BoundedFit_analytic, search_at_random_finds_a_step_that_slopes_do_not_show) {
  const auto residuals = [](const VectorXd& x) {
    VectorXd r(2);
    r << 0.05 * (x[0] - 1), x[0] > 3 && x[0] < 4 ? 0 : 2;
    return r;
  };
  const VectorXd low = VectorXd::Constant(1, -10), high = VectorXd::Constant(1, 10);
  const BoundedFit slope = fit_within_bounds(residuals, VectorXd::Zero(1), low, high);
  EXPECT_NEAR(slope.x[0], 1, 1e-3);
  EXPECT_NEAR(slope.cost, 4, 1e-6);
  const BoundedFit found = search_at_random(residuals, slope, low, high);
  EXPECT_GT(found.x[0], 3);
  EXPECT_LT(found.x[0], 3.3);
  EXPECT_NEAR(found.cost, std::pow(0.05 * (found.x[0] - 1), 2), 1e-12);
  // Never worse, and never out of bounds.
  const BoundedFit within_bounds = search_at_random(residuals, slope, low, VectorXd::Constant(1, 2));
  EXPECT_LE(within_bounds.cost, slope.cost);
  EXPECT_LE(within_bounds.x[0], 2);
}

TEST(Explanation_behaviour, orders_effects_by_their_place_and_frees_what_is_to_be_calibrated) {
  const Experiment e = test::experiment(Motion::rail);
  SimulationChoice choice;
  choice.torsion = "constant";
  choice.parameters["rolling_friction"] = {5e-4, true};
  choice.parameters["torsion_friction"] = {5e-3, true};
  const Explanation two(e, choice, {&effect_of("viscous_rolling"), &effect_of("rolling_adhesion_offset")});
  EXPECT_EQ(two.name(), "rolling_adhesion_offset + viscous_rolling");
  ASSERT_EQ(two.parameters().size(), 4u);
  EXPECT_EQ(two.parameters()[1].name, "torsion_friction");
  EXPECT_EQ(two.parameters()[1].effect, -1);
  EXPECT_EQ(two.parameters()[1].starts, std::vector<double>{5e-3});
  EXPECT_EQ(two.parameters()[2].effect, 0);
  EXPECT_EQ(two.parameters()[3].effect, 1);
  const Mechanics m = two.mechanics({1e-3, 2e-3, 3e-3, 4});
  EXPECT_EQ(m.lateral.coefficient, 1e-3);
  EXPECT_EQ(m.lateral.torsion_coefficient, 2e-3);
  EXPECT_EQ(m.lateral.offset, 3e-3);
  // An effect that brings the torsion itself takes the simulation's away.
  EXPECT_EQ(Explanation(e, choice, {&effect_of("torsion_resistance")}).parameters()[1].effect, 0);
  choice.torsion = "none";
  EXPECT_EQ(Explanation(e, choice, {}).parameters().size(), 1u);
  EXPECT_EQ(Explanation(e, choice, {}).mechanics({1e-3}).lateral.torsion_coefficient, 0);
  choice.parameters["rolling_friction"].calibrate = false;
  EXPECT_EQ(Explanation(e, choice, {}).parameters().size(), 0u);
  EXPECT_EQ(Explanation(e, choice, {}).name(), "the simulation alone");
}

TEST(Explanation_behaviour, keeps_two_laws_of_one_place_apart) {
  EXPECT_FALSE(Explanation::compatible({&effect_of("velocity_dependence"), &effect_of("rate_and_state")}));
  EXPECT_TRUE(Explanation::compatible({&effect_of("velocity_dependence"), &effect_of("adhesion_offset")}));
  EXPECT_FALSE(Explanation::compatible({&effect_of("adhesion_hysteresis"), &effect_of("bulk_plasticity")}));
}

TEST(Explanation_analytic, guesses_a_coefficient_that_was_not_given_from_the_largest_response) {
  Experiment e = test::experiment(Motion::rolling);
  e.largest_response = 2e-6, e.largest_force = 4e-3;
  const SimulationChoice guessed = completed({}, e);
  EXPECT_DOUBLE_EQ(guessed.parameters.at("rolling_friction").value, 5e-4);
  EXPECT_TRUE(guessed.parameters.at("rolling_friction").calibrate);
  EXPECT_EQ(guessed.parameters.count("sliding_friction"), 0u);
  EXPECT_TRUE(completed({}, test::experiment(Motion::normal)).parameters.empty());
}

}  // namespace
}  // namespace asperity
