// Ways over the same surfaces: what both meet drops out, what each has for itself stays in the uncertainty.
#include "dem_compare/resistance/paired_paths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "dem_compare/cases/path_averages.h"
#include "tests/support/verification.h"

namespace asperity {
namespace {

constexpr double step = 0.05, stretch = 1, correlation = 0.25;

/// Powers along a way, a row each step; slip takes four fifths of it, bonds the rest.
SteadyPath path_of(const std::vector<double>& powers, double begin = 0, int direction = 1) {
  EnergyHistory history;
  history.has_energies = true;
  double place = begin, friction = 0, adhesion = 0;
  for (const double power : powers) {
    history.position.push_back(place), history.resistance.push_back(direction * power);
    history.friction.push_back(friction), history.adhesion.push_back(adhesion), history.plastic.push_back(0);
    history.unbalanced.push_back(0);
    place += direction * step, friction += 0.8 * power * step, adhesion += 0.2 * power * step;
  }
  return steady_path(history, 0, powers.size() - 1, stretch);
}

/// Around 1, correlated over a quarter of a stretch.
std::vector<double> noise(std::mt19937& random, double size, int radii = 6) {
  std::normal_distribution<double> normal;
  const double memory = std::exp(-step / correlation);
  double value = normal(random);
  std::vector<double> powers;
  for (int i = 0; i <= std::lround(radii / step); ++i) {
    value = memory * value + std::sqrt(1 - memory * memory) * normal(random);
    powers.push_back(1 + size * value);
  }
  return powers;
}

std::vector<double> times(std::vector<double> powers, double factor) {
  for (double& power : powers) power *= factor;
  return powers;
}

TEST(PairedWays_analytic, what_both_meet_drops_out) {
  std::mt19937 random(3);
  const auto powers = noise(random, 0.3);
  const SteadyPath one = path_of(times(powers, 1.1)), other = path_of(powers);
  const Uncertain over = paired_ratio(one, other);
  EXPECT_NEAR(over.value, 1.1, 1e-9);
  EXPECT_LT(over.sd, 1e-9);
  EXPECT_GT(ratio(one.resistance(), other.resistance()).sd, 0.02);
  const Uncertain less = paired_difference(one, other, DissipationPart::friction);
  EXPECT_NEAR(less.value / (0.1 * other.dissipated.friction.value), 1, 1e-9);
  EXPECT_LT(less.sd, 0.2 * (one.dissipated.friction - other.dissipated.friction).sd);
}

TEST(PairedWays_analytic, two_sds_hold_the_truth_19_times_in_20) {
  std::mt19937 random(5);
  constexpr int draws = 1000;
  int ratios = 0, differences = 0;
  for (int i = 0; i < draws; ++i) {
    const auto common = noise(random, 0.3), own = noise(random, 0.05), others = noise(random, 0.05);
    std::vector<double> a, b;
    for (std::size_t k = 0; k < common.size(); ++k)
      a.push_back(0.9 * (common[k] + own[k] - 1)), b.push_back(common[k] + others[k] - 1);
    const SteadyPath one = path_of(a), other = path_of(b);
    const Uncertain over = paired_ratio(one, other),
                    less = paired_difference(one, other, DissipationPart::total);
    ratios += std::abs(over.value - 0.9) < 2 * over.sd;
    differences += std::abs(less.value + 0.1) < 2 * less.sd;
  }
  // Six stretches: their autocorrelation is itself uncertain (0.935 here; 0.90 if features were twice as
  // long).
  const auto verified = [](const std::string& what) {
    return test::Verified{
        "Reduced laws",
        "two ways over the same surface: " + what + " within two stated sd, share of 1000 draws",
        "Gauss: 0.954"};
  };
  EXPECT_TRUE(verified("ratio").between(ratios / double(draws), 0.954 - 0.04, 0.954 + 0.04));
  EXPECT_TRUE(verified("difference").between(differences / double(draws), 0.954 - 0.04, 0.954 + 0.04));
}

TEST(PairedWays_analytic, open_balances_stay_in_the_uncertainty_of_the_whole) {
  std::mt19937 random(7);
  const auto powers = noise(random, 0.3);
  SteadyPath one = path_of(powers);
  const SteadyPath other = path_of(powers);
  one.unbalanced = -0.02;
  EXPECT_NEAR(paired_difference(one, other, DissipationPart::total).sd, 0.02, 1e-6);
  EXPECT_LT(paired_difference(one, other, DissipationPart::friction).sd, 1e-9);
}

TEST(PairedWays_analytic, only_what_all_passed_is_compared) {
  std::mt19937 random(9);
  const auto powers = noise(random, 0.3);
  const std::vector<double> later(powers.begin() + 20,
                                  powers.end());  // steady from a contact radius further on
  const SteadyPath whole = path_of(powers), short_one = path_of(later, 20 * step);
  const auto rates = rates_in_common({&whole, &short_one}, DissipationPart::total);
  ASSERT_EQ(rates.size(), 2u);
  EXPECT_EQ(rates[0].size(), 5u);
  for (std::size_t k = 0; k < rates[0].size(); ++k) EXPECT_NEAR(rates[0][k], rates[1][k], 1e-9);
  // Another place altogether: each errs by itself.
  const SteadyPath elsewhere = path_of(powers, 100);
  EXPECT_TRUE(rates_in_common({&whole, &elsewhere}, DissipationPart::total).empty());
  EXPECT_DOUBLE_EQ(paired_ratio(whole, elsewhere).sd, ratio(whole.resistance(), elsewhere.resistance()).sd);
}

TEST(PairedWays_analytic, backwards_is_as_well) {
  std::mt19937 random(11);
  const auto powers = noise(random, 0.3);
  const SteadyPath there = path_of(powers), back = path_of(powers, 0, -1),
                   back_again = path_of(times(powers, 0.5), 0, -1);
  EXPECT_NEAR(paired_ratio(back_again, back).value, 0.5, 1e-9);
  EXPECT_LT(paired_ratio(back_again, back).sd, 1e-9);
  EXPECT_NEAR(paired_difference(back_again, back, DissipationPart::force).value, -0.5 * back.force.value,
              1e-6);
  EXPECT_TRUE(rates_in_common({&there, &back}, DissipationPart::total).empty());
}

}  // namespace
}  // namespace asperity
