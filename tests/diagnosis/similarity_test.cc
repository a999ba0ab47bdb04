// No number of the diagnosis knows how large a metre, a pascal or a second is: a recording with all lengths
// L, stresses E and times T times as large has the same answer, its parameters in those units (dimensional
// analysis: Buckingham 1914).
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "diagnosis/conceal/concealed_recording.h"
#include "diagnosis/diagnose.h"
#include "diagnosis/recording/force_sign.h"
#include "tests/diagnosis/support/made_tables.h"

namespace asperity {
namespace {

using test::nm;
using test::uN;

struct Units {
  double length, stress, time;
  double force() const { return stress * length * length; }
};

Recording in_units(Recording r, const Units& units) {
  for (RecordedBody* body : {&r.particle, &r.substrate}) {
    body->youngs_modulus *= units.stress;
    body->radius *= units.length, body->rms_roughness *= units.length;
  }
  const std::map<std::string, double> factors{{"time", units.time},
                                              {"normal_displacement", units.length},
                                              {"lateral_displacement", units.length},
                                              {"normal_force", units.force()},
                                              {"lateral_force", units.force()}};
  for (RecordingTable& table : r.tables)
    for (auto& [name, values] : table.columns)
      if (const auto factor = factors.find(name); factor != factors.end())
        for (double& value : values) value *= factor->second;
  return r;
}

/// scale: of the parameter in these units.
void expect_the_same(const Recording& recording, const std::string& effect, double (*scale)(const Units&),
                     const std::vector<Units>& all) {
  const Diagnosis here = diagnose(recording);
  ASSERT_EQ(here.verdict, Verdict::explained) << here.in_words;
  ASSERT_EQ(here.left_out.size(), 1U) << here.in_words;
  EXPECT_EQ(here.left_out[0].id, effect);
  for (const Units& units : all) {
    const Diagnosis there = diagnose(in_units(recording, units));
    EXPECT_EQ(there.verdict, here.verdict) << there.in_words;
    ASSERT_EQ(there.left_out.size(), 1U) << there.in_words;
    EXPECT_EQ(there.left_out[0].id, effect);
    const DiagnosedParameter &one = here.left_out[0].parameters[0], &other = there.left_out[0].parameters[0];
    const double half = 0.5 * (one.high - one.low);
    EXPECT_NEAR(other.value / scale(units), one.value, 0.05 * half);
    EXPECT_NEAR((other.high - other.low) / scale(units) / (one.high - one.low), 1, 0.02);
    EXPECT_NEAR(there.improved.chi2_reduced, here.improved.chi2_reduced, 1e-3);
  }
}

TEST(SimilarNightly_analytic, a_drift_is_found_at_the_same_rate_in_any_units) {
  const auto hertz = [](double d) {
    return 4.0 / 3 * test::experiment(Motion::normal).reduced_modulus() * std::sqrt(8.5e-6) *
           std::pow(std::max(0.0, d), 1.5);
  };
  expect_the_same(test::indentation([&](double d, double t) { return hertz(d - 0.2 * nm * t); }, 20 * uN, 3),
                  "thermal_drift", [](const Units& units) { return units.length / units.time; },
                  {{1e4, 1, 1}, {0.01, 1e-3, 1e3}});
}

TEST(Similar_analytic, a_lateral_compliance_is_found_in_any_units) {
  expect_the_same(test::loops(
                      4e-5, [](double, double, int) { return 0.0; }, 4 * uN, 4),
                  "lateral_compliance", [](const Units& units) { return 1 / (units.stress * units.length); },
                  {{1e4, 1e-3, 1e3}});
}

TEST(Similar_analytic, a_loop_is_the_same_from_the_other_side) {
  const Recording loops =
      conceal(ConcealOptions{Motion::sliding, {"static_friction_peak"}, 0.01, 5, ""}).recording;
  const Diagnosis here = diagnose(loops);
  ASSERT_EQ(here.verdict, Verdict::explained) << here.in_words;
  for (const bool turns_force : {true, false}) {
    Recording turned = loops;  // its "forward" segments count the displacement down
    for (double& x : turned.tables[0].columns["lateral_displacement"]) x = -x;
    if (turns_force)
      for (double& f : turned.tables[0].columns["lateral_force"]) f = -f;
    turn_signs_to_dissipate(turned);
    EXPECT_EQ(turned.remarks.empty(), turns_force);
    const Diagnosis there = diagnose(turned);
    EXPECT_EQ(there.verdict, here.verdict) << there.in_words;
    ASSERT_EQ(there.left_out.size(), here.left_out.size()) << there.in_words;
    for (std::size_t k = 0; k < here.left_out.size(); ++k)
      EXPECT_EQ(there.left_out[k].id, here.left_out[k].id);
    EXPECT_NEAR(there.improved.chi2_reduced, here.improved.chi2_reduced, 1e-3);
    EXPECT_EQ(there.remarks.size(), here.remarks.size() + turned.remarks.size());
  }
}

Recording every_other_row(const Recording& recording, std::size_t first) {
  Recording few = recording;
  for (RecordingTable& table : few.tables) {
    const auto thin = [&](auto& values) {
      auto kept = values;
      kept.clear();
      for (std::size_t i = first; i < values.size(); i += 2) kept.push_back(values[i]);
      values = kept;
    };
    for (auto& [name, values] : table.columns) thin(values);
    thin(table.segment);
  }
  return few;
}

/// Turns lie between the samples that are left.
TEST(Similar_behaviour, a_loop_is_explained_by_the_same_with_every_other_sample) {
  const Recording loops =
      conceal(ConcealOptions{Motion::sliding, {"adhesion_offset"}, 0.005, 3, ""}).recording;
  const Diagnosis all = diagnose(loops);
  ASSERT_EQ(all.verdict, Verdict::explained) << all.in_words;
  for (const std::size_t first : {0U, 1U}) {
    const Diagnosis few = diagnose(every_other_row(loops, first));
    EXPECT_EQ(few.verdict, all.verdict) << few.in_words;
    ASSERT_EQ(few.left_out.size(), 1U) << few.in_words;
    EXPECT_EQ(few.left_out[0].id, all.left_out[0].id);
    const DiagnosedParameter &one = all.left_out[0].parameters[0], &other = few.left_out[0].parameters[0];
    EXPECT_NEAR(other.value, one.value, 0.5 * (one.high - one.low));
  }
}

}  // namespace
}  // namespace asperity
