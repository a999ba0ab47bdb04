#include "dem_compare/cases/normal_numbers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "results/history.h"

namespace asperity {
namespace {

const Hertz hertz{52.8684e9, 8.5e-6};

void add_step(History& history, double approach, double force) {
  for (const auto& column : history_columns())
    if (column.always) (history.*column.values).push_back(0);
  history.step.back() = static_cast<double>(history.size());
  history.normal_displacement.back() = approach;
  history.normal_force.back() = force;
  history.contact_area.back() = force > 0 ? hertz.contact_area(force) : 0;
  history.max_pressure.back() = force > 0 ? hertz.peak_pressure(force) : 0;
}

/// Hertz with its zero of approach shifted, unloading as from an imprint of another radius.
History loading_and_unloading(double offset, double imprint, int steps = 8) {
  History history;
  const double largest = 1e-3;
  for (int i = 1; i <= steps; ++i) {
    const double force = largest * i / steps;
    add_step(history, hertz.approach(force) + offset, force);
  }
  const double top = hertz.approach(largest) + offset;
  for (int i = steps - 1; i >= 0; --i) {
    const double force = largest * i / steps;
    add_step(history, imprint + (top - imprint) * std::pow(force / largest, 2.0 / 3.0), force);
  }
  return history;
}

TEST(NormalNumbers_analytic, a_hertzian_loading_gives_the_tangent_2EaStar_whatever_the_zero_of_approach) {
  for (const double offset : {0.0, 3e-9}) {
    const auto numbers = normal_numbers(loading_and_unloading(offset, 1e-9), hertz);
    ASSERT_EQ(numbers.loading.size(), 8u);
    for (const auto& tangent : numbers.loading) {
      EXPECT_NEAR(tangent.stiffness / hertz.normal_stiffness(tangent.force), 1, 1e-9);
      EXPECT_LT(tangent.error, 1e-9 * tangent.stiffness);
    }
    for (const auto& ratio : numbers.loads) {
      EXPECT_NEAR(ratio.stiffness_ratio, 1, 1e-9);
      EXPECT_NEAR(ratio.area_ratio, 1, 1e-12);
      EXPECT_NEAR(ratio.pressure_ratio, 1, 1e-12);
    }
  }
}

TEST(NormalNumbers_analytic, mean_pressure_is_load_over_the_real_area_not_over_the_circle_of_the_radius) {
  History history = loading_and_unloading(0, 1e-9);
  constexpr double touching = 0.3;  // of the circle: a rough contact
  for (std::size_t i = 0; i < history.size(); ++i) {
    history.contact_radius[i] = hertz.contact_radius(history.normal_force[i]);
    history.contact_area[i] = touching * M_PI * history.contact_radius[i] * history.contact_radius[i];
  }
  const auto numbers = normal_numbers(history, hertz);
  ASSERT_EQ(numbers.loads.size(), 8u);
  for (const auto& load : numbers.loads)
    EXPECT_NEAR(load.mean_pressure / (2.0 / 3 * hertz.peak_pressure(load.force) / touching), 1, 1e-12);
}

TEST(NormalNumbers_analytic,
     unloading_starts_with_the_stiffness_of_a_contact_of_the_remaining_elastic_approach) {
  const double imprint = 4e-9;
  const auto numbers = normal_numbers(loading_and_unloading(0, imprint), hertz);
  // F = F_max ((delta - imprint)/(delta_max - imprint))^(3/2)
  EXPECT_NEAR(numbers.unloading_stiffness() / (1.5e-3 / (hertz.approach(1e-3) - imprint)), 1, 1e-9);
  EXPECT_NEAR(numbers.residual_imprint, imprint, 1e-16);
  EXPECT_EQ(numbers.imprint_force, 0);
}

TEST(NormalNumbers_analytic,
     an_unloading_that_stops_short_of_zero_load_is_compared_with_loading_at_the_same_force) {
  const double imprint = 4e-9, largest = 1e-3, top = hertz.approach(largest);
  // In the middle of two loading steps, on a step, and below the first step.
  for (const double share : {0.3, 0.25, 0.001}) {
    History history = loading_and_unloading(0, imprint);
    for (const auto& column : history_columns())
      if (column.always) (history.*column.values).resize(9);
    add_step(history, imprint + (top - imprint) * std::pow(share, 2.0 / 3.0), largest * share);
    const auto numbers = normal_numbers(history, hertz);
    EXPECT_EQ(numbers.imprint_force, largest * share);
    EXPECT_NEAR(numbers.residual_imprint, imprint * (1 - std::pow(share, 2.0 / 3.0)), 1e-15);
  }
}

TEST(NormalNumbers_analytic, an_elastic_contact_of_any_power_law_leaves_no_imprint) {
  History history;
  const auto force = [](double approach) { return 1e-3 * std::pow(approach / 20e-9, 2.2); };
  for (const double approach : {4e-9, 8e-9, 14e-9, 20e-9, 14e-9, 8e-9, 4e-9, 1e-9})
    add_step(history, approach, force(approach));
  EXPECT_NEAR(normal_numbers(history, hertz).residual_imprint, 0, 1e-15);
}

TEST(NormalNumbers_analytic, a_sphere_of_9_um_is_reported_as_9_um_with_the_exponent_three_halves) {
  const Hertz larger{hertz.reduced_modulus, 9e-6};
  std::vector<double> approach, force;
  for (int i = 1; i <= 8; ++i)
    force.push_back(i * 1e-4), approach.push_back(larger.approach(i * 1e-4) + 2e-9);
  const RadiusFit fit = fit_radius(approach, force, hertz.reduced_modulus, true);
  EXPECT_NEAR(fit.radius.value, 9e-6, 1e-12);
  EXPECT_NEAR(fit.offset.value, 2e-9, 1e-15);
  const ExponentFit power = fit_exponent(approach, force, true);
  EXPECT_NEAR(power.exponent.value, 1.5, 1e-6);
  EXPECT_NEAR(power.offset.value, 2e-9, 1e-14);
  // Without an offset the same curve looks softer: a smaller sphere and a steeper law.
  EXPECT_LT(fit_radius(approach, force, hertz.reduced_modulus, false).radius.value, 9e-6);
  EXPECT_GT(fit_exponent(approach, force, false).exponent.value, 1.5);
}

TEST(NormalNumbers_analytic, standard_errors_of_a_fit_cover_the_truth_as_often_as_they_should) {
  std::srand(1);
  const auto noise = [] {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += std::rand() / double(RAND_MAX);
    return sum;
  };
  int covered = 0;
  const int trials = 400;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<double> approach, force;
    for (int i = 1; i <= 20; ++i) {
      const double f = i * 5e-5;
      approach.push_back(hertz.approach(f));
      force.push_back(f + 2e-6 * noise());
    }
    const auto fit = fit_radius(approach, force, hertz.reduced_modulus, false);
    if (std::abs(fit.radius.value - hertz.radius) < fit.radius.standard_error) ++covered;
  }
  // Student's t with 19 degrees of freedom: 67 % within one standard error; binomial error of 400 trials 2.3
  // %.
  EXPECT_NEAR(covered / double(trials), 0.67, 3 * 0.023);
}

TEST(NormalNumbers_analytic, stiffness_between_steps_is_interpolated_and_outside_unknown) {
  const auto numbers = normal_numbers(loading_and_unloading(0, 0), hertz);
  EXPECT_NEAR(stiffness_at(numbers.loading, 4.4e-4) / hertz.normal_stiffness(4.4e-4), 1, 1e-9);
  EXPECT_TRUE(std::isnan(stiffness_at(numbers.loading, 2e-3)));
  EXPECT_TRUE(std::isnan(stiffness_at({}, 1e-4)));
}

TEST(NormalNumbers_behaviour, an_empty_or_barely_begun_history_gives_no_numbers_and_no_error) {
  EXPECT_TRUE(normal_numbers({}, hertz).loads.empty());
  History one;
  add_step(one, hertz.approach(1e-4), 1e-4);
  const auto numbers = normal_numbers(one, hertz);
  EXPECT_TRUE(numbers.loading.empty());
  EXPECT_FALSE(numbers.has_fits);
  EXPECT_TRUE(std::isnan(numbers.unloading_stiffness()));
}

}  // namespace
}  // namespace asperity
