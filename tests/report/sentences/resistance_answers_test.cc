// Sentences on studies made from known laws.
#include "report/sentences/resistance_answers.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "report/motion/resistance_file.h"
#include "report/sentences/phrases.h"
#include "tests/dem_compare/resistance/known_studies.h"

namespace asperity::report {
namespace {

using namespace test;

bool says(const std::vector<std::string>& sentences, const std::string& part) {
  return std::any_of(sentences.begin(), sentences.end(),
                     [&](const auto& text) { return text.find(part) != std::string::npos; });
}

TEST(Phrases_behaviour, numbers_have_two_digits_of_their_sd) {
  EXPECT_EQ(number_text({31.234, 4.12}), "31.2 ± 4.1");
  EXPECT_EQ(number_text({3.79e-4, 5.4e-5}), "(3.79 ± 0.54) 10⁻⁴");
  EXPECT_EQ(number_text({-1e-4, 0.5}), "0.00 ± 0.50");
  EXPECT_EQ(number_text({-0.25}), "−0.25");
  EXPECT_EQ(number_text({0.25}), "0.25");
  EXPECT_EQ(number_text({1.5e-12}), "1.5·10⁻¹²");
  EXPECT_EQ(number_text({NAN}), "unknown");
}

TEST(Phrases_behaviour, a_template_takes_its_texts_as_they_are) {
  EXPECT_EQ(say("{} of {}.", {"rolling", "a {} label"}), "rolling of a {} label.");
}

TEST(ResistanceAnswers_behaviour, name_the_length_that_moments_follow) {
  EXPECT_TRUE(says({answers(Study(scaled(true)).findings).headline}, "Length of rolling resistance: λ = a"));
  EXPECT_TRUE(says({answers(Study(nearer_the_particle_radius()).findings).headline},
                   "neither λ = r nor λ = a, of the two rather λ = r"));
  EXPECT_TRUE(says(answers(Study(two_close_loads()).findings).length, "not identifiable"));
}

TEST(ResistanceAnswers_behaviour, name_the_mechanism_of_a_trend) {
  const auto said = answers(Study(of_roughness(0.05, -0.2)).findings);
  EXPECT_TRUE(says(said.roughness, "The rise of sliding friction with roughness is due to slip."));
  EXPECT_TRUE(says(said.roughness,
                   "The dissipation by yielding falls with roughness; the resistance as a whole does not."));
}

TEST(ResistanceAnswers_behaviour, no_trend_is_said_with_its_uncertainty) {
  EXPECT_TRUE(says(answers(Study(of_roughness(0.001, 0.001, 1, 0.3)).findings).roughness,
                   "has no significant trend ("));
  const Study single({{"one", rolling(1e-4, 1e-13, 1)}, {"one", rolling(3e-4, 4e-13, 2)}});
  EXPECT_TRUE(says(answers(single.findings).roughness, "not identifiable"));
}

TEST(ResistanceAnswers_behaviour, say_what_adhesion_contributes_over_roughness) {
  EXPECT_TRUE(says(answers(Study(adhesion_over_roughness()).findings).mechanisms,
                   "The contribution of adhesion to rolling at 100 uN falls with roughness"));
}

TEST(ResistanceAnswers_behaviour, say_how_resistance_scales_with_an_input) {
  const auto said = answers(Study(varied_inputs()).findings).inputs;
  EXPECT_TRUE(
      says(said,
           "Rolling of half adhesion and full at 100 uN scales with the works of adhesion to the power 0.7"));
  EXPECT_TRUE(says(said, "(not significant)"));
}

/// Measured rolling at 200 uN over the three surfaces has no significant trend.
TEST(ResistanceAnswers_behaviour, do_not_say_that_a_trend_agrees_with_one_that_is_not_significant) {
  const Published published = read_published(paper_run("published"));
  const auto level = [](const MovingFolder& made, const auto&) { return 1e-3 * made.load * made.radius; };
  const Study study(on_the_papers_surfaces(published, "rolling", 2e-4, level), published);
  const auto sentences = answers(study.findings).measurement;
  EXPECT_TRUE(says(sentences, "agreement is not identifiable, for the measured trend is not significant"));
  EXPECT_FALSE(says(sentences, "per nm: they agree"));
}

TEST(ResistanceAnswers_behaviour, set_rolling_beside_the_mean_of_both_contacts) {
  const Published published = read_published(paper_run("published"));
  EXPECT_TRUE(says(answers(Study(between_wafer_and_indenter(published), published).findings).measurement,
                   "mean with the indenter's contact (diamond), over 100 uN to 3 mN, λ = r: µ "));
}

TEST(ResistanceAnswers_behaviour, say_what_a_finer_mesh_changes) {
  const auto said = answers(Study({{"1.5 nm", on_spacing(32e-9)},
                                   {"1.5 nm finer", on_spacing(16e-9)},
                                   {"2.7 nm", on_spacing(32e-9, 2.7)}})
                                .findings)
                        .mesh;
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(says(said, "on 16 nm instead of 32 nm")) << said.front();
}

TEST(ResistanceAnswers_behaviour, set_a_rail_beside_rolling_and_torsion_where_they_were_solved) {
  const Study study(rails_beside_separate_motions());
  const auto said = answers(study.findings).rails;
  ASSERT_EQ(said.size(), 2u);
  EXPECT_TRUE(says({said[0]}, "On a rail of 25 degrees, the contact, 100 uN across the flank")) << said[0];
  EXPECT_TRUE(says({said[0]}, "resists its spin with 0.8")) << said[0];
  const auto json = resistance_json(study.findings);
  EXPECT_NEAR(json["contacts"][0]["rails"][1]["over_sum"]["value"],
              study.findings.study.contacts[0].rails[1].over_sum().value, 1e-12);
  const auto alone = answers(Study({{"1.5 nm", on_rail(45 * degree)}}).findings).rails;
  ASSERT_EQ(alone.size(), 1u);
  EXPECT_FALSE(says(alone, "on their own")) << alone[0];
}

TEST(ResistanceFile_behaviour, files_hold_every_state_and_the_answers) {
  const Study study(of_roughness(0.05, -0.2));
  const std::string csv = resistance_csv(study.findings.study);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 3 * 2 * 3);
  const auto json = resistance_json(study.findings);
  EXPECT_EQ(json["format"], "asperity-resistance/1");
  EXPECT_EQ(json["contacts"].size(), 3u);
  EXPECT_FALSE(json["answers"]["roughness"].empty());
}

}  // namespace
}  // namespace asperity::report
