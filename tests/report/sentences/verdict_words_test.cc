#include "report/sentences/verdict_words.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::report {
namespace {

constexpr double uN = 1e-6;

std::string words(const std::vector<Departure>& departures) {
  return departure_words(departures, "stiffness", 0.05);
}

TEST(Verdict_behaviour, names_amount_uncertainty_and_the_loads_at_which_a_law_is_good_enough) {
  EXPECT_EQ(words({{100 * uN, 0.11, 0.02}, {200 * uN, 0.13, 0.02}, {400 * uN, 0.0, 0.02}}),
            "overstates the stiffness by 12 ± 2 % from 100 uN to 200 uN; within 5 % at 400 uN");
}

TEST(Verdict_behaviour, is_within_outside_or_not_known_by_its_interval) {
  EXPECT_EQ(words({{100 * uN, 0.01, 0.01}, {1e-3, -0.02, 0.01}}),
            "gives the stiffness within 5 % from 100 uN to 1 mN");
  EXPECT_EQ(words({{100 * uN, 0.01, NAN}}), "gives the stiffness within 5 % at 100 uN");
  EXPECT_EQ(words({{100 * uN, 0.01, 0.03}}),
            "may or may not give the stiffness within 5 % at 100 uN (too much by 1.0 ± 3.0 %)");
  EXPECT_EQ(words({{100 * uN, 0.2, 0.03}, {200 * uN, 0.06, 0.02}}),
            "overstates the stiffness by 20 ± 3 % at 100 uN; whether within 5 % is not known at 200 uN (too "
            "much by 6.0 ± 2.0 %)");
  EXPECT_EQ(words({{100 * uN, -0.01, 0.001, 0.06}}),
            "may or may not give the stiffness within 5 % at 100 uN (too little by 1.0 ± 0.1 %, and 6.0 % "
            "from the mesh)");
}

TEST(Verdict_behaviour, does_not_call_five_per_cent_more_than_five_per_cent) {
  EXPECT_EQ(words({{20.4 * uN, -0.0503, NAN}, {20.5 * uN, -0.0497, NAN}}),
            "understates the stiffness by 5.03 % at 20.4 uN; within 5 % at 20.5 uN");
}

TEST(Verdict_behaviour, gives_both_ends_where_the_departure_changes_with_load) {
  EXPECT_EQ(words({{100 * uN, -0.40, 0.03}, {400 * uN, -0.10, 0.02}}),
            "understates the stiffness by 40 ± 3 % at 100 uN and 10 ± 2 % at 400 uN");
  EXPECT_EQ(words({{100 * uN, -0.40, NAN}, {200 * uN, -0.10, NAN}, {400 * uN, 0.0, NAN}}),
            "understates the stiffness from 100 uN to 200 uN, by 40 % at 100 uN and 10 % at 200 uN; within 5 "
            "% at 400 uN");
}

TEST(Verdict_behaviour, speaks_of_factors_beyond_two) {
  EXPECT_EQ(words({{100 * uN, 8.75, NAN}}), "overstates the stiffness by a factor of 9.75 at 100 uN");
  EXPECT_EQ(words({{100 * uN, -0.9, NAN}}), "understates the stiffness by a factor of 10 at 100 uN");
  // The sd of 1/0.1 is 0.001/0.1^2.
  EXPECT_EQ(words({{100 * uN, -0.9, 0.001}}), "understates the stiffness by a factor of 10 ± 0.1 at 100 uN");
  EXPECT_EQ(words({{100 * uN, 119, 13}}), "overstates the stiffness by a factor of 120 ± 13 at 100 uN");
}

TEST(Verdict_behaviour, says_nothing_of_loads_between_too_much_and_too_little) {
  const std::vector<Departure> departures{{100 * uN, -0.2, NAN}, {400 * uN, 0.2, NAN}};
  EXPECT_EQ(words(departures),
            "understates the stiffness by 20 % at 100 uN; overstates it by 20 % at 400 uN");
  EXPECT_TRUE(good_ranges(departures, 0.05).empty());
}

TEST(Verdict_behaviour, tells_where_a_law_is_good_enough_from_where_nobody_looked) {
  LawVerdict verdict;
  verdict.compared = {100 * uN, 1e-3};
  EXPECT_EQ(good_words(verdict), "at no load compared (100 uN to 1 mN)");
  verdict.good = good_ranges({{100 * uN, 0, NAN}, {1e-3, 0.01, NAN}}, 0.05);
  EXPECT_EQ(good_words(verdict), "at all loads compared (100 uN to 1 mN)");
  verdict.good = good_ranges({{100 * uN, 0.1, NAN}, {316 * uN, 0.0, NAN}, {1e-3, 0.0, NAN}}, 0.05);
  EXPECT_EQ(good_words(verdict), "from 316 uN on (compared: 100 uN to 1 mN)");
  verdict.good.clear();
  verdict.not_known = 2;
  EXPECT_EQ(good_words(verdict), "not known at any load compared (100 uN to 1 mN)");
  verdict.not_known = 0;
  verdict.good = good_ranges({{1e-3, 0.0, NAN}}, 0.05);
  verdict.compared = {1e-3, 1e-3};
  EXPECT_EQ(good_words(verdict), "at 1 mN, the only load compared");
}

ComparisonRow row(double load, double finite_elements, double law, double published) {
  ComparisonRow row;
  row.contact = "contact";
  row.quantity = Quantity::lateral_stiffness;
  row.load = load;
  row.finite_elements.value = finite_elements;
  row.finite_elements.sd = 0.03 * finite_elements;
  row.reduced_law = {law, NAN, "The no-slip law", ""};
  row.published = {published, NAN, "there", ""};
  return row;
}

TEST(Verdict_behaviour, is_given_against_finite_elements_and_against_the_measurement) {
  const auto found = verdicts({row(100 * uN, 1, 1.12, 0.5), row(200 * uN, 1, 1.12, NAN)}, 0.05);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(verdict_text(found[0], 0.05),
            "The no-slip law overstates the lateral stiffness from rest of the finite elements by 12 ± 3 % "
            "from 100 uN to 200 uN.");
  EXPECT_EQ(verdict_text(found[1], 0.05),
            "The no-slip law overstates the lateral stiffness from rest of the measurement by a factor of "
            "2.24 at 100 uN. How far "
            "it is uncertain is not known.");
  EXPECT_EQ(verdict_text(found[2], 0.05),
            "The finite-element model overstates the lateral stiffness from rest of the measurement by 100 ± "
            "6 % at 100 uN.");
  EXPECT_TRUE(found[0].good.empty());
}

TEST(Verdict_behaviour, does_not_praise_a_law_for_the_measurement_it_was_fitted_to) {
  const auto found = verdicts({row(100 * uN, NAN, 0.5, 0.5)}, 0.05);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].is_own_fit);
  EXPECT_EQ(verdict_text(found[0], 0.05),
            "The no-slip law repeats the lateral stiffness from rest of the measurement: its numbers were "
            "fitted to it.");
  EXPECT_EQ(good_words(found[0]), "its numbers were fitted to it");
}

TEST(Verdict_behaviour, says_where_the_mesh_alone_is_worth_more_than_the_tolerance) {
  ComparisonRow coarse = row(100 * uN, 1, 1.02, NAN);
  coarse.finite_elements.sd = 0.001;
  coarse.finite_elements.mesh_error = -0.08;
  const std::string text = verdict_text(verdicts({coarse}, 0.05).front(), 0.05);
  EXPECT_NE(
      text.find(
          "may or may not give the lateral stiffness from rest of the finite elements within 5 % at 100 uN"),
      std::string::npos)
      << text;
  EXPECT_NE(text.find("The mesh alone leaves 8.0 % in doubt at 100 uN."), std::string::npos) << text;
  coarse.finite_elements.mesh_error = 0.01;
  EXPECT_EQ(
      verdict_text(verdicts({coarse}, 0.05).front(), 0.05),
      "The no-slip law gives the lateral stiffness from rest of the finite elements within 5 % at 100 uN.");
}

TEST(Verdict_behaviour, of_one_row_prefers_finite_elements) {
  EXPECT_EQ(row_verdict_text(row(100 * uN, 1, 1.12, 0.5), 0.05),
            "overstates by 12 ± 3 % against finite elements");
  EXPECT_EQ(row_verdict_text(row(100 * uN, NAN, 0.49, 0.5), 0.05), "good within 5 % against the measurement");
  EXPECT_EQ(row_verdict_text(row(100 * uN, NAN, 0.49, NAN), 0.05), "");
}

}  // namespace
}  // namespace asperity::report
