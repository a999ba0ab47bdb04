// How much of a residual is noise: from repeats, neighbours, what is given and what is left, against noise of
// known size.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "diagnosis/fit/noise.h"
#include "diagnosis/fit/outliers.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

/// A trace of runs with the same approach; `responses` by run.
Recording repeated_runs(const std::vector<std::vector<double>>& responses) {
  Recording recording;
  recording.particle = test::borosilicate(), recording.substrate = test::silicon();
  RecordingTable table;
  table.file = "t.csv";
  table.control = {"normal_displacement"};
  table.response = "normal_force";
  for (std::size_t run = 0; run < responses.size(); ++run)
    for (std::size_t i = 0; i < responses[run].size(); ++i) {
      table.columns["run"].push_back(static_cast<double>(run));
      table.columns["normal_displacement"].push_back(1e-9 * static_cast<double>(i + 1));
      table.columns["normal_force"].push_back(responses[run][i]);
    }
  recording.tables = {table};
  return recording;
}

/// Rows of rolling at growing loads.
Recording rolling_series(const std::vector<double>& responses) {
  Recording recording;
  recording.mode = Motion::rolling;
  recording.particle = test::borosilicate(), recording.substrate = test::silicon(),
  recording.indenter = test::diamond();
  RecordingTable table;
  table.file = "s.csv";
  table.kind = TableKind::series;
  table.control = {"normal_force"};
  table.response = "lateral_force";
  for (std::size_t i = 0; i < responses.size(); ++i)
    table.columns["normal_force"].push_back(1e-4 * static_cast<double>(i + 1));
  table.columns["lateral_force"] = responses;
  recording.tables = {table};
  return recording;
}

Noise noise_of(const Recording& recording, const std::vector<double>& residual) {
  return estimate_noise(recording, samples_of(recording), residual);
}

TEST(NoiseEstimate_analytic, of_repeats_is_their_scatter_about_their_mean) {
  // A response of 10 that grows, and three runs at -0.2, 0 and 0.2 of it: a sample deviation of 0.2.
  std::vector<std::vector<double>> runs(3);
  for (int run = 0; run < 3; ++run)
    for (int i = 0; i < 20; ++i) runs[static_cast<std::size_t>(run)].push_back(10 + i + 0.2 * (run - 1));
  const std::vector<double> residual(60, 7.0);
  const Noise three = noise_of(repeated_runs(runs), residual);
  EXPECT_EQ(three.from, std::vector<std::string>{"repeats"});
  EXPECT_TRUE(three.is_absolute);
  for (const double sd : three.sd) EXPECT_NEAR(sd, 0.2, 1e-12);
  runs.pop_back();
  const Noise two = noise_of(repeated_runs(runs), std::vector<double>(40, 7.0));
  EXPECT_NEAR(two.sd[0], 0.2 / std::sqrt(2.0), 1e-12);
  // Nineteen samples of two runs say too little.
  for (auto& run : runs) run.pop_back();
  EXPECT_NE(noise_of(repeated_runs(runs), std::vector<double>(38, 7.0)).from[0], "repeats");
}

/// Bodies may give way with time: two rates are no repeats.
TEST(NoiseEstimate_behaviour, runs_of_another_duration_are_no_repeats) {
  const auto at_rates = [](double slower) {
    std::vector<std::vector<double>> runs(2);
    for (std::size_t run = 0; run < 2; ++run)
      for (int i = 0; i < 20; ++i) runs[run].push_back(10 + i + 0.2 * static_cast<double>(run));
    Recording recording = repeated_runs(runs);
    for (std::size_t k = 0; k < 40; ++k)
      recording.tables[0].columns["time"].push_back(static_cast<double>(k % 20) * (k < 20 ? 1 : slower));
    return noise_of(recording, std::vector<double>(40, 7.0)).from[0];
  };
  EXPECT_EQ(at_rates(1.05), "repeats");
  EXPECT_NE(at_rates(10), "repeats");
}

TEST(NoiseEstimate_analytic,
     of_repeats_is_that_of_Gaussian_noise_and_not_moved_by_two_outliers_in_a_hundred) {
  for (const std::size_t repeats : {2, 3, 5}) {
    std::mt19937 random(static_cast<unsigned>(repeats));
    std::normal_distribution<double> normal(1, 0.5);
    std::vector<std::vector<double>> runs(repeats, std::vector<double>(20000));
    for (auto& run : runs)
      for (double& response : run) response = normal(random);
    const std::vector<double> residual(repeats * 20000, 0.0);
    EXPECT_NEAR(noise_of(repeated_runs(runs), residual).sd[0], 0.5, 0.01) << repeats;
    for (std::size_t i = 0; i < 200; ++i) runs[i % repeats][100 * i + 17] = i % 2 ? 100 : -100;
    EXPECT_NEAR(noise_of(repeated_runs(runs), residual).sd[0], 0.5, 0.015) << repeats;
  }
}

TEST(NoiseEstimate_analytic, of_repeats_takes_no_empty_cell_for_a_zero) {
  std::vector<std::vector<double>> runs(3);
  for (int run = 0; run < 3; ++run)
    for (int i = 0; i < 40; ++i) runs[static_cast<std::size_t>(run)].push_back(10 + i + 0.2 * (run - 1));
  for (int i = 0; i < 40; i += 4) runs[1][static_cast<std::size_t>(i)] = NAN;  // -0.2 and 0.2 are left
  const double ten = 2 * 0.2 * 0.2, thirty = 2 * 0.2 * 0.2;                    // sums of squares of a sample
  EXPECT_NEAR(noise_of(repeated_runs(runs), std::vector<double>(120, 7.0)).sd[0],
              std::sqrt((10 * ten + 30 * thirty) / (10 * 1 + 30 * 2)), 1e-12);
}

TEST(NoiseEstimate_behaviour, takes_only_runs_of_the_same_control_and_speed_for_repeats) {
  const std::vector<std::vector<double>> runs{std::vector<double>(40, 1.0), std::vector<double>(40, 1.5)};
  EXPECT_EQ(noise_of(repeated_runs(runs), std::vector<double>(80, 0.0)).from[0], "repeats");
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<double> residual(80);
  for (double& r : residual) r = normal(random);
  Recording recording = repeated_runs(runs);
  auto& path = recording.tables[0].columns["normal_displacement"];
  for (std::size_t i = 40; i < 80; ++i) path[i] += 0.003 * 40e-9;  // of the range of 39 nm
  EXPECT_EQ(noise_of(recording, residual).from[0], "high frequencies");
  recording = repeated_runs(runs);
  for (int i = 0; i < 80; ++i) recording.tables[0].columns["speed"].push_back(i < 40 ? 1e-6 : 1.2e-6);
  EXPECT_EQ(noise_of(recording, residual).from[0], "high frequencies");
  recording = repeated_runs({std::vector<double>(40, 1.0), std::vector<double>(41, 1.5)});
  residual.push_back(0);
  EXPECT_EQ(noise_of(recording, residual).from[0], "high frequencies");
}

/// Loops that are alike in their path and not in their load are no repeats.
TEST(NoiseEstimate_behaviour, compares_every_channel_that_drives) {
  Recording recording = repeated_runs({std::vector<double>(40, 1.0), std::vector<double>(40, 1.5)});
  recording.mode = Motion::sliding;
  RecordingTable& table = recording.tables[0];
  table.columns["lateral_displacement"] = table.columns["normal_displacement"];
  table.columns["lateral_force"] = table.columns["normal_force"];
  table.columns["normal_force"].assign(80, 1e-3);
  table.control = {"lateral_displacement", "normal_force"}, table.response = "lateral_force";
  const std::vector<double> residual(80, 0.0);
  EXPECT_EQ(noise_of(recording, residual).from[0], "repeats");
  EXPECT_NEAR(noise_of(recording, residual).sd[0], 0.5 / std::sqrt(2.0), 1e-12);
  Recording other = recording;
  for (std::size_t i = 40; i < 80; ++i) other.tables[0].columns["normal_force"][i] = 1.01e-3;
  EXPECT_NE(noise_of(other, residual).from[0], "repeats");
  other = recording;
  for (std::size_t i = 40; i < 80; ++i) other.tables[0].columns["lateral_displacement"][i] *= 1.01;
  EXPECT_NE(noise_of(other, residual).from[0], "repeats");
}

TEST(NoiseEstimate_analytic, of_one_run_is_its_scatter_over_neighbours) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal(0, 3);
  std::vector<double> residual(4000);
  for (std::size_t i = 0; i < residual.size(); ++i)
    residual[i] = normal(random) + 40 * std::sin(static_cast<double>(i) / 100);
  const Noise noise = noise_of(repeated_runs({std::vector<double>(4000, 1.0)}), residual);
  EXPECT_EQ(noise.from[0], "high frequencies");
  EXPECT_NEAR(noise.sd[0], 3, 0.15);
  EXPECT_EQ(noise.shared[0].memory, 0);
}

TEST(NoiseEstimate_analytic, of_each_table_is_its_own) {
  Recording recording = repeated_runs({std::vector<double>(2000, 1.0)});
  recording.tables.push_back(recording.tables[0]);
  recording.tables.push_back(rolling_series(std::vector<double>(2000, 1.0)).tables[0]);
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  std::vector<double> residual(6000);
  for (std::size_t i = 0; i < 6000; ++i) residual[i] = normal(random) * (i < 2000 ? 1 : i < 4000 ? 5 : 25);
  const Noise noise = noise_of(recording, residual);
  EXPECT_EQ(noise.from,
            (std::vector<std::string>{"high frequencies", "high frequencies", "neighbouring rows"}));
  EXPECT_NEAR(noise.sd[100], 1, 0.07);
  EXPECT_NEAR(noise.sd[2100], 5, 0.35);
  EXPECT_NEAR(noise.sd[4100], 25, 2);
}

TEST(NoiseEstimate_analytic, that_is_given_is_taken_as_it_is) {
  Recording recording = repeated_runs({std::vector<double>(40, 1.0)});
  recording.noise["normal_force"] = 0.25;
  const std::vector<double> residual(40, 3.0);
  const Noise given = noise_of(recording, residual);
  EXPECT_EQ(given.from[0], "given");
  EXPECT_EQ(given.sd, std::vector<double>(40, 0.25));
  // Given by row it goes before; a row that does not say has the median of those that do.
  auto& by_row = recording.tables[0].columns["normal_force_sd"];
  for (int i = 0; i < 40; ++i) by_row.push_back(i == 5 ? NAN : i < 10 ? 0.1 : i < 30 ? 0.2 : 0.4);
  const Noise rows = noise_of(recording, residual);
  EXPECT_EQ(rows.from[0], "given by row");
  EXPECT_EQ(rows.sd[4], 0.1);
  EXPECT_EQ(rows.sd[5], 0.2);
  EXPECT_EQ(rows.sd[39], 0.4);
  EXPECT_TRUE(rows.is_absolute);
}

TEST(NoiseEstimate_analytic, of_a_series_is_the_scatter_about_the_line_between_neighbours) {
  // Residuals of d and -d in turn: second differences of 4 d, and 6 times the variance is their square's
  // mean.
  std::vector<double> residual;
  for (int i = 0; i < 10; ++i) residual.push_back(3 + 0.5 * i + (i % 2 ? 0.1 : -0.1));
  const Noise alternating = noise_of(rolling_series(std::vector<double>(10, 1.0)), residual);
  EXPECT_EQ(alternating.from[0], "neighbouring rows");
  constexpr double median_of_square = 0.454936;  // of a unit normal variable
  EXPECT_NEAR(alternating.sd[0], std::sqrt(0.16 / 6 / median_of_square), 1e-12);
  EXPECT_EQ(alternating.shared[0].memory, 0);
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0, 2);
  std::vector<double> drawn(3000);
  for (double& r : drawn) r = normal(random);
  EXPECT_NEAR(noise_of(rolling_series(std::vector<double>(3000, 1.0)), drawn).sd[0], 2, 0.12);
}

TEST(NoiseEstimate_analytic, of_few_rows_is_all_that_is_left_and_says_so) {
  const Noise two = noise_of(rolling_series({1, 1}), {3, 4});
  EXPECT_EQ(two.from[0], "residuals");
  EXPECT_FALSE(two.is_absolute);
  EXPECT_NEAR(two.sd[0], 5, 1e-12);  // one degree of freedom
  EXPECT_NEAR(noise_of(rolling_series({1, 1, 1}), {3, 4, 5}).sd[0], 5, 1e-12);
  EXPECT_NEAR(noise_of(rolling_series({1}), {3}).sd[0], 3, 1e-12);
  // Rows without a response do not count.
  EXPECT_NEAR(noise_of(rolling_series({1, NAN, 1}), {3, 100, 4}).sd[0], 5, 1e-12);
}

TEST(NoiseEstimate_analytic, finds_no_scatter_in_a_line_and_none_in_too_few_samples) {
  const ShortScaleNoise line = short_scale_noise({{1, 2, 3, 4, 5, 6, 7, 8}});
  EXPECT_EQ(line.sd, 0);
  EXPECT_EQ(line.correlation, 0);
  EXPECT_EQ(line.count, 6u);
  EXPECT_EQ(short_scale_noise({{1, 2}, {5}, {}}).count, 0u);
  // Stretches do not look into each other.
  EXPECT_EQ(short_scale_noise({{1, 1, 1, 1}, {9, 9, 9, 9}}).sd, 0);
}

Samples flat_run(std::size_t count) {
  Samples samples = test::approach_and_back(0, 1e-8, static_cast<int>(count / 2));
  samples.table_names = {"t.csv"};
  return samples;
}

Noise unit_noise(std::size_t count) {
  Noise noise;
  noise.sd.assign(count, 1.0);
  noise.shared = {{}};
  noise.from = {"given"};
  return noise;
}

TEST(Outliers_behaviour, are_samples_far_off_all_of_their_neighbours) {
  Samples samples = flat_run(100);
  std::vector<double> residual(100, 0.0);
  residual[30] = 6.5, residual[60] = -6.5, residual[80] = 5.5;
  EXPECT_EQ(mark_outliers(samples, residual, unit_noise(100)), 2u);
  EXPECT_FALSE(samples.list[30].counts);
  EXPECT_FALSE(samples.list[60].counts);
  EXPECT_TRUE(samples.list[80].counts);
  // Two side by side, of either sign, but at an end, where something begins; three are structure.
  for (const double second : {8.0, -8.0})
    for (const std::size_t at : {std::size_t{0}, std::size_t{40}, std::size_t{98}}) {
      samples = flat_run(100);
      residual.assign(100, 0.0);
      residual[at] = 6.7, residual[at + 1] = second;
      EXPECT_EQ(mark_outliers(samples, residual, unit_noise(100)), at == 40 ? 2u : 0u) << at;
      EXPECT_EQ(samples.list[at].counts, at != 40);
      EXPECT_EQ(samples.list[at + 1].counts, at != 40);
    }
  samples = flat_run(100);
  residual.assign(100, 0.0);
  residual[60] = residual[61] = residual[62] = 20;
  EXPECT_EQ(mark_outliers(samples, residual, unit_noise(100)), 0u);
  residual.assign(100, 0.0);
  // The edge of a step is none.
  samples = flat_run(100);
  for (std::size_t i = 50; i < 100; ++i) residual[i] = 20;
  residual[30] = 0;
  EXPECT_EQ(mark_outliers(samples, residual, unit_noise(100)), 0u);
}

TEST(Outliers_behaviour, are_none_in_a_series_nor_where_every_tenth_sample_is_one) {
  std::vector<double> residual(100, 0.0);
  for (std::size_t i = 0; i < 100; i += 10) residual[i] = 50;
  Samples samples = flat_run(100);
  EXPECT_EQ(mark_outliers(samples, residual, unit_noise(100)), 0u);
  for (const auto& s : samples.list) EXPECT_TRUE(s.counts);
  residual.assign(100, 0.0);
  residual[30] = 50;
  samples.runs[0].independent_rows = true;
  EXPECT_EQ(mark_outliers(samples, residual, unit_noise(100)), 0u);
  samples.runs[0].independent_rows = false;
  EXPECT_EQ(mark_outliers(samples, residual, unit_noise(100)), 1u);
}

/// Sliding that begins with half of its force and comes to 1 after six samples, forward and back.
Samples begun_under_force(double first) {
  Samples samples = test::lateral_path(1e-3, {0, 1e-7, 0}, 20);
  for (std::size_t i = 0; i < 40; ++i) {
    const double force = std::min(1.0, first + 0.1 * static_cast<double>(i));
    samples.list[i].response = i < 20 ? force : -1;
  }
  return samples;
}

TEST(Beginnings_behaviour, are_left_out_up_to_nine_tenths_of_the_sliding_force) {
  Samples samples = begun_under_force(0.45);
  Noise noise = unit_noise(40);
  noise.sd.assign(40, 0.1);
  mark_beginnings(samples, noise);
  EXPECT_EQ(samples.runs[0].first_response, 0.45);
  for (std::size_t i = 0; i < 40; ++i)
    EXPECT_EQ(samples.list[i].counts, i >= 5) << i;  // 0.95 is the first above 0.9
}

TEST(Beginnings_behaviour, without_force_or_reversal_count) {
  Samples samples = begun_under_force(0.25);
  Noise noise = unit_noise(40);
  noise.sd.assign(40, 0.1);
  mark_beginnings(samples, noise);
  EXPECT_EQ(samples.runs[0].first_response, 0);  // two and a half standard deviations
  Samples straight = begun_under_force(0.45);
  straight.runs[0].end = 20;
  mark_beginnings(straight, noise);
  EXPECT_EQ(straight.runs[0].first_response, 0.45);
  for (const auto& s : straight.list) EXPECT_TRUE(s.counts);
}

/// Mirrored, a run that begins backwards under a force of its own direction is treated alike.
TEST(Beginnings_behaviour, do_not_depend_on_the_direction) {
  Samples samples = begun_under_force(0.45);
  for (auto& s : samples.list) s.response = -s.response, s.direction = -s.direction;
  Noise noise = unit_noise(40);
  noise.sd.assign(40, 0.1);
  mark_beginnings(samples, noise);
  EXPECT_EQ(samples.runs[0].first_response, -0.45);
  for (std::size_t i = 0; i < 40; ++i) EXPECT_EQ(samples.list[i].counts, i >= 5) << i;
}

std::vector<double> autoregression(std::size_t count, double rho, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> values{normal(random)};
  while (values.size() < count)
    values.push_back(rho * values.back() + std::sqrt(1 - rho * rho) * normal(random));
  return values;
}

/// 1 + 2 sum over k to 30 of (1 - k/31) rho^k.
TEST(SharedVariance_analytic, is_that_of_an_autoregression_that_was_taken_for_white) {
  constexpr std::size_t count = 20000;
  Samples samples = flat_run(count);
  constexpr double rho = 0.5;
  double expected = 1;
  for (int k = 1; k <= 30; ++k) expected += 2 * (1 - k / 31.0) * std::pow(rho, k);
  EXPECT_NEAR(shared_variance(samples, autoregression(count, rho, 4), unit_noise(count)), expected, 0.2);
  EXPECT_NEAR(shared_variance(samples, autoregression(count, 0, 5), unit_noise(count)), 1, 0.15);
  // A share of the variance: it does not depend on the size.
  auto small = autoregression(count, rho, 4);
  for (double& r : small) r *= 0.5;
  EXPECT_NEAR(shared_variance(samples, small, unit_noise(count)), expected, 0.2);
  std::vector<double> alternating(count);
  for (std::size_t i = 0; i < count; ++i) alternating[i] = i % 2 ? 1 : -1;
  EXPECT_EQ(shared_variance(samples, alternating, unit_noise(count)), 1);
  samples.runs[0].independent_rows = true;
  EXPECT_EQ(shared_variance(samples, autoregression(count, rho, 4), unit_noise(count)), 1);
}

TEST(SharedVariance_analytic, of_no_more_samples_than_it_looks_back_is_one) {
  EXPECT_EQ(shared_variance(flat_run(30), std::vector<double>(30, 1.0), unit_noise(30)), 1);
  EXPECT_GT(shared_variance(flat_run(32), std::vector<double>(32, 1.0), unit_noise(32)), 10);
}

TEST(RefinedNoise_analytic, that_was_estimated_takes_the_deviation_of_the_residuals_and_that_given_does_not) {
  constexpr std::size_t count = 20000;
  const Samples samples = flat_run(count);
  auto residual = autoregression(count, 0.5, 6);
  for (double& r : residual) r *= 1.1;
  Noise noise = unit_noise(count);
  noise.from = {"high frequencies"};
  EXPECT_TRUE(refine_noise(samples, residual, noise));
  EXPECT_NEAR(noise.sd[7], 1.1, 0.03);
  EXPECT_NEAR(noise.shared[0].neighbours(), 0.5, 0.05);
  noise = unit_noise(count);
  EXPECT_TRUE(refine_noise(samples, residual, noise));
  EXPECT_EQ(noise.sd[7], 1);
  EXPECT_NEAR(noise.shared[0].neighbours(), 0.5, 0.05);
}

TEST(RefinedNoise_behaviour, is_left_as_it_was_where_residuals_cannot_tell) {
  const Samples samples = flat_run(200);
  const auto residual = autoregression(200, 0, 7);
  const auto changes = [&](double factor, const std::string& from, const Samples& of) {
    Noise noise = unit_noise(200);
    noise.from = {from};
    auto scaled = residual;
    for (double& r : scaled) r *= factor;
    return refine_noise(of, scaled, noise);
  };
  EXPECT_TRUE(changes(1, "high frequencies", samples));
  EXPECT_FALSE(changes(1.5, "high frequencies", samples));
  EXPECT_FALSE(changes(0.6, "given", samples));
  EXPECT_FALSE(changes(1, "residuals", samples));
  EXPECT_FALSE(changes(1, "given by row", samples));
  EXPECT_FALSE(changes(1, "high frequencies", flat_run(98)));
  Samples rows = samples;
  rows.runs[0].independent_rows = true;
  EXPECT_FALSE(changes(1, "high frequencies", rows));
}

/// A fit leaves no less than the noise: an estimate above what it leaves took the signal for noise.
TEST(RefinedNoise_analytic, comes_down_to_what_a_fit_leaves) {
  const Samples samples = flat_run(400);
  auto residual = autoregression(400, 0, 7);
  constexpr double factor = 0.3;
  for (double& r : residual) r *= factor;
  Noise noise = unit_noise(400);
  noise.from = {"high frequencies"};
  ASSERT_TRUE(refine_noise(samples, residual, noise));
  EXPECT_NEAR(noise.sd[0] / factor, 1, 0.1);
}

TEST(SharedNoise_analytic, filter_of_an_autoregression_forgets_over_a_gap_as_its_memory_says) {
  // Share one: after k samples, x is known to rho^k of its last value, with a variance of 1 - rho^(2 k).
  Samples samples = flat_run(6);
  samples.list[1].counts = samples.list[2].counts = false;
  const NoiseFilter filter(samples, std::vector<double>(6, 2.0), {SharedNoise{1, 0.5}});
  const auto white = filter.whitened({4, 100, 100, 6, 8, 2});
  ASSERT_EQ(white.size(), 4u);
  EXPECT_NEAR(white[0], 2, 1e-12);
  EXPECT_NEAR(white[1], (3 - 0.125 * 2) / std::sqrt(1 - std::pow(0.125, 2)), 1e-12);
  EXPECT_NEAR(white[2], (4 - 0.5 * 3) / std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(white[3], (1 - 0.5 * 4) / std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(filter.log_determinant(), std::log(1 - std::pow(0.125, 2)) + 2 * std::log(0.75), 1e-12);
  EXPECT_EQ(filter.place(4), 2);
  samples.runs[0].independent_rows = true;
  EXPECT_EQ(
      NoiseFilter(samples, std::vector<double>(6, 2.0), {SharedNoise{1, 0.5}}).whitened({4, 0, 0, 6, 8, 2}),
      (std::vector<double>{2, 3, 4, 1}));
}

}  // namespace
}  // namespace asperity
