// Pairs of which one effect explains nearly all of the mismatch, and the other most of what is left.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "dem_compare/laws/maugis_dugdale.h"
#include "diagnosis/conceal/concealed_recording.h"
#include "diagnosis/diagnose.h"
#include "diagnosis/fit/model_fit.h"
#include "diagnosis/mechanics/attraction_in_case.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

/// `first`, `second`: in the order of the alphabet; `of_law`: those whose parameters are the catalogue's.
void expect_pair(const std::string& first, const std::string& second, double noise, unsigned seed,
                 const std::vector<std::string>& of_law) {
  const ConcealedRecording concealed = conceal({Motion::normal, {first, second}, noise, seed, ""});
  const Diagnosis d = diagnose(concealed.recording);
  ASSERT_EQ(d.left_out.size(), 2u) << diagnosis_json(d);
  EXPECT_NE(d.verdict, Verdict::ambiguous);
  EXPECT_EQ(std::min(d.left_out[0].id, d.left_out[1].id), first) << diagnosis_json(d);
  EXPECT_EQ(std::max(d.left_out[0].id, d.left_out[1].id), second) << diagnosis_json(d);
  for (const DiagnosedEffect& effect : d.left_out)
    for (const TrueEffect& truth : concealed.truth.effects)
      if (truth.id == effect.id && std::find(of_law.begin(), of_law.end(), truth.id) != of_law.end())
        for (const DiagnosedParameter& parameter : effect.parameters)
          if (truth.parameters.count(parameter.name)) {
            EXPECT_LE(parameter.low, truth.parameters.at(parameter.name).value) << parameter.name;
            EXPECT_GE(parameter.high, truth.parameters.at(parameter.name).value) << parameter.name;
          }
}

void expect_adhesion_and_compliance(double noise, unsigned seed) {
  expect_pair("adhesion", "instrument_compliance", noise, seed, {"adhesion", "instrument_compliance"});
}

TEST(Pairs_other_code, a_drift_beside_asperities_does_not_mend_their_law) {
  // The challenge's number 45 of seed 140900: of what the simulation misses the drift is 1.4 %, but no layer
  // gives way in a hold. (Asperities on rings over a half-space: their length comes out a tenth too large.)
  expect_pair("roughness_compliance", "thermal_drift", 0.005, 140945, {"thermal_drift"});
}

TEST(Pairs_other_code, a_compliance_is_named_beside_the_adhesion_that_hides_it) {
  // Maugis' solution behind a spring, the recording of the challenge (seed 73000, number 93) that was called
  // adhesion alone: the compliance mends less than a tenth of the whole mismatch.
  expect_adhesion_and_compliance(0.01, 73093);
}

TEST(Pairs_other_code, adhesion_and_compliance_are_tried_together_where_both_are_poor_alone) {
  // It was called adhesion on a sphere of another radius, for one sample that snapped before the law says so.
  expect_adhesion_and_compliance(0.008, 5);
}

TEST(Pairs_other_code, adhesion_and_compliance_that_a_larger_set_brings_are_fitted_from_all_starts) {
  // The challenge's number 96 of seed 140700: from the larger set alone the pair stays in a valley beside,
  // and another radius was named.
  expect_adhesion_and_compliance(0.01, 140796);
}

TEST(SimplerForm_analytic, of_hysteresis_with_works_alike_is_adhesion_of_their_mean) {
  FitProblem problem;
  problem.experiment = test::experiment(Motion::normal);
  const auto fit = [&](double closing, double opening) {
    ModelFit f;
    f.explanation = std::make_shared<Explanation>(
        problem.experiment, problem.choice,
        std::vector<const Effect*>{&effect_of("adhesion_hysteresis"), &effect_of("instrument_compliance")});
    for (const FreeParameter& p : f.explanation->parameters())
      f.values.push_back(p.name == "work_closing"   ? closing
                         : p.name == "work_opening" ? opening
                         : p.name == "transition"   ? 0.6
                                                    : 1e-6);
    return f;
  };
  EXPECT_TRUE(fit(0.1, 0.3).in_simpler_form(problem).empty());
  const std::vector<ModelFit> simpler = fit(0.1, 0.11).in_simpler_form(problem);
  ASSERT_FALSE(simpler.empty());
  bool has_its_own_range = false;
  for (const ModelFit& start : simpler) {
    EXPECT_EQ(start.explanation->name(), "adhesion + instrument_compliance");
    const double pull_off = *start.value_of("pull_off_force", &effect_of("adhesion"));
    const double transition = *start.value_of("transition", &effect_of("adhesion"));
    MaugisDugdale mean{problem.experiment.reduced_modulus(), 8.5e-6, 0.105, 1};
    mean.cohesive_stress = lambda_of_transition(transition) / mean.lambda();
    EXPECT_NEAR(pull_off / mean.pull_off_force(), 1, 1e-6);
    has_its_own_range = has_its_own_range || transition == 0.6;
    EXPECT_EQ(*start.value_of("compliance", &effect_of("instrument_compliance")), 1e-6);
  }
  EXPECT_TRUE(has_its_own_range);
}

}  // namespace
}  // namespace asperity
