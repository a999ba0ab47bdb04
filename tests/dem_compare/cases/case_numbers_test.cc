#include "dem_compare/cases/case_numbers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/hertz.h"
#include "tests/dem_compare/derive/found.h"

namespace asperity {
namespace {

// Value = truth (1 + shift of the realisation + h): linear convergence.
CaseNumber number(double load, const std::string& realisation, double spacing, double shift) {
  return {load, realisation, spacing, 5 * load * (1 + shift + spacing), 0};
}

TEST(CaseNumbers_analytic, scatter_between_realisations_and_error_of_the_mesh_do_not_mix) {
  std::vector<CaseNumber> numbers;
  for (const double load : {1.0, 2.0})
    for (const auto& [name, shift] : {std::pair{"a", -0.1}, std::pair{"b", 0.0}, std::pair{"c", 0.1}})
      for (const double spacing : {0.01, 0.02}) numbers.push_back(number(load, name, spacing, shift));
  const auto scatter = realisation_scatter(numbers);
  ASSERT_TRUE(scatter);
  EXPECT_NEAR(scatter->relative, 0.1, 0.002);
  EXPECT_EQ(scatter->realisations, 3);
  const auto error = discretisation_error(numbers);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->families, 6);
  EXPECT_NEAR(error->relative_error, 0.01, 2e-4);
  const auto chosen = on_one_mesh(numbers);
  EXPECT_EQ(chosen.size(), 6u);
  for (const auto i : chosen) EXPECT_EQ(numbers[i].spacing, 0.01);
}

TEST(CaseNumbers_analytic, count_on_the_finest_mesh_that_all_contacts_have) {
  std::vector<CaseNumber> numbers;
  for (const double load : {1.0, 2.0, 4.0})
    for (const double spacing : {0.04, 0.01, 0.02})
      if (load == 2 || spacing > 0.01) numbers.push_back(number(load, "a", spacing, 0));
  const auto chosen = on_one_mesh(numbers);
  ASSERT_EQ(chosen.size(), 3u);
  for (const auto i : chosen) EXPECT_EQ(numbers[i].spacing, 0.02);
  // Of that mesh, not of the finest one, is the error.
  const auto error = discretisation_error(numbers);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->families, 3);
  EXPECT_NEAR(error->relative_error, 0.02 / 1.02, 1e-12);
  EXPECT_EQ(counted_of(numbers).size(), 3u);

  numbers.push_back(number(8, "a", 0.03, 0));
  numbers.push_back(number(8, "a", NAN, 0));
  const auto mixed = on_one_mesh(numbers);
  ASSERT_EQ(mixed.size(), 4u);
  EXPECT_EQ(numbers[mixed[1]].spacing, 0.01);
  EXPECT_EQ(numbers[mixed[3]].spacing, 0.03);
}

TEST(CaseNumbers_behaviour, of_one_realisation_on_one_mesh_know_neither) {
  const std::vector<CaseNumber> numbers{number(1, "a", 0.01, 0), number(2, "a", 0.01, 0)};
  EXPECT_FALSE(realisation_scatter(numbers));
  EXPECT_FALSE(discretisation_error(numbers));
}

TEST(PowerLaw_analytic, finds_stiffness_and_power_of_torsion_without_slip) {
  const Hertz hertz{52.87e9, 8.5e-6};
  std::vector<CaseNumber> numbers;
  for (const double load : {1e-4, 3e-4, 1e-3})
    numbers.push_back({load, "", 0, 2e9 * std::pow(hertz.contact_radius(load), 3), 0});
  const PowerLaw law = fit_power(
      numbers, [&](double load) { return hertz.contact_radius(load); }, 3);
  EXPECT_NEAR(law.value / (2e9 * std::pow(hertz.contact_radius(law.at_load), 3)), 1, 1e-12);
  EXPECT_NEAR(law.exponent, 3, 1e-9);
  EXPECT_NEAR(fit_power(
                  numbers, [&](double load) { return hertz.contact_radius(load); }, 1)
                  .exponent,
              3, 1e-9);
}

TEST(PowerLaw_analytic, knows_its_value_as_well_as_the_mean_over_cases) {
  const Hertz hertz{52.87e9, 8.5e-6};
  const auto radius = [&](double load) { return hertz.contact_radius(load); };
  // One load, stiffnesses of exp(-+0.1): their logarithms scatter by 0.1 sqrt(2), and their mean is known to
  // 0.1.
  EXPECT_NEAR(fit_power({{1e-3, "a", 0, std::exp(-0.1), 0}, {1e-3, "b", 0, std::exp(0.1), 0}}, radius, 1).sd,
              0.1, 1e-12);
  EXPECT_NEAR(fit_power({{1e-3, "a", 0, 2, 0.06}}, radius, 1).sd, 0.06, 1e-12);
}

/// Relative sample deviations of two loads, weighted with the values less one.
TEST(CaseNumbers_analytic, scatter_is_pooled_over_loads) {
  std::vector<CaseNumber> numbers;
  for (const double value : {1.0, 1.2}) numbers.push_back({1, std::to_string(value), 0.01, value, 0});
  for (const double value : {9.0, 10.0, 11.0}) numbers.push_back({2, std::to_string(value), 0.01, value, 0});
  numbers.push_back({3, "alone", 0.01, 5, 0});
  const auto scatter = realisation_scatter(numbers);
  ASSERT_TRUE(scatter);
  EXPECT_EQ(scatter->realisations, 3);
  const double first = 0.1 * std::sqrt(2.0) / 1.1, second = 0.1;
  EXPECT_NEAR(scatter->relative, std::sqrt((first * first + 2 * second * second) / 3), 1e-12);
}

TEST(CaseNumbers_behaviour, spacings_that_are_not_known_are_alike_and_like_no_other) {
  EXPECT_TRUE(same_spacing(NAN, NAN));
  EXPECT_FALSE(same_spacing(NAN, 0.01));
  EXPECT_FALSE(same_spacing(0.01, NAN));
  EXPECT_TRUE(same_spacing(1000, 1001));
  EXPECT_FALSE(same_spacing(1002, 1000));
}

/// Logarithms of the radii of -3, -1, 1 and 3, stiffnesses off a straight line by d, -d, -d and d.
std::vector<CaseNumber> about_a_line(double d) {
  std::vector<CaseNumber> numbers;
  for (const auto& [x, off] : {std::pair{-3, d}, std::pair{-1, -d}, std::pair{1, -d}, std::pair{3, d}})
    numbers.push_back({5 * std::exp(x), "", 0, 2 * std::exp(x + off), 0});
  return numbers;
}

TEST(PowerLaw_analytic, knows_its_exponent_as_well_as_a_straight_line_its_slope) {
  constexpr double d = 0.01;
  const auto radius = [](double load) { return load / 5; };
  auto numbers = about_a_line(d);
  const PowerLaw law = fit_power(numbers, radius, 1);
  EXPECT_NEAR(law.at_load, 5, 1e-12);  // the geometric mean
  EXPECT_NEAR(law.value, 2, 1e-12);
  EXPECT_NEAR(law.sd, 2 * std::sqrt(4 * d * d / 3) / 2, 1e-12);  // of the mean of four
  EXPECT_NEAR(law.exponent, 1, 1e-12);
  EXPECT_NEAR(law.exponent_sd, std::sqrt(4 * d * d / 2 / 20), 1e-12);  // two degrees of freedom; sum x^2 = 20
  EXPECT_DOUBLE_EQ(law.loads.low, 5 * std::exp(-3));
  EXPECT_DOUBLE_EQ(law.loads.high, 5 * std::exp(3));
  // What each case leaves open counts where it is more than the scatter.
  for (auto& number : numbers) number.sd = 0.05 * number.value;
  EXPECT_NEAR(fit_power(numbers, radius, 1).sd, 2 * 0.05, 1e-12);
  numbers.resize(2);
  EXPECT_TRUE(std::isnan(fit_power(numbers, radius, 1).exponent_sd));  // two points lie on a line
  EXPECT_NEAR(fit_power(numbers, radius, 1).exponent, 1 - d, 1e-12);
  numbers.resize(1);
  EXPECT_TRUE(std::isnan(fit_power(numbers, radius, 1).exponent));
}

TEST(LawFindings_behaviour, ask_for_other_seeds_of_rough_surfaces_alone) {
  using About = OpenQuestion::About;
  const auto told = [](const std::vector<CaseNumber>& numbers) {
    LawFindings findings;
    find_scatter_and_mesh(numbers, Derived::stiffness, findings);
    return findings;
  };
  const LawFindings smooth = told({{1, "smoothonsmooth", 0.01, 5, 0}});
  ASSERT_EQ(smooth.open.size(), 1u);
  EXPECT_EQ(smooth.open[0].about, About::mesh_error);
  const LawFindings rough = told({{1, "a", 0.01, 5, 0}});
  ASSERT_EQ(rough.open.size(), 2u);
  EXPECT_EQ(rough.open[0].about, About::scatter);
  EXPECT_EQ(rough.open[1].about, About::mesh_error);
  const LawFindings both = told(
      {{1, "a", 0.01, 5.05, 0}, {1, "a", 0.02, 5.1, 0}, {1, "b", 0.01, 6.06, 0}, {1, "b", 0.02, 6.12, 0}});
  EXPECT_TRUE(both.open.empty());
  EXPECT_NEAR(both.details["mesh_error"].get<double>(), 0.05 / 5.05, 1e-12);
  ASSERT_TRUE(test::found<MeshFact>(both));
  EXPECT_EQ(test::found<MeshFact>(both)->error.families, 2);
}

TEST(LengthChoice_behaviour, is_open_below_odds_of_twenty) {
  const auto told = [](double log_odds) {
    LengthChoice choice;
    choice.log_odds = log_odds;
    LawFindings findings;
    find_length(choice, findings);
    return findings;
  };
  EXPECT_TRUE(told(-std::log(50.0)).open.empty());
  EXPECT_EQ(told(std::log(19.0)).open.size(), 1u);
  LengthChoice choice;
  choice.log_odds = -std::log(19.0);
  EXPECT_EQ(choice.scale(), LengthScale::contact_radius);  // not told: as friction over the contact demands
  choice.log_odds = -std::log(21.0);
  EXPECT_EQ(choice.scale(), LengthScale::particle_radius);
}

}  // namespace
}  // namespace asperity
