// Verdicts on recordings whose hidden effect is one that the format names since its first version, and on
// noise that neighbours share. Events and curves are made here by plain formulas, not by the mechanics that
// diagnoses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "core/hertz.h"
#include "diagnosis/diagnose.h"
#include "tests/diagnosis/support/loops_of_events.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

using test::nm;
using test::uN;

double force_by_hertz(double d) { return d > 0 ? test::experiment(Motion::normal).hertz().force(d) : 0; }

/// Load and unload to 50 nm in 100 samples each; `make` gives the force of a fresh run at depth and
/// direction.
Recording indentation(const std::function<std::function<double(double, int)>()>& make, int runs, double noise,
                      double share, double memory, unsigned seed) {
  Recording r;
  r.mode = Motion::normal;
  r.particle = test::borosilicate();
  r.substrate = test::silicon();
  RecordingTable table;
  table.file = "indentation.csv";
  table.control = {"normal_displacement"};
  table.response = "normal_force";
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  double slow = normal(random);
  for (int run = 1; run <= runs; ++run) {
    const auto force = make();
    for (int i = 1; i <= 200; ++i) {
      const int direction = i <= 100 ? 1 : -1;
      const double d = 50 * nm * (i <= 100 ? i / 100.0 : (200 - i) / 100.0);
      table.columns["run"].push_back(run);
      table.columns["time"].push_back(0.1 * i);
      table.columns["normal_displacement"].push_back(d);
      table.columns["normal_force"].push_back(
          force(d, direction) + noise * (std::sqrt(share) * slow + std::sqrt(1 - share) * normal(random)));
      slow = memory * slow + std::sqrt(1 - memory * memory) * normal(random);
      table.segment.push_back(direction > 0 ? "load" : "unload");
    }
  }
  r.tables = {table};
  return r;
}

TEST(DiagnoseAdded_analytic, noise_of_which_neighbours_share_half_is_no_mismatch) {
  const auto elastic = [] { return [](double d, int) { return force_by_hertz(d); }; };
  for (const unsigned seed : {1u, 2u, 3u}) {
    const Diagnosis d = diagnose(indentation(elastic, 1, 15 * uN, 0.5, 0.7, seed));
    EXPECT_EQ(d.verdict, Verdict::no_mismatch) << seed << " " << diagnosis_json(d);
  }
}

TEST(DiagnoseAdded_analytic, noise_that_neighbours_share_is_learned_from_the_best_explanation) {
  const auto flatter = [] { return [](double d, int) { return 1.15 * force_by_hertz(d); }; };
  for (const unsigned seed : {1u, 2u, 3u}) {
    const Diagnosis d = diagnose(indentation(flatter, 1, 15 * uN, 0.5, 0.7, seed));
    ASSERT_EQ(d.verdict, Verdict::explained) << seed << " " << diagnosis_json(d);
    ASSERT_EQ(d.left_out.size(), 1u) << seed;
    EXPECT_EQ(d.left_out[0].id, "effective_radius");
    // The force grows with the root of the radius.
    const DiagnosedParameter& radius = d.left_out[0].parameters[0];
    EXPECT_NEAR(radius.value, 1.15 * 1.15, 0.02);
    EXPECT_GT(radius.high - radius.low, 0.004) << "as wide as shared noise demands";
  }
}

TEST(DiagnoseAdded_analytic, a_ripple_that_looks_like_shared_noise_is_not_called_noise) {
  // Light that the sample reflects: 40 uN along 20 nm, with 15 uN of noise.
  constexpr double twice_pi = 6.283185307179586;
  const auto rippled = [] {
    return [](double d, int) { return force_by_hertz(d) + 40 * uN * std::sin(twice_pi * d / (20 * nm)); };
  };
  for (const unsigned seed : {1u, 2u, 3u}) {
    const Diagnosis d = diagnose(indentation(rippled, 1, 15 * uN, 0.5, 0.7, seed));
    EXPECT_NE(d.verdict, Verdict::no_mismatch) << seed << " " << diagnosis_json(d);
    EXPECT_NE(d.verdict, Verdict::explained) << seed << " " << diagnosis_json(d);
  }
}

TEST(DiagnoseAdded_analytic, a_small_effect_of_the_instrument_that_is_plain_is_named_beside_a_large_one) {
  // A zero error of 0.4 nm: 1.2 % of the force beside the radius' 30 %, but twenty times the noise.
  const auto shifted = [] { return [](double d, int) { return 0.7 * force_by_hertz(d - 0.4 * nm); }; };
  const Diagnosis d = diagnose(indentation(shifted, 2, 1 * uN, 0, 0, 6));
  ASSERT_EQ(d.verdict, Verdict::explained) << diagnosis_json(d);
  ASSERT_EQ(d.left_out.size(), 2u) << diagnosis_json(d);
  double offset = 0;
  for (const auto& named : d.left_out)
    if (named.id == "contact_point_offset") offset = named.parameters[0].value;
  EXPECT_NEAR(std::abs(offset), 0.4 * nm, 0.02 * nm) << diagnosis_json(d);
}

TEST(DiagnoseAdded_analytic, a_burst_at_a_load_is_a_pop_in) {
  const auto bursting = [] {
    return [jump = 0.0](double d, int) mutable {
      if (force_by_hertz(d) > 900 * uN) jump = 4 * nm;
      return force_by_hertz(d - jump);
    };
  };
  const Diagnosis d = diagnose(indentation(bursting, 2, 10 * uN, 0, 0, 4));
  ASSERT_EQ(d.verdict, Verdict::explained) << diagnosis_json(d);
  ASSERT_EQ(d.left_out.size(), 1u);
  EXPECT_EQ(d.left_out[0].id, "pop_in");
  EXPECT_NEAR(d.left_out[0].parameters[0].value, 4 * nm, 0.3 * nm);
  EXPECT_NEAR(d.left_out[0].parameters[1].value, 900 * uN, 40 * uN);
}

TEST(DiagnoseAdded_analytic, a_sensor_at_the_end_of_its_range_is_clipped) {
  const auto clipped = [] { return [](double d, int) { return std::min(force_by_hertz(d), 1500 * uN); }; };
  const Diagnosis d = diagnose(indentation(clipped, 2, 10 * uN, 0, 0, 5));
  ASSERT_EQ(d.verdict, Verdict::explained) << diagnosis_json(d);
  ASSERT_EQ(d.left_out.size(), 1u);
  EXPECT_EQ(d.left_out[0].id, "clipping");
  EXPECT_NEAR(d.left_out[0].parameters[0].value, 1500 * uN, 10 * uN);
}

TEST(DiagnoseAdded_analytic, stick_slip_of_uneven_events_is_found_in_every_number_of_runs) {
  const double drop = 8 * uN, period = 40 * nm;
  for (const int runs : {1, 3}) {
    test::LoopsOfEvents loops{{}, 0.23, drop, period, 3 * nm, 0.8 * uN, 4, 150, 11};
    for (int run = 1; run <= runs; ++run) loops.loads.push_back(100 * uN * run);
    const Diagnosis d = diagnose(loops.recording());
    const auto named = [](const DiagnosedEffect& effect) { return effect.id == "stick_slip"; };
    const auto found = std::find_if(d.left_out.begin(), d.left_out.end(), named);
    ASSERT_NE(found, d.left_out.end()) << runs << " " << diagnosis_json(d);
    EXPECT_NEAR(found->parameters[0].value / drop, 1, 0.15) << runs;
    EXPECT_NEAR(found->parameters[1].value / period, 1, 0.05) << runs;
  }
}

}  // namespace
}  // namespace asperity
