// Noise of the channel that drives the simulation: found where the response does not follow it, smoothed, and
// counted as far as it is left.
#include "diagnosis/fit/noise_of_control.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/error.h"
#include "diagnosis/catalogue/effect.h"
#include "diagnosis/diagnose.h"
#include "diagnosis/fit/prepared_fit.h"
#include "diagnosis/locate/scan.h"
#include "diagnosis/recording/smoothed_control.h"
#include "tests/diagnosis/support/driven_recording.h"

namespace asperity {
namespace {

using test::nm;
using test::uN;

/// Hertz's contact pressed to 1 mN and back under a force whose record has a noise of 3 uN; whether the
/// contact feels that.
Recording indentation_under_a_noisy_force(bool felt) {
  Recording r = test::driven(Motion::normal, test::zigzag({5 * uN, 1000 * uN, 5 * uN}, 300));
  RecordingTable& table = r.tables[0];
  std::vector<double> force = table.columns["normal_displacement"];
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  // Johnson 1985, eq. (4.23).
  const double modulus = 1 / ((1 - 0.17 * 0.17) / 71e9 + (1 - 0.25 * 0.25) / 179e9);
  std::vector<double> displacement, recorded;
  for (const double f : force) {
    recorded.push_back(f + 3 * uN * normal(random));
    const double pressing = std::max(1e-9, felt ? recorded.back() : f);
    displacement.push_back(std::cbrt(std::pow(0.75 * pressing / modulus, 2) / 8.5e-6) +
                           0.03e-9 * normal(random));
  }
  table.columns = {{"normal_force", recorded}, {"normal_displacement", displacement}};
  table.control = {"normal_force"}, table.response = "normal_displacement";
  return r;
}

TEST(NoiseOfControl_analytic, of_a_force_that_the_contact_does_not_feel_is_no_mismatch) {
  for (const bool given : {false, true}) {
    Recording r = indentation_under_a_noisy_force(false);
    if (given) r.noise["normal_displacement"] = 0.03e-9;
    const PreparedFit fit = prepared_fit(r, {});
    const Noise& noise = fit.problem.noise;
    ASSERT_EQ(noise.of_control.size(), 1u) << given;
    EXPECT_EQ(noise.of_control[0].channel, "normal_force");
    EXPECT_NEAR(noise.of_control[0].sd, 3 * uN, 0.5 * uN);
    EXPECT_NEAR(chi2_reduced(fit.problem.samples, fit.problem.baseline_residual, noise), 1, 0.15);
    EXPECT_LT(noise.of_control[0].of_response, 0.03e-9) << "what is left of it";
    // Away from the ends of a part little is left of it after smoothing.
    EXPECT_LT(noise.sd[150], 1.15 * 0.03e-9);
  }
}

TEST(NoiseOfControl_analytic, of_a_force_that_the_contact_feels_is_none) {
  const PreparedFit fit = prepared_fit(indentation_under_a_noisy_force(true), {});
  EXPECT_TRUE(fit.problem.noise.of_control.empty());
  EXPECT_NEAR(chi2_reduced(fit.problem.samples, fit.problem.baseline_residual, fit.problem.noise), 1, 0.15);
}

/// Coulomb's friction of 0.3 under a load whose record has a noise of 0.5 %, between turns far apart.
TEST(NoiseOfControl_analytic, of_a_load_that_friction_does_not_feel_is_no_mismatch) {
  Recording r = test::driven(Motion::sliding, test::zigzag({0, 1e-6, -1e-6, 1e-6, -1e-6, 1e-6}, 100));
  RecordingTable& table = r.tables[0];
  std::mt19937 random(6);
  std::normal_distribution<double> normal;
  constexpr double mu = 0.3, load = 200 * uN, of_friction = 0.15 * uN;
  const auto& path = table.columns["lateral_displacement"];
  double before = -1;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double direction = path[i] > before ? 1 : -1;
    before = path[i];
    table.columns["normal_force"].push_back(load * (1 + 0.005 * normal(random)));
    table.columns["lateral_force"][i] = direction * mu * load + of_friction * normal(random);
  }
  r.noise["lateral_force"] = of_friction;
  const PreparedFit fit = prepared_fit(r, {});
  ASSERT_EQ(fit.problem.noise.of_control.size(), 1u);
  EXPECT_NEAR(fit.problem.noise.of_control[0].sd, 1 * uN, 0.15 * uN);
  // 27 of the 100 samples of a part, m = 13 in the formula of the test of smoothing below.
  EXPECT_NEAR(fit.problem.noise.sd[150], std::hypot(of_friction, mu * uN * std::sqrt(1635.0 / 19575)),
              0.01 * uN);
  std::vector<double> sliding;  // over noise, 50 nm after a turn
  for (const Sample& s : fit.problem.samples.list)
    if (s.counts && s.since_reversal > 50e-9)
      sliding.push_back(fit.problem.baseline_residual[s.index] / fit.problem.noise.sd[s.index]);
  ASSERT_GT(sliding.size(), 400u);
  double squares = 0;
  for (const double x : sliding) squares += x * x;
  EXPECT_NEAR(squares / static_cast<double>(sliding.size()), 1, 0.2);  // three deviations of chi-square
}

TEST(NoiseOfControl_analytic, of_rows_that_give_it_is_added_in_squares_through_the_slope) {
  constexpr double mu = 0.3, of_load = 4 * uN, of_friction = 0.5 * uN;
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  Recording r = test::driven(Motion::sliding, {});
  RecordingTable& table = r.tables[0];
  table.kind = TableKind::series, table.control = {"normal_force"}, table.columns.clear();
  for (int i = 0; i < 200; ++i) {
    const double load = (20 + i) * uN;
    table.columns["normal_force"].push_back(load + of_load * normal(random));
    table.columns["lateral_force"].push_back(mu * load + of_friction * normal(random));
    table.columns["lateral_force_sd"].push_back(of_friction);
  }
  const auto chi2_of = [&] {
    const PreparedFit fit = prepared_fit(r, {});
    return chi2_reduced(fit.problem.samples, fit.problem.baseline_residual, fit.problem.noise);
  };
  EXPECT_GT(chi2_of(), 4) << "the noise of the friction alone does not explain the scatter";
  table.columns["normal_force_sd"] = test::Column(200, of_load);
  EXPECT_NEAR(chi2_of(), 1, 0.2);  // two deviations of chi-square of 200 rows
  const PreparedFit fit = prepared_fit(r, {});
  EXPECT_NEAR(fit.problem.noise.sd[100], std::hypot(of_friction, mu * of_load), 0.03 * uN);
  ASSERT_EQ(fit.problem.noise.of_control.size(), 1u);
  table.columns.erase("normal_force_sd");
  r.noise["normal_force"] = of_load;
  EXPECT_NEAR(chi2_of(), 1, 0.2);
}

/// Rolling that follows eq. (murofit) of Fuchs et al. 2014 on wafers whose roughness is known to a tenth,
/// each row on another spot.
Recording rolling_on_wafers_known_to_a_tenth() {
  constexpr double b = 4e-4, c = 8e-4, decay = 1.2 * nm, of_force = 2e-9;
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  Recording r = test::driven(Motion::rolling, {});
  r.indenter = test::diamond();
  RecordingTable& table = r.tables[0];
  table.kind = TableKind::series, table.control = {"normal_force"}, table.columns.clear();
  table.at = ForcePlace::substrate;
  for (const double rms : {0.3, 0.5, 0.8, 1.2, 1.8, 2.5, 3.2, 4.0})
    for (const double load : {200, 400, 600, 800, 1000}) {
      const double on_spot = rms * (1 + 0.1 * normal(random)) * nm;
      table.columns["normal_force"].push_back(load * uN);
      table.columns["lateral_force"].push_back(load * uN * (b + c * std::exp(-on_spot / decay)) +
                                               of_force * normal(random));
      table.columns["rms_roughness"].push_back(rms * nm);
      table.columns["rms_roughness_sd"].push_back(0.1 * rms * nm);
      table.columns["lateral_force_sd"].push_back(of_force);
    }
  return r;
}

TEST(NoiseOfControl_analytic, of_a_roughness_counts_as_the_effect_depends_on_it) {
  const Recording r = rolling_on_wafers_known_to_a_tenth();
  PreparedFit fit = prepared_fit(r, {});
  ASSERT_EQ(fit.problem.noise.of_control.size(), 1u);
  EXPECT_EQ(fit.problem.noise.of_control[0].of_response, 0) << "a constant factor does not depend on it";
  const ModelFit found = fit_explanation(fit.problem, {&effect_of("roughness_dependent_rolling")});
  ASSERT_TRUE(fit.pass_on_deviations(found));
  // sigma^2 + (f c/d exp(-rms/d) sigma_rms)^2 with the parameters found, at 0.8 nm and 1 mN.
  const auto& p = found.values;
  const double slope = 1000 * uN * p[1] / p[2] * std::exp(-0.8 * nm / p[2]);
  EXPECT_NEAR(fit.problem.noise.sd[14], std::hypot(2e-9, slope * 0.08 * nm), 0.01 * slope * 0.08 * nm);
  EXPECT_FALSE(fit.pass_on_deviations(found)) << "known already";
  const Diagnosis said = diagnose(r);
  EXPECT_EQ(said.verdict, Verdict::explained);
  ASSERT_EQ(said.left_out.size(), 1u);
  EXPECT_EQ(said.left_out[0].id, "roughness_dependent_rolling");
  EXPECT_LT(said.left_out[0].parameters[2].low, 1.2 * nm);
  EXPECT_GT(said.left_out[0].parameters[2].high, 1.2 * nm);
}

TEST(NoiseOfControl_behaviour, deviations_that_nothing_counts_are_named) {
  Recording r = rolling_on_wafers_known_to_a_tenth();
  EXPECT_TRUE(unused_deviations(r, prepared_fit(r, {}).problem.noise).empty());
  RecordingTable& table = r.tables[0];
  table.columns["time_sd"] = table.columns["lateral_force_sd"];
  r.noise["humidity"] = 2;
  std::vector<std::string> said = unused_deviations(r, prepared_fit(r, {}).problem.noise);
  ASSERT_EQ(said.size(), 2u);
  EXPECT_NE(said[0].find("'time_sd' is not used"), std::string::npos) << said[0];
  EXPECT_NE(said[1].find("'humidity' is not used"), std::string::npos) << said[1];
  table.columns.erase("time_sd"), table.columns.erase("lateral_force_sd"), r.noise.clear();
  said = unused_deviations(r, prepared_fit(r, {}).problem.noise);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("holds it already"), std::string::npos) << said[0];
  table.columns["rms_roughness_sd"][3] = -1e-10;
  EXPECT_THROW(check_recording(r), InputError);
}

TEST(SmoothedControl_analytic, keeps_a_parabola_within_each_part_and_says_what_is_left_of_noise) {
  Samples samples;
  for (int i = 0; i < 80; ++i) {
    Sample s;
    s.part = i / 40;
    s.normal_force = i < 40 ? 1 + 0.1 * i - 0.001 * i * i : 50;  // a jump between parts stays one
    samples.list.push_back(s);
  }
  const Samples before = samples;
  SampleRun run;
  run.end = 80;
  const std::vector<double> left = smooth_control(samples, run, &Sample::normal_force, 0.1);
  for (std::size_t i = 0; i < 80; ++i)
    EXPECT_NEAR(samples.list[i].normal_force, before.list[i].normal_force, 1e-9) << i;
  // The middle of a parabola through 2 m + 1 points, m = 6: 3 (3 m^2 + 3 m - 1) / ((2m + 3)(2m + 1)(2m - 1)).
  EXPECT_NEAR(left[20], std::sqrt(3.0 * (3 * 36 + 18 - 1) / (15.0 * 13 * 11)), 1e-9);
  EXPECT_GT(left[0], left[20]);
  // As little as can be: three samples at an end pass the parabola through themselves.
  EXPECT_NEAR(smooth_control(samples, run, &Sample::normal_force, 0.99)[0], 1, 1e-9);
  EXPECT_EQ(smooth_control(samples, run, &Sample::normal_force, 1.5), std::vector<double>(80, 1.0));
}

}  // namespace
}  // namespace asperity
