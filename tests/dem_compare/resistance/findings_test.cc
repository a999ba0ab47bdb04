// Studies made from known laws: the answers must be those that went in, and none
// where too little did.
#include "dem_compare/resistance/findings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/dem_compare/resistance/known_studies.h"
#include "tests/support/verification.h"

namespace asperity {
namespace {

using namespace test;
using Verdict = LengthAnswer::Verdict;

TEST(LengthScale_analytic, moments_that_follow_the_contact_radius_are_told_to) {
  const Study study(scaled(true));
  ASSERT_EQ(study.findings.lengths.size(), 1u);
  const LengthAnswer& answer = study.findings.lengths.front();
  EXPECT_EQ(answer.verdict, Verdict::contact_radius);
  EXPECT_EQ(answer.radii.size(), 3u);
  ASSERT_EQ(answer.exponents.size(), 6u);  // three radii over load, three loads over radius
  for (const auto& exponent : answer.exponents) {
    EXPECT_LT(std::abs(exponent.from_contact()), 3) << exponent.over << " " << exponent.what;
    EXPECT_GT(std::abs(exponent.from_radius()), 3) << exponent.over << " " << exponent.what;
  }
}

TEST(LengthScale_analytic, moments_that_follow_the_particle_radius_are_told_to) {
  const Study study(scaled(false));
  ASSERT_EQ(study.findings.lengths.size(), 1u);
  EXPECT_EQ(study.findings.lengths.front().verdict, Verdict::particle_radius);
}

TEST(LengthScale_analytic, moments_that_follow_neither_are_not_pressed_into_one) {
  auto entries = scaled(true);
  for (auto& entry : entries) {  // M ~ P^(5/3) R^(2/3)
    const double moment = 1e-3 * entry.made.load * std::pow(entry.made.contact_radius(), 2) / 1e-7;
    entry.made.friction = 0.6 * moment, entry.made.plastic = 0.4 * moment;
  }
  EXPECT_EQ(Study(entries).findings.lengths.front().verdict, Verdict::neither);
}

TEST(LengthScale_analytic, of_a_length_that_is_neither_the_better_one_is_named) {
  const Study study(nearer_the_particle_radius());
  EXPECT_EQ(study.findings.lengths.front().verdict, Verdict::neither);
}

TEST(LengthScale_analytic, bonds_along_a_smooth_rim_are_neither_and_known_by_their_exponents) {
  auto entries = scaled(true);
  for (auto& entry : entries) {
    entry.made.friction = entry.made.plastic = 0;
    entry.made.adhesion = 0.077 * 2 * entry.made.contact_radius() * entry.made.radius;
    entry.made.work_of_adhesion = "77 mJ/m^2";
  }
  const LengthAnswer answer = std::move(Study(entries).findings.lengths.front());
  EXPECT_EQ(answer.verdict, Verdict::neither);
  for (const auto& exponent : answer.exponents)
    EXPECT_LT(std::abs(exponent.from_bonds()), 3) << exponent.over << " " << exponent.what;
}

TEST(LengthScale_analytic, two_loads_close_together_cannot_tell) {
  const Study study(two_close_loads());
  ASSERT_EQ(study.findings.lengths.size(), 1u);
  EXPECT_EQ(study.findings.lengths.front().verdict, Verdict::cannot_tell);
}

TEST(LengthScale_analytic, an_offset_does_not_pass_for_another_length) {
  // M = mu a (P + h) with h of a third of the middle load: exponents in the load are far from 4/3, the law is
  // lambda = a all the same.
  auto entries = scaled(true);
  for (auto& entry : entries) {
    const double moment = 1e-3 * (entry.made.load + 3e-5) * entry.made.contact_radius();
    entry.made.friction = 0.6 * moment, entry.made.plastic = 0.4 * moment;
  }
  const LengthAnswer answer = std::move(Study(entries).findings.lengths.front());
  EXPECT_EQ(answer.verdict, Verdict::contact_radius);
  EXPECT_GT(std::abs(answer.exponents.front().from_contact()), 3);
  EXPECT_NEAR(answer.choice->with_contact.offset, 3e-5, 3 * answer.choice->with_contact.offset_sd());
}

TEST(ResistanceTrend_analytic, slopes_come_back_with_their_mechanism) {
  const Study study(of_roughness(0.05, -0.2));
  ASSERT_EQ(study.findings.trends.size(), 2u);
  for (const auto& trend : study.findings.trends) {
    ASSERT_EQ(trend.loads.size(), 3u);
    for (const auto& at : trend.loads) {
      const double scale = 1 / nm;
      EXPECT_NEAR(at.friction.slope.value / scale, 0.2 * 0.05, 3 * at.friction.slope.sd / scale);
      EXPECT_NEAR(at.plastic.slope.value / scale, -0.02 * 0.2, 3 * at.plastic.slope.sd / scale);
      EXPECT_EQ(at.plastic.sign(), Trend::Sign::falls);
    }
    // (0.2 0.05 - 0.02 0.2)/0.22 = 2.7 % per nm
    EXPECT_NEAR(trend.relative.value * nm, 0.0273, 3 * trend.relative.sd * nm);
    EXPECT_EQ(trend.sign(), Trend::Sign::rises);
  }
}

TEST(ResistanceTrend_analytic, no_trend_is_said_with_its_bound) {
  const Study study(of_roughness(0, 0));
  for (const auto& trend : study.findings.trends)
    EXPECT_LT(std::abs(trend.relative.value), 3 * trend.relative.sd);
  const Study noisy(of_roughness(0.001, 0.001, 1, 0.3));
  EXPECT_EQ(noisy.findings.trends.front().sign(), Trend::Sign::none);
}

TEST(ResistanceTrend_analytic, scatter_that_a_realisation_has_on_all_surfaces_does_not_hide_the_trend) {
  const Study study(of_roughness(0.03, 0.03, 2));
  for (const auto& trend : study.findings.trends) {
    EXPECT_EQ(trend.sign(), Trend::Sign::rises);
    for (const auto* contact : trend.contacts) EXPECT_EQ(contact->states.front().cases.size(), 2u);
  }
}

TEST(ResistanceTrend_analytic, a_single_roughness_tells_no_trend) {
  const Study study({{"one", rolling(1e-4, 1e-13, 1)}, {"one", rolling(3e-4, 4e-13, 2)}});
  EXPECT_TRUE(study.findings.trends.empty());
}

TEST(ResistanceContribution_analytic, a_mechanism_switched_off_shows_what_it_contributes) {
  std::vector<StudyEntry> entries;
  MovingFolder full;
  full.friction = 20e-6, full.plastic = 5e-6, full.adhesion = 2e-6, full.noise = 0.03,
  full.work_of_adhesion = "77 mJ/m^2";
  MovingFolder elastic = full, dry = full;
  elastic.plastic = 0, elastic.yield_stress = "inf", elastic.random = 2;
  dry.adhesion = 0, dry.friction = 19e-6, dry.work_of_adhesion = "0 J/m^2", dry.random = 3;
  const Study study({{"full", full}, {"elastic", elastic}, {"without adhesion", dry}});
  ASSERT_EQ(study.findings.contributions.size(), 2u);
  for (const auto& one : study.findings.contributions) {
    const bool yielding = one.mechanism == Contribution::Mechanism::yielding;
    EXPECT_EQ(one.without->label, yielding ? "elastic" : "without adhesion");
    EXPECT_TRUE(one.is_told());
    EXPECT_NEAR(one.difference.value, yielding ? 5e-6 : 3e-6, 3 * one.difference.sd);
    EXPECT_NEAR(one.share().value, (yielding ? 5. : 3.) / 27, 3 * one.share().sd);
  }
}

TEST(ResistanceContribution_analytic, a_body_that_relaxes_is_not_said_to_yield) {
  MovingFolder relaxing;
  relaxing.friction = 20e-6, relaxing.plastic = 5e-6, relaxing.noise = 0.03, relaxing.yield_stress = "inf",
  relaxing.relaxing_share = 0.4;
  MovingFolder elastic = relaxing;
  elastic.plastic = 0, elastic.relaxing_share = 0, elastic.random = 2;
  const Study study({{"relaxing", relaxing}, {"elastic", elastic}});
  ASSERT_EQ(study.findings.contributions.size(), 1u);
  const Contribution& one = study.findings.contributions.front();
  EXPECT_STREQ(name_of(one.mechanism), "relaxation");
  EXPECT_NEAR(one.difference.value, 5e-6, 3 * one.difference.sd);
  EXPECT_FALSE(one.with->can_yield);
}

TEST(ResistanceContribution_analytic, what_adhesion_contributes_is_followed_over_roughness) {
  const Study study(adhesion_over_roughness());
  ASSERT_EQ(study.findings.contribution_trends.size(), 1u);
  const ContributionTrend& trend = study.findings.contribution_trends.front();
  // -0.2e-13 per nm over the mean of 1.94e-13 and 1.46e-13
  EXPECT_NEAR(trend.relative().value * nm, -0.2 / 1.7, 3 * trend.relative().sd * nm);
  EXPECT_EQ(trend.difference.sign(), Trend::Sign::falls);
  EXPECT_EQ(study.findings.trends.size(), 2u);  // with and without
}

InputExponent power_of(const Study& study, const std::string& input, const std::string& smaller) {
  for (const auto& one : study.findings.inputs)
    if (one.input == input && one.smaller->label == smaller && one.larger->label == "full") return one;
  ADD_FAILURE() << input;
  return InputExponent{};
}

TEST(ResistanceInput_analytic, powers_of_what_was_put_in_come_back) {
  constexpr unsigned draws = 30;
  int within = 0, all = 0;
  for (unsigned draw = 0; draw < draws; ++draw) {
    const Study study(varied_inputs(draw));
    // Beside each other: full and each half, and both beside its two halves.
    ASSERT_EQ(study.findings.inputs.size(), 5u);
    const InputExponent friction = power_of(study, "local friction", "half friction"),
                        adhesion = power_of(study, "works of adhesion", "half adhesion"),
                        yield = power_of(study, "yield stresses", "half yield");
    EXPECT_NEAR(friction.factor, 2, 1e-12);
    EXPECT_LT(adhesion.exponent.sd, 0.05);
    for (const auto& [found, put_in] : {std::pair{friction, 0.0}, std::pair{adhesion, std::log2(24. / 14)},
                                        std::pair{yield, std::log2(24. / 30)}}) {
      within += std::abs(found.exponent.value - put_in) < 2 * found.exponent.sd ? 1 : 0;
      ++all;
    }
    // Inputs are not mechanisms that were switched off.
    EXPECT_TRUE(study.findings.contributions.empty());
  }
  EXPECT_TRUE((test::Verified{
      "Reduced laws", "powers of what was put in: within two stated sd, share of 90 draws", "Gauss: 0.954"}
                   .between(double(within) / all, 0.954 - 0.05, 1)));
}

TEST(ResistancePublished_other_code, trends_and_magnitudes_stand_beside_table_2) {
  // Sliding of the paper's contact with the paper's own numbers at 100 uN: they must agree; rolling with the
  // wrong sign must not.
  const Published published = read_published(paper_run("published"));
  auto entries =
      on_the_papers_surfaces(published, "sliding", 1e-4, [](const MovingFolder& made, const auto& surface) {
        return surface.sliding.value * (made.load + surface.sliding_offset.value);
      });
  const auto rolling =
      on_the_papers_surfaces(published, "rolling", 1e-4, [](const MovingFolder& made, const auto&) {
        return 1e-3 * made.load * made.radius * (1 - 0.2 * made.rms);
      });
  entries.insert(entries.end(), rolling.begin(), rolling.end());
  const Study study(entries, published);
  int sliding = 0, rolls = 0;
  for (const auto& one : study.findings.published.magnitudes) {
    if (one.mode != &sliding_mode()) continue;
    ++sliding;
    EXPECT_NEAR(one.over().value, 1, 0.02) << one.contact->label;
    EXPECT_LT(std::abs(one.sigmas()), 2) << one.contact->label;
  }
  EXPECT_EQ(sliding, 3);
  for (const auto& one : study.findings.published.trends)
    if (one.trend->mode == &rolling_mode()) {
      ++rolls;
      // At 100 uN the measured resistance rises with roughness, by its offset h; only its coefficient falls.
      EXPECT_GT(one.measured.value, 0);
      EXPECT_LT(one.simulated.value, 0);
    } else {
      EXPECT_LT(std::abs(one.sigmas()), 2);
    }
  EXPECT_EQ(rolls, 1);
}

/// The paper's sphere rolls between wafer and indenter: halves that differ, whose mean is the measured number
/// at each load.
TEST(ResistancePublished_other_code, rolling_is_set_beside_the_mean_of_both_contacts) {
  const Published published = read_published(paper_run("published"));
  const Study study(between_wafer_and_indenter(published), published);
  ASSERT_EQ(study.findings.published.magnitudes.size(), 9u);
  for (const auto& one : study.findings.published.magnitudes) {
    ASSERT_TRUE(one.indenter);
    EXPECT_EQ(one.indenter->label, "diamond");
    EXPECT_NEAR(one.over().value, 1, 0.02) << one.contact->label;
  }
  ASSERT_EQ(study.findings.published.laws.size(), 3u);
  for (const auto& law : study.findings.published.laws) {
    EXPECT_NEAR(law.simulated.coefficient.value / law.coefficient.value, 1, 0.03) << law.contact->label;
    EXPECT_NEAR(law.simulated.offset.value / law.offset.value, 1, 0.05) << law.contact->label;
  }
  for (const auto& remark : study.findings.published.remarks)
    EXPECT_EQ(remark.find("rolling"), std::string::npos) << remark;
}

TEST(ResistanceStudy_behaviour, coarser_meshes_do_not_count_as_realisations) {
  MovingFolder fine, coarse;
  coarse.spacing = 2e-8, coarse.friction = 30e-6;
  const Study study({{"one", coarse}, {"one", fine}, {"one", coarse}});
  ASSERT_EQ(study.findings.study.contacts.size(), 1u);
  const auto& state = study.findings.study.contacts.front().states.front();
  EXPECT_EQ(state.cases.size(), 1u);
  EXPECT_NEAR(state.resistance.value / fine.friction, 1, 1e-6);
}

TEST(ResistanceStudy_behaviour, loads_named_among_the_variants_belong_to_one_contact) {
  MovingFolder first, heavier, rougher;
  heavier.load = 3e-4, rougher.rms = 2.7;
  const Study study({{"1.5 nm", first}, {"2.7 nm", rougher}, {"1.5 nm 300 uN", heavier}});
  const auto& contacts = study.findings.study.contacts;
  ASSERT_EQ(contacts.size(), 2u);
  EXPECT_EQ(contacts[0].label, "1.5 nm");  // neither motion nor load is part of it
  EXPECT_EQ(contacts[1].label, "2.7 nm");
  EXPECT_EQ(contacts[0].states.size(), 2u);
}

TEST(ResistanceStudy_behaviour, a_contact_goes_by_what_its_cases_labels_have_in_common) {
  MovingFolder first, heavier, rougher;
  heavier.load = 3e-4, rougher.rms = 2.7;
  const Study study(
      {{"1.5 nm long waves 100 uN", first}, {"1.5 nm long waves 300 uN", heavier}, {"2.7 nm", rougher}});
  ASSERT_EQ(study.findings.study.contacts.size(), 2u);
  EXPECT_EQ(study.findings.study.contacts[0].label, "1.5 nm long waves");
}

TEST(ResistanceStudy_behaviour, a_realisation_written_in_other_units_is_the_same_contact) {
  MovingFolder first, second;
  first.rms = 0.7, second.rms = 0.7, second.seed = 1001;
  const Study study({{"one", first}, {"one", second}});
  const std::string file = (study.root.path / "case2" / "case.prm").string();
  std::string text = read_file(file);
  text.replace(text.rfind("rms=0.7 nm"), 10, "rms=700 pm");
  write_file_atomically(file, text);
  const auto findings =
      find_resistances(collect_cases({study.root.path / "case1", study.root.path / "case2"}));
  ASSERT_EQ(findings.study.contacts.size(), 1u);
  EXPECT_EQ(findings.study.contacts.front().states.front().cases.size(), 2u);
}

TEST(ResistanceStudy_behaviour, cases_that_were_only_pressed_are_passed_over) {
  MovingFolder pressed;
  pressed.experiment = "normal";
  EXPECT_TRUE(Study({{"one", pressed}}).findings.empty());
}

}  // namespace
}  // namespace asperity
