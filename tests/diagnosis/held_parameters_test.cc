// Parameters that a law can do without: held where the data do not earn them, free where they do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "diagnosis/choose/evidence.h"
#include "diagnosis/describe.h"
#include "diagnosis/fit/bounded_least_squares.h"
#include "tests/diagnosis/support/assembled_mechanics.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

using Eigen::VectorXd;
using test::nm;
using test::uN;

TEST(BoundedFit_analytic, a_coordinate_with_one_value_stays_there_and_is_known) {
  // y = 2 + 3 t with the slope held at 1: the constant takes the mean of the rest, with the mean's variance.
  const auto residuals = [](const VectorXd& p) {
    VectorXd r(10);
    for (int t = 0; t < 10; ++t) r[t] = (p[0] + p[1] * t - (2 + 3 * t)) / 100;
    return r;
  };
  BoundedFitOptions options;
  options.covariance = true;
  const BoundedFit fit =
      fit_within_bounds(residuals, VectorXd::Zero(2), VectorXd{{-1e3, 1}}, VectorXd{{1e3, 1}}, options);
  EXPECT_EQ(fit.x[1], 1);
  EXPECT_NEAR(fit.x[0], 2 + 2 * 4.5, 1e-2);
  EXPECT_EQ(fit.covariance(1, 1), 0);
  EXPECT_EQ(fit.covariance(0, 1), 0);
  EXPECT_NEAR(fit.covariance(0, 0), 1e4 / 10, 1);
  const BoundedFit searched = search_at_random(residuals, fit, VectorXd{{-1e3, 1}}, VectorXd{{1e3, 1}});
  EXPECT_EQ(searched.x[1], 1);
}

/// A layer of asperities, its displacement counted from a force `zero` [N].
FitProblem layer_seen_from(double zero) {
  FitProblem problem;
  problem.experiment = test::experiment(Motion::normal);
  problem.choice = completed({}, problem.experiment);
  problem.samples = test::approach_and_back(0.5 * nm, 60 * nm, 120);
  const auto force = simulate(test::with(problem.experiment, {{"roughness_compliance", {2 * nm, 0.1, zero}}}),
                              problem.samples);
  const double noise = 2 * uN;
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < force.size(); ++i)
    problem.samples.list[i].response = force[i] + noise * normal(random);
  problem.noise.sd.assign(force.size(), noise);
  problem.noise.shared.assign(1, {});
  problem.thin = problem.samples;
  problem.baseline_residual =
      FitProblem::residual(problem.samples, fit_explanation(problem, {}).simulate(problem.samples));
  return problem;
}

Candidate layer_found_in(const FitProblem& problem) {
  const SearchResult search =
      search_effects(problem, fit_explanation(problem, {}), [](const ModelFit&) { return true; }, {});
  for (const Candidate& candidate : search.candidates)
    if (candidate.fit.explanation->name() == "roughness_compliance") return candidate;
  return {};
}

TEST(HeldParameters_regression, are_free_where_the_data_earn_them_and_count_only_there) {
  for (const double zero : {0.0, 30 * uN}) {
    SCOPED_TRACE(zero);
    const FitProblem problem = layer_seen_from(zero);
    const Candidate layer = layer_found_in(problem);
    ASSERT_EQ(layer.fit.values.size(), 3u);
    EXPECT_EQ(layer.fit.is_held(2), zero == 0);
    EXPECT_EQ(layer.fit.free_parameters(), zero == 0 ? 2u : 3u);
    const ModelFit fit = finished(problem, layer.fit);
    EXPECT_EQ(fit.is_held(2), zero == 0) << "all later fits keep it so";
    EXPECT_NEAR(fit.values[0] / nm, 2, 0.1);
    if (zero > 0) {
      EXPECT_NEAR(fit.values[2] / zero, 1, 0.1);
    } else {
      EXPECT_EQ(fit.values[2], 0);
    }
    const auto said = described_effects(problem, fit, fit_explanation(problem, {}), 1);
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(said[0].parameters.size(), zero == 0 ? 2u : 3u);
    const double n = static_cast<double>(layer.fit.count);
    EXPECT_NEAR(layer.cost_with_parameters() - layer.cost, (zero == 0 ? 2 : 3) * std::log(n), 1e-9);
  }
}

}  // namespace
}  // namespace asperity
