// Fits, noise and the search for what is not noise.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "diagnosis/fit/model_fit.h"
#include "diagnosis/fit/prepared_fit.h"
#include "diagnosis/locate/scan.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

using Eigen::VectorXd;

std::vector<double> ar1(std::size_t n, double sd, double rho, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<double> x(n);
  double last = normal(random);
  for (auto& value : x) value = sd * (last = rho * last + std::sqrt(1 - rho * rho) * normal(random));
  return x;
}

TEST(BoundedFit_analytic, a_line_is_found_with_its_covariance) {
  // y = 2 + 3 t at t = 0..9: (J^T J)^-1 has the textbook entries.
  const auto residuals = [](const VectorXd& p) {
    VectorXd r(10);
    for (int t = 0; t < 10; ++t) r[t] = p[0] + p[1] * t - (2 + 3 * t);
    return r;
  };
  BoundedFitOptions options;
  options.covariance = true;
  const BoundedFit fit = fit_within_bounds(residuals, VectorXd::Zero(2), VectorXd::Constant(2, -100),
                                           VectorXd::Constant(2, 100), options);
  EXPECT_NEAR(fit.x[0], 2, 1e-3);
  EXPECT_NEAR(fit.x[1], 3, 1e-3);
  EXPECT_NEAR(fit.covariance(1, 1), 1 / 82.5, 1e-6);  // sum (t - 4.5)^2 = 82.5
  EXPECT_NEAR(fit.covariance(0, 0), 0.1 + 4.5 * 4.5 / 82.5, 1e-6);
}

TEST(BoundedFit_analytic, stays_at_a_bound_that_the_optimum_lies_beyond) {
  const auto residuals = [](const VectorXd& p) { return VectorXd::Constant(3, p[0] - 5).eval(); };
  const BoundedFit fit = fit_within_bounds(residuals, VectorXd::Constant(1, 0.0), VectorXd::Constant(1, -1),
                                           VectorXd::Constant(1, 2));
  EXPECT_EQ(fit.x[0], 2);
}

TEST(RandomSearch_analytic, crosses_a_flat_stretch_to_a_step_that_no_slope_tells_of) {
  const auto residuals = [](const VectorXd& p) {
    return VectorXd::Constant(3, p[0] < 0.3 ? 1.0 : 0.0).eval();
  };
  BoundedFit start;
  start.x = VectorXd::Constant(1, -0.5);
  const BoundedFit fit =
      search_at_random(residuals, start, VectorXd::Constant(1, -1), VectorXd::Constant(1, 1));
  EXPECT_GE(fit.x[0], 0.3);
  EXPECT_LE(fit.x[0], 1);
  EXPECT_EQ(fit.cost, 0);
}

TEST(BoundedFit_analytic, one_wild_residual_moves_the_mean_by_no_more_than_its_bend) {
  const auto residuals = [](const VectorXd& p) {
    VectorXd r = VectorXd::Constant(11, p[0]);
    r[10] = p[0] - 1000;
    return r;
  };
  const BoundedFit fit = fit_within_bounds(residuals, VectorXd::Constant(1, 1.0),
                                           VectorXd::Constant(1, -2000), VectorXd::Constant(1, 2000));
  EXPECT_NEAR(fit.x[0], huber_bend / 10, 0.02);
}

TEST(Noise_analytic, short_scale_noise_finds_deviation_and_correlation_under_a_smooth_signal) {
  std::mt19937 random(1);
  for (const double rho : {0.0, 0.4, 0.7}) {
    std::vector<double> r = ar1(20000, 2.0, rho, random);
    for (std::size_t i = 0; i < r.size(); ++i) r[i] += 50 * std::sin(i / 300.0);
    const ShortScaleNoise found = short_scale_noise({r});
    EXPECT_NEAR(found.sd, 2.0, 0.15) << rho;
    EXPECT_NEAR(found.correlation, rho, 0.05) << rho;
  }
}

TEST(Noise_analytic, whitening_makes_independent_samples_of_unit_variance) {
  Samples samples = test::approach_and_back(0, 1e-8, 10000);
  std::mt19937 random(2);
  Noise noise;
  noise.sd.assign(samples.list.size(), 0.5);
  noise.shared = {{1, 0.6}};
  const auto white = whitened(samples, ar1(samples.list.size(), 0.5, 0.6, random), noise);
  double square = 0, product = 0;
  for (std::size_t i = 1; i < white.size(); ++i)
    square += white[i] * white[i], product += white[i] * white[i - 1];
  EXPECT_NEAR(square / static_cast<double>(white.size()), 1, 0.03);
  EXPECT_NEAR(product / square, 0, 0.03);
}

struct ScanCase {
  Samples samples = test::approach_and_back(0, 5e-8, 600);
  Experiment experiment = test::experiment(Motion::normal);
  Noise noise;
  ScanCase() {
    samples.segment_names = {"load", "unload"};
    for (std::size_t i = 600; i < 1200; ++i) samples.list[i].segment = 1;
    samples.table_names = {"t.csv"};
    samples.response_channels = {"normal_force"};
    noise.sd.assign(1200, 1.0);
    noise.shared = {{1, 0.3}};
  }
};

TEST(Scan_analytic, calls_noise_a_mismatch_as_rarely_as_its_p_value_says) {
  const ScanCase c;
  const Scanner scanner(c.samples, c.experiment, c.noise, 1);
  std::mt19937 random(3);
  int below_tenth = 0;
  for (int i = 0; i < 300; ++i) below_tenth += scanner.scan(ar1(1200, 1.0, 0.3, random)).p_value < 0.1;
  EXPECT_NEAR(below_tenth, 30, 4 * std::sqrt(27.0) + 5);  // binomial, and the calibration's own scatter
}

TEST(Scan_analytic, finds_the_stretch_that_was_shifted) {
  const ScanCase c;
  const Scanner scanner(c.samples, c.experiment, c.noise, 1);
  std::mt19937 random(4);
  auto residual = ar1(1200, 1.0, 0.3, random);
  for (std::size_t i = 0; i < 600; ++i)
    if (c.samples.list[i].normal_displacement > 2e-8 && c.samples.list[i].normal_displacement < 3e-8)
      residual[i] += 2;
  const ScanResult found = scanner.scan(residual);
  EXPECT_LT(found.p_value, 1e-3);
  ASSERT_EQ(found.regions.size(), 1u);
  EXPECT_EQ(found.regions[0].segment, "load");
  EXPECT_NEAR(found.regions[0].from, 2e-8, 0.2e-8);
  EXPECT_NEAR(found.regions[0].to, 3e-8, 0.2e-8);
  EXPECT_GT(found.regions[0].share, 0.8);
}

/// Data of an effect's own law, with noise; the fit must find its parameters within four of the standard
/// deviations it states.
struct OwnLaw {
  std::string id;
  Motion mode;
  std::vector<double> values;
};

class OwnLaw_regression : public testing::TestWithParam<OwnLaw> {};

TEST_P(OwnLaw_regression, parameters_come_back_from_their_own_law) {
  const OwnLaw& own = GetParam();
  FitProblem problem;
  problem.experiment = test::experiment(own.mode);
  Experiment& e = problem.experiment;
  Samples& samples = problem.samples;
  if (own.mode == Motion::normal) {
    samples = test::approach_and_back(-1e-8, 5e-8, 200);
    e.hold_duration = 100;
    e.duration = 400;
    e.has_trace = e.has_time = e.has_unloading = true;
    e.largest_displacement = 5e-8;
    e.largest_force = e.hertz().force(5e-8);
    for (std::size_t i = 200; i < 300; ++i)
      samples.list[i].normal_displacement = 5e-8, samples.list[i].hold = 1,
      samples.list[i].hold_time = static_cast<double>(i - 200);
    for (std::size_t i = 300; i < 400; ++i)
      samples.list[i].hold = 1,
      samples.list[i].normal_displacement = 5e-8 - 6e-8 * static_cast<double>(i - 300) / 100;
  } else if (own.mode == Motion::sliding) {
    for (const double load : {2e-4, 1e-3}) {
      const Samples part = test::lateral_path(load, {0, 1e-7, 0, 1e-7, 0, 1e-7, 0}, 150);
      SampleRun run = part.runs[0];
      run.begin = samples.list.size();
      for (std::size_t i = 0; i < part.list.size(); ++i) {
        Sample s = part.list[i];
        s.cycle = s.cycles_passed = static_cast<double>(i / 300);
        s.part = samples.parts + static_cast<int>(i / 150);
        const double travelled = s.direction > 0 ? s.lateral_displacement : 1e-7 - s.lateral_displacement;
        s.since_reversal = travelled;
        // The second half of each stroke ten times as fast.
        s.speed = travelled > 5e-8 ? 1e-5 : 1e-6;
        s.time = (samples.list.empty() || i == 0 ? 0 : samples.list.back().time) + 6.7e-10 / s.speed;
        samples.list.push_back(s);
      }
      samples.parts += 6;
      run.end = samples.list.size();
      samples.runs.push_back(run);
    }
    samples.segment_names = {"only"};
    e.has_trace = e.has_time = e.has_both_directions = true;
    e.largest_response = 3e-4;
    e.largest_force = 1e-3;
  } else {
    for (int i = 0; i < 180; ++i) {
      Sample s = test::row(e, 1e-4 + 1e-4 * (i % 20)).list[0];
      s.rms_roughness = 1e-9 * (1 + i % 3);
      s.speed = i % 2 ? 1e-6 : 1e-5;
      s.radius = i < 90 ? 8.5e-6 : 4e-6;
      s.rail_angle = own.mode == Motion::rail ? 0.4 + 0.2 * (i % 4) : 0;
      samples.list.push_back(s);
    }
    test::close_run(samples, true);
    e.largest_response = 2e-6;
    e.largest_force = 2e-3;
  }
  for (std::size_t i = 0; i < samples.list.size(); ++i) samples.list[i].index = i;
  for (const auto& name : {"sliding_friction", "rolling_friction", "torsion_friction"})
    problem.choice.parameters[name] = {own.mode == Motion::sliding ? 0.2 : 6e-4, true};
  const Effect& effect = effect_of(own.id);
  Mechanics truth = baseline_mechanics(e, problem.choice);
  effect.assemble(truth, own.values.data());
  const auto response = simulate(truth, samples);
  double largest = 0;
  for (const double f : response) largest = std::max(largest, std::abs(f));
  std::mt19937 random(5);
  const auto noise = ar1(response.size(), 0.01 * largest, 0, random);
  for (std::size_t i = 0; i < response.size(); ++i) samples.list[i].response = response[i] + noise[i];
  problem.noise.sd.assign(response.size(), 0.01 * largest);
  problem.noise.shared.assign(samples.runs.size(), {});
  problem.thin = samples;
  const ModelFit alone = fit_explanation(problem, {});
  problem.baseline_residual = FitProblem::residual(samples, alone.simulate(samples));
  const ModelFit fit =
      with_intervals(problem, refitted(problem, fit_explanation(problem, {&effect}), samples, true, 5));
  EXPECT_LT(fit.cost, alone.cost - 30);
  EXPECT_LT(fit.cost / static_cast<double>(fit.count), 1.2);
  std::size_t k = 0;
  for (std::size_t i = 0; i < fit.values.size(); ++i) {
    const FreeParameter& p = fit.explanation->parameters()[i];
    if (p.effect < 0) continue;
    // Set by the one sample at which the contact snaps: between two samples there is nothing to tell it, and
    // no interval to test; nor is there of what the law does without.
    if (p.name == "transition" || fit.is_held(i)) {
      ++k;
      continue;
    }
    const DiagnosedParameter found = fit.parameter(i, 1);
    const double truth = p.coordinate(own.values[k]), low = p.coordinate(found.low),
                 high = p.coordinate(found.high);
    EXPECT_TRUE(truth > low - (high - low) / 2 && truth < high + (high - low) / 2)  // twice the 95 % interval
        << p.name << " " << own.values[k] << ": " << found.value << " in " << found.low << " to "
        << found.high;
    ++k;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Effects, OwnLaw_regression,
    testing::Values(
        OwnLaw{"instrument_compliance", Motion::normal, {6e-6}},
        OwnLaw{"contact_point_offset", Motion::normal, {5e-9}},
        OwnLaw{"thermal_drift", Motion::normal, {3e-11}}, OwnLaw{"adhesion", Motion::normal, {2e-4, 0.6}},
        OwnLaw{"effective_radius", Motion::normal, {0.8}},
        OwnLaw{"bulk_plasticity", Motion::normal, {6e8, 2.84}},
        OwnLaw{"roughness_compliance", Motion::normal, {3e-9, 0.3, 0}},
        OwnLaw{"creep", Motion::normal, {5e-9, 20}},
        OwnLaw{"adhesion_hysteresis", Motion::normal, {0.5, 5, 0.9}},
        OwnLaw{"baseline_tilt", Motion::normal, {2000}},
        OwnLaw{"lateral_compliance", Motion::sliding, {5e-5}},
        OwnLaw{"adhesion_offset", Motion::sliding, {1e-4}},
        OwnLaw{"static_friction_peak", Motion::sliding, {1.4, 1e-8}},
        OwnLaw{"velocity_dependence", Motion::sliding, {0.01}},
        OwnLaw{"surface_tilt", Motion::sliding, {0.03}},
        OwnLaw{"lateral_zero_offset", Motion::sliding, {1e-5}},
        OwnLaw{"area_proportional_friction", Motion::sliding, {4e8}},
        OwnLaw{"run_in", Motion::sliding, {0.4, 1.5}}, OwnLaw{"stick_slip", Motion::sliding, {3e-5, 1.7e-8}},
        OwnLaw{"rate_and_state", Motion::sliding, {0.01, 0.02, 5e-9}},
        OwnLaw{"rolling_adhesion_offset", Motion::rolling, {4e-4}},
        OwnLaw{"contact_radius_scaling", Motion::rolling, {0.02}},
        OwnLaw{"roughness_dependent_rolling", Motion::rolling, {3e-4, 6e-4, 1e-9}},
        OwnLaw{"viscous_rolling", Motion::rolling, {30}}, OwnLaw{"torsion_resistance", Motion::rail, {5e-3}},
        OwnLaw{"contact_radius_scaling", Motion::torsion, {0.064}}),
    [](const auto& info) { return info.param.id + "_" + name_of(info.param.mode); });

TEST(FreeParameter_analytic, is_stopped_at_bounds_that_are_only_the_searchs_own) {
  FreeParameter ratio{"ratio", "", 0, 0.1, 10, true, 1, {}, false};
  EXPECT_TRUE(ratio.is_stopped_at(10));
  EXPECT_TRUE(ratio.is_stopped_at(0.1));
  EXPECT_FALSE(ratio.is_stopped_at(9.8));
  FreeParameter compliance{"compliance", "m/N", 0, 0, 1e-3, false, 1e-5, {}, false};
  EXPECT_FALSE(compliance.is_stopped_at(0)) << "none of it";
  EXPECT_TRUE(compliance.is_stopped_at(1e-3));
  FreeParameter transition{"transition", "", 0, 0, 1, false, 1, {}, true};
  EXPECT_FALSE(transition.is_stopped_at(1)) << "JKR";
}

/// Hertz with noise, `runs` times up to 40 nm and back in 100 samples.
Recording repeated_indentation(int runs) {
  Recording r;
  r.mode = Motion::normal;
  r.particle = test::borosilicate();
  r.substrate = test::silicon();
  RecordingTable table;
  table.file = "indentation.csv";
  table.control = {"normal_displacement"};
  table.response = "normal_force";
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  const Hertz hertz = test::experiment(Motion::normal).hertz();
  for (int run = 1; run <= runs; ++run)
    for (int i = 0; i < 100; ++i) {
      const double d = 0.8 * test::nm * (i < 50 ? i + 1 : 100 - i);
      table.columns["run"].push_back(run);
      table.columns["time"].push_back(i);
      table.columns["normal_displacement"].push_back(d);
      table.columns["normal_force"].push_back(hertz.force(d) + 10 * test::uN * normal(random));
    }
  r.tables = {table};
  return r;
}

TEST(PreparedFit_behaviour, repeats_beyond_the_second_leave_the_search_before_any_detail_does) {
  const auto few = prepared_fit(repeated_indentation(4), {}),
             many = prepared_fit(repeated_indentation(40), {});
  EXPECT_EQ(few.problem.thin.list.size(), 400u);
  ASSERT_EQ(many.problem.thin.runs.size(), 40u) << "runs keep their numbers";
  for (std::size_t r = 0; r < 40; ++r)
    EXPECT_EQ(many.problem.thin.runs[r].end - many.problem.thin.runs[r].begin, r < 2 ? 100u : 0u) << r;
  EXPECT_EQ(many.problem.samples.list.size(), 4000u);
  EXPECT_EQ(many.baseline.count, 4000u) << "costs are those of all samples";
}

}  // namespace
}  // namespace asperity
