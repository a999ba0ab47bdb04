// What derive found, in words.
#include "report/sentences/derivation_sentences.h"

#include <gtest/gtest.h>

#include <cmath>

#include "report/sentences/phrases.h"
#include "tests/dem_compare/resistance/moving_folder.h"
#include "tests/support/temporary_folder.h"

namespace asperity::report {
namespace {

using About = OpenQuestion::About;

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST(DerivationSentences_behaviour, numbers_have_their_error_and_their_unit) {
  const double unknown = std::nan("");
  EXPECT_EQ(quantity_text({0.25, 0.012}, ""), "0.250 ± 0.012");
  EXPECT_EQ(quantity_text({0.25, unknown}, ""), "0.25");
  EXPECT_EQ(quantity_text({460, 12}, ""), "460 ± 12");
  EXPECT_EQ(quantity_text({0.25, 0.012}, "rad"), "0.250 ± 0.012 rad");
  EXPECT_EQ(quantity_text({2.5e5, 1e4}, "N/m"), "250 ± 10 kN/m");
  EXPECT_EQ(quantity_text({3e-11, 1e-12}, "N m/rad"), "30.0 ± 1.0 pN m/rad");
  EXPECT_EQ(quantity_text({2.5e-12, unknown}, "N m"), "2.5 pN m");
  EXPECT_EQ(quantity_text({1.234e-3, 4.6e-5}, Dimension::force), "1.234 ± 0.046 mN");
  EXPECT_EQ(share_text(0.0123), "1.2 %");
  EXPECT_EQ(share_text(1.5), "150 %");
}

TEST(DerivationSentences_behaviour, say_how_many_cases_a_number_is_of) {
  EXPECT_EQ(extent_words({{1e-4, "a", 2e-8, 1, 0}, {1e-3, "b", 2e-8, 1, 0}}),
            "2 cases, load 100 uN to 1 mN, 2 realisations, spacing 20 nm");
  EXPECT_EQ(extent_words({{1e-4, "a", std::nan(""), 1, 0}}), "1 case, load 100 uN, 1 realisation");
  EXPECT_EQ(source_words({{1, "a", 0.01, 5.05, 0}, {1, "a", 0.02, 5.1, 0}}),
            "1 case, load 1 N, 1 realisation, spacing 10 mm; error of the mesh 0.99 %, not in the sd");
}

TEST(DerivationSentences_behaviour, say_scatter_and_mesh_apart) {
  EXPECT_EQ(
      words_of(Fact{MeshFact{Derived::stiffness, {0.0099, 2}}}),
      "error of the mesh (the stiffness): 0.99 %, mean of 2 contacts; not part of the uncertainty above");
  EXPECT_EQ(
      words_of({About::scatter, Derived::modulus}),
      "scatter of E* between realisations: solve the same case with two or more seeds of its roughness");
  EXPECT_EQ(words_of({About::mesh_error, Derived::normal_stiffness}),
            "error of the mesh in k_n: solve one case again with twice the Mesh/Interface spacing");
}

TEST(DerivationSentences_behaviour, say_odds_for_the_likelier_length) {
  const auto said = [](double log_odds) {
    LengthChoice choice;
    choice.log_odds = log_odds, choice.contact_error = std::nan("");
    return words_of(Fact{LengthFact{choice}});
  };
  EXPECT_EQ(said(std::log(50)), "odds 50 to 1 for lambda = a");
  EXPECT_EQ(said(-std::log(50)), "odds 50 to 1 for lambda = r");
  EXPECT_EQ(said(20), "odds more than 10^6 to 1 for lambda = a");
  EXPECT_EQ(said(-20), "odds more than 10^6 to 1 for lambda = r");
}

TEST(DerivationSentences_behaviour, name_yielding_and_what_would_tell) {
  EXPECT_SAYS(words_of(Fact{YieldFact{1, 8, 2.25e-3, 2e-20}}),
              "material yielded in 1 of 8 cases, seen first at 2.25 mN (plastic volume up to 0.02 um^3)");
  EXPECT_SAYS(words_of(Fact{RelaxationFact{2, 8}}), "bodies relax with time in 2 of 8 cases");
  ElastoplasticFact law;
  law.first = {50e9, 1e9}, law.second = {2.5e9, 0.1e9};
  law.at_load = 6e-3, law.good_from = 1e-3;
  law.numbers = {{6e-3, "a", 2e-8, 2.5e9, 1e8}};
  law.errors = {{6e-3, 0.03, 0.043, -0.116, 0.035}, {3e-3, 0.05, 0.1, 3.41, 0.2}};
  EXPECT_SAYS(
      words_of(Fact{law}),
      "Thornton & Ning 1998: E* = 50.0 ± 1.0 GPa, p_y = 2.50 ± 0.10 GPa; force of loading within 10 % "
      "from 1 mN to 6 mN");
  EXPECT_SAYS(words_of(Fact{law}), "from 3 mN: unloading stiffness +10 %, imprint 4.41 times");
  law.good_from = law.at_load;
  EXPECT_SAYS(words_of(Fact{law}), "nowhere within 10 % up to 6 mN");
  EXPECT_SAYS(words_of({About::offset}), "h: one load cannot part mu f from mu h");
  EXPECT_SAYS(words_of({About::length}), "the length lambda");
  EXPECT_EQ(words_of({About::long_paths, Derived::resistance, &sliding_mode(), 1.52}),
            "fluctuation over long paths: the shortest steady path is 1.5 contact diameters, two or more are "
            "wanted; set Experiment/Distance to more");
  EXPECT_SAYS(words_of({About::experiment, Derived::resistance, &rolling_mode()}),
              "there is no case with Experiment/Type = rolling");
  EXPECT_SAYS(words_of({About::stiffness}), "set Experiment/Reverse = true");
  EXPECT_EQ(words_of({About::stiffness}).find("Return distance"), std::string::npos);
  EXPECT_SAYS(words_of({About::rolling_stiffness}), "Experiment/Return distance");
}

TEST(DerivationSentences_behaviour, are_written_into_the_record_and_said) {
  const test::TemporaryFolder root;
  test::MovingFolder made;
  made.experiment = "rolling", made.friction = 1e-13, made.hills = 20, made.reverse = true;
  test::write_moving(root.path / "rolled", made);
  Derivation derivation = derive_parameters(reduced_set(collect_parameter_sets({root.path}).sets.front()));
  write_words(derivation);
  const ContactParameters& p = derivation.parameters;
  EXPECT_SAYS(p.title, "Derived from 1 solved case: sphere 8.5 um (E ");
  ASSERT_TRUE(p.rolling_friction && p.rolling_stiffness);
  EXPECT_SAYS(p.rolling_friction->provenance, "energy dissipated per angle by slip");
  EXPECT_SAYS(p.rolling_friction->provenance, "1 case, load ");
  EXPECT_SAYS(p.rolling_friction->provenance, "error of the mesh not known");
  EXPECT_SAYS(p.rolling_friction->provenance, "folders in derivation/cases");
  EXPECT_SAYS(p.rolling_stiffness->provenance, "of rolling back in a second pass");
  EXPECT_EQ(p.rolling_offset->provenance.find("one load cannot tell it"), 0u);
  const auto& law = p.derivation["rolling"];
  EXPECT_TRUE(law.contains("findings") && law.contains("not_told") && law.contains("length"));
  const std::string text = derivation_text(derivation);
  for (const auto& words : law["findings"]) EXPECT_SAYS(text, words.get<std::string>());
  for (const auto& words : law["not_told"])
    EXPECT_SAYS(text, "not identifiable: " + words.get<std::string>());
}

}  // namespace
}  // namespace asperity::report
