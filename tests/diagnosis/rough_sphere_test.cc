// Single rough spheres of a half-space solver (blind/rough_spheres): each follows the law of a layer of
// asperities to some per cent only, and nothing else is to be named for the rest.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include "core/csv.h"
#include "diagnosis/conceal/concealed_recording.h"
#include "diagnosis/diagnose.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

using test::nm;
using test::uN;

/// Load and unload to `largest` in 100 samples each, `noise` a part of it.
Recording rough_sphere(const std::filesystem::path& file, double largest, double noise, unsigned seed) {
  const CsvTable table = read_csv(file);
  const auto force = table.numbers("normal_force [N]"), approach = table.numbers("approach [m]");
  const Hertz hertz = test::experiment(Motion::normal).hertz();
  // What the asperities add to Hertz' approach, straight in the logarithm of the force.
  const auto approach_at = [&](double f) {
    std::size_t k = 1;
    while (k + 1 < force.size() && force[k] < f) ++k;
    const double share = std::log(f / force[k - 1]) / std::log(force[k] / force[k - 1]);
    const auto layer = [&](std::size_t i) { return approach[i] - hertz.approach(force[i]); };
    return hertz.approach(f) + layer(k - 1) + share * (layer(k) - layer(k - 1));
  };
  Recording r;
  r.mode = Motion::normal;
  r.particle = test::borosilicate();
  r.substrate = test::silicon();
  RecordingTable recorded;
  recorded.file = "indentation.csv";
  recorded.control = {"normal_displacement"};
  recorded.response = "normal_force";
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, noise * largest);
  const double touch = approach_at(2e-3 * largest), deepest = approach_at(largest);
  const auto force_at = [&](double d) {  // bisection: the approach rises with the force
    double low = 2e-3 * largest, high = largest;
    for (int i = 0; i < 60; ++i) (approach_at((low + high) / 2) < d ? low : high) = (low + high) / 2;
    return low;
  };
  for (int i = 1; i <= 200; ++i) {
    const double d = touch + (deepest - touch) * (i <= 100 ? i / 100.0 : (200 - i) / 100.0);
    recorded.columns["run"].push_back(1);
    recorded.columns["time"].push_back(0.1 * i);
    recorded.columns["normal_displacement"].push_back(d - touch);
    recorded.columns["normal_force"].push_back(force_at(d) + normal(random));
    recorded.segment.push_back(i <= 100 ? "load" : "unload");
  }
  r.tables = {recorded};
  return r;
}

/// Of the challenge's number 241 of seed 141700, by half-spaces: counted from the least force that was
/// solved, a five-hundredth of one and a half times the largest. From first touch it was called another
/// radius.
TEST(RoughSphere_other_code, asperities_seen_from_a_force_of_their_own_are_named_with_that) {
  const ConcealedRecording concealed =
      conceal({Motion::normal, {"roughness_compliance"}, 0.01, 141941, "other_code"});
  const Diagnosis d = diagnose(concealed.recording);
  EXPECT_EQ(d.verdict, Verdict::explained) << diagnosis_json(d);
  ASSERT_EQ(d.left_out.size(), 1u) << diagnosis_json(d);
  EXPECT_EQ(d.left_out[0].id, "roughness_compliance");
  const auto& parameters = d.left_out[0].parameters;
  ASSERT_EQ(parameters.size(), 3u) << diagnosis_json(d);
  EXPECT_EQ(parameters[2].name, "zero_force");
  double largest = 0;
  for (const RecordingTable& table : concealed.recording.tables)
    for (const double force : table.column("normal_force")) largest = std::max(largest, force);
  const double zero = 1.5 / 500 * largest;
  EXPECT_LT(parameters[2].low, zero);
  EXPECT_GT(parameters[2].high, zero);
}

/// These were a film: alone, `ambiguous`, or with a nonlinear detector, `partly_explained`.
TEST(RoughSphere_other_code, asperities_that_a_film_imitates_are_named) {
  const auto folder = std::filesystem::path(__FILE__).parent_path() / "blind/rough_spheres";
  for (const double largest : {200 * uN, 320 * uN}) {
    SCOPED_TRACE(largest);
    const Diagnosis d =
        diagnose(rough_sphere(folder / "rms1.0_rolloff200_cutoff80_seed11.csv", largest, 0.003, 7));
    EXPECT_TRUE(d.verdict == Verdict::explained || d.verdict == Verdict::partly_explained)
        << diagnosis_json(d);
    ASSERT_EQ(d.left_out.size(), 1u) << diagnosis_json(d);
    EXPECT_EQ(d.left_out[0].id, "roughness_compliance");
  }
}

TEST(RoughSphereNightly_other_code, is_a_layer_of_asperities_and_nothing_is_named_beside_it) {
  const auto folder = std::filesystem::path(__FILE__).parent_path() / "blind/rough_spheres";
  int spheres = 0, named = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path().filename());
    const Diagnosis d = diagnose(rough_sphere(entry.path(), 250 * uN, 0.003, 7));
    const auto is_layer = [](const DiagnosedEffect& effect) { return effect.id == "roughness_compliance"; };
    const bool layer_alone = d.left_out.size() == 1 && is_layer(d.left_out[0]);
    if (d.verdict == Verdict::explained) {
      EXPECT_TRUE(layer_alone) << diagnosis_json(d);
    }
    ++spheres, named += layer_alone;
  }
  EXPECT_EQ(spheres, 8);
  EXPECT_GE(named, 6) << "the others ambiguous";
}

}  // namespace
}  // namespace asperity
