// Prediction of samples that a fit has not seen, where the fit is a mean and can be done by hand.
#include "diagnosis/choose/held_out.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <vector>

#include "tests/diagnosis/support/assembled_mechanics.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

constexpr double noise_of_row = 1e-7;
constexpr int row_count = 20;

/// Independent rows of rolling under one load: a known friction and the zero of the sensor, which alone is
/// fitted. Within Huber's bend, so that the fit is the mean of what is recorded less the friction.
FitProblem rows_with(const std::vector<double>& deviations) {
  FitProblem problem;
  problem.experiment = test::experiment(Motion::rolling);
  problem.experiment.largest_response = 2e-6;
  constexpr double load = 1e-3, friction = 6e-4;
  problem.choice.parameters["rolling_friction"] = {friction, false};
  for (const double deviation : deviations) {
    problem.samples.list.push_back(test::row(problem.experiment, load).list[0]);
    problem.samples.list.back().response = friction * load + deviation;
  }
  test::close_run(problem.samples, true);
  problem.noise.sd.assign(deviations.size(), noise_of_row);
  problem.noise.shared.assign(1, {});
  problem.thin = problem.samples;
  return problem;
}

/// Two standard deviations up in every fifth row, which is one of the five blocks, and a little of everything
/// elsewhere.
std::vector<double> one_block_apart() {
  std::vector<double> deviations;
  for (int i = 0; i < row_count; ++i)
    deviations.push_back(noise_of_row * (i % 5 == 2 ? 2 : 0.3 * std::sin(3.0 * i)));
  return deviations;
}

double mean_of_others(const std::vector<double>& deviations, int block) {
  double sum = 0;
  int count = 0;
  for (int i = 0; i < row_count; ++i)
    if (i % 5 != block) sum += deviations[static_cast<std::size_t>(i)], ++count;
  return sum / count;
}

TEST(HeldOut_analytic, each_block_is_predicted_by_the_mean_of_the_others) {
  const auto deviations = one_block_apart();
  const FitProblem problem = rows_with(deviations);
  const Blocks blocks = blocks_of(problem.samples);
  ASSERT_EQ(blocks.count, 5);
  EXPECT_EQ(blocks.name, "rows");
  double expected = 0;
  for (int i = 0; i < row_count; ++i)
    expected +=
        std::pow((deviations[static_cast<std::size_t>(i)] - mean_of_others(deviations, i % 5)) / noise_of_row,
                 2) /
        row_count;
  const ModelFit fit = fit_explanation(problem, {&effect_of("lateral_zero_offset")});
  const HeldOut held_out = predict_held_out(problem, fit, blocks);
  EXPECT_NEAR(held_out.chi2_reduced, expected, 1e-3 * expected);
  EXPECT_NEAR(held_out.cost, expected, 1e-3 * expected) << "no residual lies beyond Huber's bend";
  EXPECT_GT(held_out.chi2_reduced, 1.3 * fit.cost / row_count)
      << "what was not seen is predicted worse than what was";
}

TEST(HeldOut_analytic, what_is_recorded_in_a_block_changes_its_own_prediction_by_nothing) {
  // Were a block part of the fit that predicts it, its residual would follow the deviation by less than one
  // for one.
  const auto held_out_cost = [](double deviation) {
    auto deviations = one_block_apart();
    for (int i = 0; i < row_count; ++i)
      deviations[static_cast<std::size_t>(i)] = i % 5 == 2 ? deviation * noise_of_row : 0;
    const FitProblem problem = rows_with(deviations);
    const ModelFit fit = fit_explanation(problem, {&effect_of("lateral_zero_offset")});
    return predict_held_out(problem, fit, blocks_of(problem.samples)).chi2_reduced;
  };
  // The block itself is off by d; each of the other four is predicted by three blocks of zero and one of d.
  for (const double d : {1.0, 2.0})
    EXPECT_NEAR(held_out_cost(d), (d * d + 4 * d * d / 16) / 5, 1e-3 * d * d) << d;
}

TEST(HeldOut_analytic, an_effect_that_one_block_alone_shows_is_not_consistent) {
  const auto is_consistent = [](const std::function<double(int)>& deviation_of_block, double off_by = 1) {
    std::vector<double> deviations;
    for (int i = 0; i < 200; ++i) deviations.push_back(deviation_of_block(i % 5) * noise_of_row);
    const FitProblem problem = rows_with(deviations);
    const ModelFit fit = finished(problem, fit_explanation(problem, {&effect_of("lateral_zero_offset")}));
    return predict_held_out(problem, fit, blocks_of(problem.samples), off_by).consistent;
  };
  const auto in_one_block = [](int block) { return block == 2 ? 10 : 0; };
  EXPECT_FALSE(is_consistent(in_one_block));
  // Without the block the offset is none: at most 2 deviations of a row less, of which it is known to a
  // fourteenth, 28 of its own. A law that is off by a hundred times the noise may differ by 600.
  EXPECT_TRUE(is_consistent(in_one_block, 100));
  EXPECT_TRUE(is_consistent([](int) { return 10; }));
}

TEST(HeldOut_analytic, a_sample_that_snaps_late_is_predicted_as_fits_count_it) {
  FitProblem problem;
  problem.experiment = test::experiment(Motion::normal);
  problem.samples = test::approach_and_back(-20 * test::nm, 60 * test::nm, 60);
  problem.samples.response_channels = {"normal_force"};
  const Effect& adhesion = effect_of("adhesion");
  const std::vector<double> values{2e-4, 0.6};  // pull-off force [N], transition
  Mechanics truth = baseline_mechanics(problem.experiment, problem.choice);
  adhesion.assemble(truth, values.data());
  auto response = simulate(truth, problem.samples);
  // The contact is there for one more sample than it should be.
  const auto snap =
      static_cast<std::size_t>(std::find(response.begin() + 60, response.end(), 0.0) - response.begin());
  ASSERT_LT(snap, response.size());
  ASSERT_LT(response[snap - 1], -1e-4);
  response[snap] = response[snap - 1];
  const double noise = 1e-6;
  for (std::size_t i = 0; i < response.size(); ++i) problem.samples.list[i].response = response[i];
  problem.noise.sd.assign(response.size(), noise);
  problem.noise.shared.assign(1, {});
  problem.thin = problem.samples;
  ModelFit fit = fit_explanation(problem, {});
  const Blocks blocks = blocks_of(problem.samples);
  const HeldOut without_attraction = predict_held_out(problem, fit, blocks);
  fit.explanation = std::make_shared<Explanation>(problem.experiment, problem.choice,
                                                  std::vector<const Effect*>{&adhesion}, nullptr);
  fit.values = values;
  EXPECT_LT(predict_held_out(problem, fit, blocks).chi2_reduced, 0.1);
  EXPECT_GT(without_attraction.chi2_reduced, 100);
}

/// The block with the snap alone tells how far adhesion reaches: without it another reach fits as well, which
/// is another place between the law's limits and no other contact.
TEST(HeldOut_behaviour, a_shape_between_limits_may_move_by_more_than_its_value) {
  FitProblem problem;
  problem.experiment = test::experiment(Motion::normal);
  problem.choice = completed({}, problem.experiment);
  problem.samples = test::approach_and_back(-6 * test::nm, 40 * test::nm, 60);
  const std::vector<double> truth{20e-6, 0.4};
  const auto force = simulate(test::with(problem.experiment, {{"adhesion", truth}}), problem.samples);
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 2e-6);
  for (std::size_t i = 0; i < force.size(); ++i) problem.samples.list[i].response = force[i] + noise(random);
  problem.noise.sd.assign(force.size(), noise.stddev());
  problem.noise.shared.assign(1, {});
  problem.thin = problem.samples;
  const ModelFit fit = finished(problem, fit_explanation(problem, {&effect_of("adhesion")}));
  const Blocks blocks = blocks_of(problem.samples);
  double moved = 0;
  for (int block = 0; block < blocks.count; ++block) {
    Samples rest = problem.thin;
    for (Sample& s : rest.list)
      if (blocks.of_sample[s.index] == block) s.counts = false;
    moved = std::max(moved, std::abs(refitted(problem, fit, rest, false, 4).values[1] - fit.values[1]));
  }
  EXPECT_GT(moved, 0.6 * fit.values[1]);
  EXPECT_TRUE(predict_held_out(problem, fit, blocks).consistent);
}

}  // namespace
}  // namespace asperity
