#include "dem_compare/compare/verdict.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

constexpr double uN = 1e-6;

std::string words(const std::vector<Departure>& departures) { return departure_words(departures, "stiffness", 0.05); }

TEST(Verdict, names_amount_uncertainty_and_the_load_where_a_law_gets_good_enough) {
  // 13 % at 200 uN and 0 % at 400 uN: 5 % lies at 200 * 2^(8/13) = 306 uN.
  EXPECT_EQ(words({{100 * uN, 0.11, 0.03}, {200 * uN, 0.13, 0.03}, {400 * uN, 0.0, 0.03}}),
            "overstates the stiffness by 12 ± 3 % below 306 uN; within 5 % above 306 uN");
}

TEST(Verdict, says_within_the_tolerance_where_it_is) {
  EXPECT_EQ(words({{100 * uN, 0.01, 0.03}, {1e-3, -0.04, 0.03}}), "gives the stiffness within 5 % from 100 uN to 1 mN");
  EXPECT_EQ(words({{100 * uN, 0.01, NAN}}), "gives the stiffness within 5 % at 100 uN");
}

TEST(Verdict, gives_both_ends_where_the_departure_changes_with_load) {
  EXPECT_EQ(words({{100 * uN, -0.40, 0.03}, {400 * uN, -0.10, 0.02}}),
            "understates the stiffness by 40 ± 3 % at 100 uN and 10 ± 2 % at 400 uN");
  EXPECT_EQ(words({{100 * uN, -0.40, NAN}, {200 * uN, -0.10, NAN}, {400 * uN, 0.0, NAN}}),
            "understates the stiffness below 283 uN, by 40 % at 100 uN and 10 % at 200 uN; within 5 % above 283 uN");
}

TEST(Verdict, speaks_of_factors_beyond_two) {
  EXPECT_EQ(words({{100 * uN, 8.75, NAN}}), "overstates the stiffness by a factor of 9.75 at 100 uN");
  EXPECT_EQ(words({{100 * uN, -0.9, NAN}}), "understates the stiffness by a factor of 10 at 100 uN");
  // The sd of 1/0.1 is 0.001/0.1^2.
  EXPECT_EQ(words({{100 * uN, -0.9, 0.001}}), "understates the stiffness by a factor of 10 ± 0.1 at 100 uN");
  EXPECT_EQ(words({{100 * uN, 119, 13}}), "overstates the stiffness by a factor of 120 ± 13 at 100 uN");
}

TEST(Verdict, admits_that_a_departure_is_not_told_from_its_uncertainty) {
  EXPECT_EQ(words({{100 * uN, 0.08, 0.1}}),
            "overstates the stiffness by 8 ± 10 % at 100 uN (less than two standard deviations)");
}

TEST(Verdict, finds_the_loads_between_too_much_and_too_little) {
  // -20 % at 100 uN, +20 % at 400 uN: zero at 200 uN, 5 % away from it at 200 * 2^(-+1/4).
  const std::vector<Departure> departures{{100 * uN, -0.2, NAN}, {400 * uN, 0.2, NAN}};
  EXPECT_EQ(
      words(departures),
      "understates the stiffness by 20 % below 168 uN; within 5 % from 168 uN to 238 uN; overstates it by 20 % above 238 uN");
  const std::vector<GoodRange> good = good_ranges(departures, 0.05);
  ASSERT_EQ(good.size(), 1u);
  EXPECT_NEAR(good[0].low, 200 * uN * std::pow(2, -0.25), 1e-9);
  EXPECT_NEAR(good[0].high, 200 * uN * std::pow(2, 0.25), 1e-9);
  EXPECT_FALSE(good[0].reaches_lowest || good[0].reaches_highest);
}

TEST(Verdict, tells_where_a_law_is_good_enough_from_where_nobody_looked) {
  LawVerdict verdict;
  verdict.compared = {100 * uN, 1e-3};
  EXPECT_EQ(good_words(verdict), "at no load compared (100 uN to 1 mN)");
  verdict.good = good_ranges({{100 * uN, 0, NAN}, {1e-3, 0.01, NAN}}, 0.05);
  EXPECT_EQ(good_words(verdict), "at all loads compared (100 uN to 1 mN)");
  verdict.good = good_ranges({{100 * uN, 0.1, NAN}, {1e-3, 0.0, NAN}}, 0.05);
  EXPECT_EQ(good_words(verdict), "from 316 uN on (compared: 100 uN to 1 mN)");
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

TEST(Verdict, is_given_against_finite_elements_and_against_the_measurement) {
  const auto found = verdicts({row(100 * uN, 1, 1.12, 0.5), row(200 * uN, 1, 1.12, NAN)}, 0.05);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(
      found[0].text,
      "The no-slip law overstates the lateral stiffness from rest of the finite elements by 12 ± 3 % from 100 uN to 200 uN.");
  EXPECT_EQ(found[1].text,
            "The no-slip law overstates the lateral stiffness from rest of the measurement by a factor of 2.24 at 100 uN.");
  EXPECT_EQ(found[2].text,
            "The finite-element model overstates the lateral stiffness from rest of the measurement by 100 ± 6 % at 100 uN.");
  EXPECT_TRUE(found[0].good.empty());
}

TEST(Verdict, does_not_praise_a_law_for_the_measurement_it_was_fitted_to) {
  const auto found = verdicts({row(100 * uN, NAN, 0.5, 0.5)}, 0.05);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].is_own_fit);
  EXPECT_EQ(found[0].text,
            "The no-slip law repeats the lateral stiffness from rest of the measurement: its numbers were fitted to it.");
  EXPECT_EQ(good_words(found[0]), "its numbers were fitted to it");
}

TEST(Verdict, says_where_the_mesh_alone_is_worth_more_than_the_tolerance) {
  ComparisonRow coarse = row(100 * uN, 1, 1.02, NAN);
  coarse.finite_elements.mesh_error = -0.08;
  EXPECT_EQ(verdicts({coarse}, 0.05).front().text,
            "The no-slip law gives the lateral stiffness from rest of the finite elements within 5 % at 100 uN. The mesh alone "
            "leaves "
            "8.0 % in doubt at 100 uN.");
  coarse.finite_elements.mesh_error = 0.03;
  EXPECT_EQ(verdicts({coarse}, 0.05).front().text.find("mesh"), std::string::npos);
}

TEST(Verdict, of_one_row_prefers_finite_elements) {
  EXPECT_EQ(row_verdict(row(100 * uN, 1, 1.12, 0.5), 0.05), "overstates by 12 ± 3 % against finite elements");
  EXPECT_EQ(row_verdict(row(100 * uN, NAN, 0.49, 0.5), 0.05), "good within 5 % against the measurement");
  EXPECT_EQ(row_verdict(row(100 * uN, NAN, 0.49, NAN), 0.05), "");
}

}  // namespace
}  // namespace asperity
