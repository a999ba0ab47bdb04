// Fits beside a case with a generated surface: what all samples share because the recorded surface is
// another realisation is weighed (generalised least squares), in values, intervals and data kept out.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "diagnosis/choose/evidence.h"
#include "diagnosis/choose/held_out.h"
#include "diagnosis/fit/likely_surface.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::nm;

/// Finite elements that agree with Hertz, on one of many surfaces: standard deviations of the approach.
class OneOfMany : public BranchCorrection {
 public:
  double error() const override { return 0; }
  const std::vector<std::function<double(double)>>& surface_errors() const override { return errors_; }

 private:
  std::vector<std::function<double(double)>> errors_{[](double f) { return 1.5 * nm * std::sqrt(f / 3e-3); },
                                                     [](double f) { return 0.4 * nm * std::sin(f / 5e-4); },
                                                     [](double) { return 0.8 * nm; }};  // of the zero
};

constexpr double noise = 0.1 * nm;
constexpr int rows = 60;

/// Displacement under a force that rises, on a surface that these factors make another.
FitProblem pressed_on(const std::vector<double>& factors, double compliance, unsigned seed,
                      double memory = 0) {
  FitProblem problem;
  problem.experiment = test::experiment(Motion::normal);
  problem.choice = completed({}, problem.experiment);
  auto correction = std::make_shared<OneOfMany>();
  problem.correction = correction;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  for (int i = 0; i < rows; ++i) {
    Sample s;
    s.normal_force = 3e-3 * (i + 1) / rows;
    s.time = i;
    s.radius = problem.experiment.radius;
    s.response = problem.experiment.hertz().approach(s.normal_force) + compliance * s.normal_force +
                 noise * normal(random);
    for (std::size_t k = 0; k < factors.size(); ++k)
      s.response += factors[k] * correction->surface_errors()[k](s.normal_force);
    problem.samples.list.push_back(s);
  }
  test::close_run(problem.samples, false);
  problem.samples.runs[0].response_is_displacement = true;
  problem.samples.table_names = {"pressed.csv"};
  problem.noise.sd.assign(rows, noise);
  problem.noise.shared = {{memory > 0 ? 0.5 : 0, memory}};
  problem.thin = problem.samples;
  problem.baseline_residual =
      FitProblem::residual(problem.samples, fit_explanation(problem, {}).simulate(problem.samples));
  return problem;
}

TEST(LikelySurface_analytic, weighted_residuals_are_independent_and_of_unit_variance) {
  for (const double memory : {0.0, 0.7}) {
    const FitProblem problem = pressed_on({}, 0, 1, memory);
    const LikelySurface surface(problem, fit_explanation(problem, {}), problem.samples);
    const NoiseFilter filter(problem.samples, problem.noise.sd, problem.noise.shared);
    // Covariance of whitened residuals: 1 + sum_k s_k s_k^T, s_k whitened; the zero is a parameter.
    MatrixXd covariance = MatrixXd::Identity(rows, rows);
    const auto correction = std::make_shared<OneOfMany>();
    for (std::size_t k = 0; k < 2; ++k) {
      std::vector<double> s;
      for (const Sample& sample : problem.samples.list)
        s.push_back(correction->surface_errors()[k](sample.normal_force));
      const auto white = filter.whitened(s);
      const VectorXd column = Eigen::Map<const VectorXd>(white.data(), rows);
      covariance += column * column.transpose();
    }
    MatrixXd weighting(rows, rows);
    for (Index i = 0; i < rows; ++i) weighting.col(i) = surface.independent(VectorXd::Unit(rows, i));
    const MatrixXd product = weighting * covariance * weighting.transpose();
    EXPECT_LT((product - MatrixXd::Identity(rows, rows)).cwiseAbs().maxCoeff(), 1e-6);
  }
}

TEST(LikelySurface_analytic, factors_of_a_surface_are_found) {
  const std::vector<double> factors{1.2, -0.7, 0.9};
  const FitProblem problem = pressed_on(factors, 0, 3);
  const LikelySurface surface(problem, fit_explanation(problem, {}), problem.samples);
  ASSERT_EQ(surface.factors().size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(surface.factors()[k], factors[k], 0.3);
  // What is simulated is linear to the case's own surface again.
  const auto simulated = surface.simulated(*fit_explanation(problem, {}).explanation, {});
  for (std::size_t i = 0; i < simulated.size(); ++i)
    EXPECT_NEAR(simulated[i], problem.experiment.hertz().approach(problem.samples.list[i].normal_force),
                1e-6 * nm);
}

TEST(LikelySurface_analytic, factors_are_no_longer_than_in_999_of_1000_surfaces) {
  // Quantiles of chi-square: 3.2905^2 for one, 5.4^2 = 29.588 for ten degrees of freedom.
  EXPECT_NEAR(of_likely_length(VectorXd::Constant(1, -8.0))[0], -3.2905, 1e-4);
  EXPECT_NEAR(of_likely_length(VectorXd::Constant(10, 4.0)).squaredNorm(), 29.588, 1e-3);
  EXPECT_EQ(of_likely_length(VectorXd::Constant(10, 1.5))[3], 1.5);
  EXPECT_EQ(of_likely_length(VectorXd()).size(), 0);
}

TEST(LikelySurface_analytic, the_interval_of_a_compliance_is_that_of_generalised_least_squares) {
  // Factors and noise drawn from what the case states: intervals hold the truth in 95 of 100.
  const double compliance = 8 * nm / 3e-3;
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  int held = 0;
  double squares = 0, stated = 0;
  constexpr int draws = 200;
  const std::vector<const Effect*> spring{&effect_of("instrument_compliance")};
  for (int draw = 0; draw < draws; ++draw) {
    const std::vector<double> factors{normal(random), normal(random), normal(random)};
    const FitProblem problem = pressed_on(factors, compliance, 100 + static_cast<unsigned>(draw));
    const ModelFit fit = finished(problem, fit_explanation(problem, spring));
    const DiagnosedParameter found = fit.parameter(0, 1);
    held += found.low <= compliance && compliance <= found.high;
    squares += std::pow(found.value - compliance, 2) / draws;
    stated += std::pow((found.high - found.low) / (2 * 1.96), 2) / draws;
  }
  EXPECT_GE(held, 0.91 * draws);
  EXPECT_LE(held, 0.99 * draws);
  EXPECT_NEAR(std::sqrt(squares / stated), 1, 0.15);
}

/// A set that came in from a larger one, with values that another surface would need.
TEST(LikelySurface_behaviour, sets_are_compared_where_their_fits_have_settled) {
  const double compliance = 8 * nm / 3e-3;
  const FitProblem problem = pressed_on({1.2, -0.7, 0.9}, compliance, 3);
  SearchResult result;
  result.alone.fit = fit_explanation(problem, {});
  result.admissible = 10;
  Candidate settled;
  settled.fit = finished(problem, fit_explanation(problem, {&effect_of("instrument_compliance")}));
  cost_explanation(settled, problem, LawErrors(problem.samples), result.alone.fit);
  Candidate begun = settled;
  begun.fit.values[0] *= 1.5;
  begun.fit.surface = {-1, -2, 1};
  result.candidates = {begun};
  rescore(result, problem);
  EXPECT_NEAR(result.candidates[0].least_cost(), settled.least_cost(), 1);
  EXPECT_NEAR(result.candidates[0].fit.values[0] / settled.fit.values[0], 1, 0.05);
}

TEST(LikelySurface_behaviour, data_kept_out_are_predicted_on_the_surface_that_the_rest_shows) {
  const FitProblem problem = pressed_on({1.5, -1.0, 0.8}, 0, 5);
  const ModelFit alone = fit_explanation(problem, {});
  const HeldOut kept_out = predict_held_out(problem, alone, blocks_of(problem.samples));
  double raw = 0;
  for (const double r : problem.baseline_residual) raw += r * r / (noise * noise * rows);
  EXPECT_GT(raw, 30);
  EXPECT_LT(kept_out.chi2_reduced, 2);
  // Not the noise of the samples themselves: half of them as far off as another surface never is.
  FitProblem broken = problem;
  for (int i = 0; i < rows; i += 2) broken.samples.list[static_cast<std::size_t>(i)].response += 3 * nm;
  broken.thin = broken.samples;
  EXPECT_GT(predict_held_out(broken, alone, blocks_of(broken.samples)).chi2_reduced, 100);
}

}  // namespace
}  // namespace asperity
