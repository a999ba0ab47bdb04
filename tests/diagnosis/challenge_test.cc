// The referee of the proof: what counts as right, what is left to be done after an interruption, and the
// user's own attempts.
#include "diagnosis/challenge/challenge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/atomic_file.h"
#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::TemporaryFolder;

TEST(Challenge_behaviour, has_every_effect_at_three_levels_of_noise_and_all_families) {
  std::map<std::string, std::set<double>> noise;
  std::map<std::string, int> families;
  std::set<std::string> names;
  for (const auto& item : challenge_matrix(false)) {
    ++families[item.family];
    EXPECT_TRUE(names.insert(item.name).second) << item.name;
    if (item.family == "single")
      noise[name_of(item.options.mode) + "/" + item.options.effects[0]].insert(item.options.noise);
  }
  std::size_t concealed = 0;
  for (const Motion mode : all_modes())
    for (const auto& effect : concealable_effects(mode)) {
      ++concealed;
      EXPECT_EQ(noise[name_of(mode) + "/" + effect].size(), 3u) << effect;
    }
  EXPECT_EQ(noise.size(), concealed);
  for (const char* family :
       {"single", "finite_elements", "pair", "null", "out_of_catalogue", "decoy", "indistinguishable"})
    EXPECT_GT(families[family], 5) << family;
  EXPECT_LT(challenge_matrix(true).size(), challenge_matrix(false).size() / 2);
}

TEST(Challenge_behaviour, all_its_recordings_can_be_made) {
  for (const auto& item : challenge_matrix(true)) EXPECT_NO_THROW(conceal(item)) << item.name;
}

TEST(Challenge_behaviour, histories_of_finite_elements_are_the_truth_of_their_own_family) {
  for (const auto& item : challenge_matrix(true)) {
    if (item.family != "finite_elements") continue;
    const ConcealedRecording concealed = conceal(item);
    ASSERT_EQ(concealed.truth.effects.size(), item.options.effects.size()) << item.name;
    EXPECT_GE(concealed.recording.tables[0].rows(), 20u) << item.name;
    for (const auto& effect : concealed.truth.effects) {
      EXPECT_EQ(effect.model, "finite elements");
      for (const auto& [name, parameter] : effect.parameters)
        EXPECT_GT(parameter.value, 0) << item.name << " " << name;
    }
  }
}

ChallengeScore scored(const std::string& family, const std::vector<std::string>& truth,
                      const std::string& verdict, const std::vector<std::string>& named) {
  ChallengeScore score;
  score.family = family, score.truth = truth, score.verdict = verdict, score.named = named;
  return score;
}

TEST(Challenge_behaviour, an_answer_that_lists_more_or_less_than_the_truth_is_wrong) {
  EXPECT_TRUE(scored("single", {"a"}, "explained", {"a"}).is_right());
  EXPECT_TRUE(scored("single", {"a"}, "partly_explained", {"a"}).is_right());
  EXPECT_FALSE(scored("single", {"a"}, "explained", {"a", "b"}).is_right());
  EXPECT_FALSE(scored("pair", {"a", "b"}, "explained", {"a"}).is_right());
  EXPECT_FALSE(scored("single", {"a"}, "ambiguous", {"a"}).is_right());
  EXPECT_FALSE(scored("single", {"a"}, "unexplained", {}).is_right());
}

TEST(Challenge_behaviour, nulls_outsiders_and_look_alikes_have_right_answers_of_their_own) {
  EXPECT_TRUE(scored("null", {}, "no_mismatch", {}).is_right());
  EXPECT_FALSE(scored("null", {}, "unexplained", {}).is_right());
  EXPECT_TRUE(scored("finite_elements", {}, "no_mismatch", {}).is_right());
  EXPECT_FALSE(scored("finite_elements", {}, "explained", {"a"}).is_right());
  EXPECT_TRUE(scored("out_of_catalogue", {"interference"}, "unexplained", {}).is_right());
  EXPECT_FALSE(scored("out_of_catalogue", {"interference"}, "explained", {"a"}).is_right());
  ChallengeScore alike = scored("indistinguishable", {"a"}, "ambiguous", {"b"});
  EXPECT_FALSE(alike.is_right());
  alike.alternatives = {{"b"}, {"a"}};
  EXPECT_TRUE(alike.is_right());
}

TEST(Challenge_analytic, location_agrees_fully_where_the_region_is_the_effects_own) {
  const ConcealedRecording concealed = conceal({Motion::normal, {"contact_point_offset"}, 0.01, 2, ""});
  Diagnosis diagnosis;
  EXPECT_EQ(location_overlap(concealed.recording, concealed.truth, diagnosis), 0);
  MismatchRegion whole;
  whole.table = "loading.csv";
  diagnosis.mismatch = {whole};
  double visible = 0;
  for (const double value : concealed.truth.contributions[0].in_noise) visible += std::abs(value) > 0.5;
  const double rows = static_cast<double>(concealed.recording.tables[0].rows());
  EXPECT_NEAR(location_overlap(concealed.recording, concealed.truth, diagnosis),
              2 * visible / (visible + rows), 1e-12);
  const ConcealedRecording null = conceal({Motion::normal, {}, 0.01, 2, ""});
  EXPECT_EQ(location_overlap(null.recording, null.truth, diagnosis), -1);
}

TEST(Challenge_behaviour,
     users_own_attempts_lower_the_residual_of_a_smooth_discrepancy_and_leave_noise_alone) {
  const UserBaselines offset =
      user_baselines(conceal({Motion::rolling, {"rolling_adhesion_offset"}, 0.01, 3, ""}).recording);
  EXPECT_LT(offset.sparse_regression, 0.5 * offset.simulation);
  EXPECT_LT(offset.gaussian_process, 0.5 * offset.simulation);
  EXPECT_FALSE(offset.terms.empty());
  const UserBaselines null = user_baselines(conceal({Motion::rolling, {}, 0.01, 3, ""}).recording);
  EXPECT_NEAR(null.simulation, 1, 0.5);
  EXPECT_LT(null.gaussian_process, 1.3 * null.simulation);
}

TEST(Challenge_behaviour, goes_on_where_it_was_interrupted_and_begins_anew_for_another_program) {
  const TemporaryFolder folder;
  ChallengeOptions options;
  options.output = folder.path;
  options.only = "null-torsion";
  options.program = "first";
  const auto scores = run_challenge(options);
  ASSERT_FALSE(scores.empty());
  const auto file = folder.path / scores[0].name / "score.json";
  const auto written = std::filesystem::last_write_time(file);
  const auto again = run_challenge(options);
  EXPECT_EQ(std::filesystem::last_write_time(file), written);
  EXPECT_EQ(again[0].verdict, scores[0].verdict);
  EXPECT_EQ(again[0].seconds, scores[0].seconds);
  write_file_atomically(file, "{ cut short");
  EXPECT_EQ(run_challenge(options)[0].verdict, scores[0].verdict);
  options.program = "second";
  run_challenge(options);
  EXPECT_NE(read_file(file).find("\"second\""), std::string::npos);
  options.only = "no such thing";
  EXPECT_NE(
      test::message_of<InputError>([&] { run_challenge(options); }).find("has 'no such thing' in its name"),
      std::string::npos);
}

TEST(Challenge_behaviour, text_tells_rates_confusion_and_wrong_answers) {
  ChallengeScore right = scored("single", {"lateral_compliance"}, "explained", {"lateral_compliance"});
  right.name = "001-right";
  right.parameters = {{"lateral_compliance/compliance", 2, 2.1, 1.9, 2.3}};
  right.overlap = 0.8;
  ChallengeScore wrong = scored("null", {}, "explained", {"adhesion"});
  wrong.name = "002-wrong";
  const std::string text = challenge_text({right, wrong});
  for (const char* part :
       {"single effects named exactly | 100.0 % (1 of 1)", "nulls kept clean | 0.0 % (0 of 1)",
        "coverage of the 95 % intervals | 100.0 % (1 of 1)", "| single: lateral_compliance | 1 |",
        "- 002-wrong, noise 0: explained, adhesion",
        "| lateral_compliance/compliance | 1 | 5 % | 5 % | 1 of 1 |"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

}  // namespace
}  // namespace asperity
