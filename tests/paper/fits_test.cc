// The fits and balances behind the paper's analysis, on data made for them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/error.h"
#include "dem_compare/laws/rail_balance.h"
#include "paper/exponential_law.h"
#include "paper/friction_series.h"
#include "paper/hertz_collision.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::message_of;

TEST(PaperFits_analytic, sd_goes_through_a_product_by_relative_squares) {
  const Uncertain product = propagate([](const auto& x) { return x[0] * x[1]; }, {{2, 0.02}, {3, 0.06}});
  EXPECT_DOUBLE_EQ(product.value, 6);
  EXPECT_NEAR(product.sd, 6 * std::hypot(0.01, 0.02), 1e-9);
  EXPECT_FALSE(propagate([](const auto& x) { return x[0]; }, {{2}}).has_sd());
  EXPECT_DOUBLE_EQ(deviation_in_both_sigmas({2, 3}, {12, 4}), -2);
}

TEST(PaperFits_analytic, friction_and_offset_come_out_of_a_line_and_of_a_curve_that_grows_with_the_contact) {
  for (const double exponent : {0.0, 1.0 / 3}) {
    const auto scale = [&](double f) { return std::pow(f / 1e-3, exponent); };
    std::vector<FrictionPoint> series;
    for (double f = 1e-4; f < 3.05e-3; f += 2e-4) series.push_back({f, {7.9e-4 * scale(f) * (f + 571.4e-6)}});
    const FrictionFit fit = fit_friction(series, scale);
    EXPECT_NEAR(fit.coefficient.value / 7.9e-4, 1, 1e-10);
    EXPECT_NEAR(fit.offset.value / 571.4e-6, 1, 1e-10);
  }
}

TEST(PaperFits_analytic, standard_errors_of_friction_and_offset_are_the_scatter_of_many_series) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 1e-7);
  double mu_sum = 0, mu_squares = 0, h_sum = 0, h_squares = 0;
  constexpr int series_count = 2000;
  FrictionFit fit;
  for (int i = 0; i < series_count; ++i) {
    std::vector<FrictionPoint> series;
    for (double f = 1e-4; f < 3.05e-3; f += 2e-4)
      series.push_back({f, {7.9e-4 * (f + 571.4e-6) + noise(random), 1e-7}});
    fit = fit_friction(series, [](double) { return 1.0; });
    const double mu = fit.coefficient.value, h = fit.offset.value;
    mu_sum += mu, mu_squares += mu * mu, h_sum += h, h_squares += h * h;
  }
  const auto sd = [&](double sum, double squares) {
    return std::sqrt(squares / series_count - sum * sum / series_count / series_count);
  };
  // The sd of 2000 series is known to 1/(2*2000)^(1/2) = 1.6 %; 5 % is three times that.
  EXPECT_NEAR(sd(mu_sum, mu_squares) / fit.coefficient.sd, 1, 0.05);
  EXPECT_NEAR(sd(h_sum, h_squares) / fit.offset.sd, 1, 0.05);
  EXPECT_LT(fit.correlation, 0);
}

TEST(PaperFits_behaviour, friction_needs_three_points) {
  EXPECT_NE(message_of<InputError>([] {
              fit_friction({{1, {1}}, {2, {2}}}, [](double) { return 1.0; });
            }).find("needs three points"),
            std::string::npos);
}

TEST(PaperFits_analytic, mean_offset_of_two_contacts_weighs_them_by_their_friction_factors) {
  const RollingContact mean = mean_rolling({3e-9, 100e-6}, {1e-9, 500e-6});
  EXPECT_NEAR(mean.factor, 2e-9, 1e-22);
  EXPECT_NEAR(mean.offset, 200e-6, 1e-16);
}

TEST(PaperFits_analytic, exponential_goes_through_three_points_and_finds_itself_in_many) {
  const ExponentialLaw law{2.95e-4, 6.515e-4, 1.0923e-9};
  std::vector<Uncertain> x, y;
  for (const double rms : {0.3e-9, 1.5e-9, 2.7e-9}) {
    x.push_back({rms, 0.1e-9});
    y.push_back({law(rms), 2e-5});
  }
  const ExponentialFit three = fit_exponential(x, y);
  EXPECT_NEAR(three.law.d / law.d, 1, 1e-9);
  EXPECT_NEAR(three.law.b / law.b, 1, 1e-9);
  EXPECT_NEAR(three.chi2, 0, 1e-12);
  // At one of its own points the law is as uncertain as the point: its sd, and that of its place along the
  // slope.
  const double slope = law.c / law.d * std::exp(-0.3e-9 / law.d);
  EXPECT_NEAR(three.at({0.3e-9}).sd / std::hypot(2e-5, slope * 0.1e-9), 1, 1e-4);
  for (const double rms : {0.9e-9, 2.0e-9, 4e-9}) {
    x.push_back({rms, 0.1e-9});
    y.push_back({law(rms), 2e-5});
  }
  std::sort(x.begin(), x.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  std::sort(y.begin(), y.end(), [](const auto& a, const auto& b) { return a.value > b.value; });
  const ExponentialFit six = fit_exponential(x, y);
  EXPECT_NEAR(six.law.d / law.d, 1, 1e-6);
  EXPECT_LT(six.d.sd, three.d.sd);
}

TEST(PaperFits_behaviour, exponential_refuses_points_that_do_not_decay) {
  EXPECT_NE(message_of<WorkError>([] {
              fit_exponential({{0}, {1}, {2}}, {{3}, {2}, {0}});
            }).find("no decaying exponential"),
            std::string::npos);
  EXPECT_NE(message_of<InputError>([] {
              fit_exponential({{0}, {1}}, {{3}, {2}});
            }).find("three points or more"),
            std::string::npos);
}

TEST(PaperFits_analytic, rail_is_pure_rolling_when_flat_and_pure_torsion_when_upright) {
  const RailFriction friction{7.9e-4, 0.0056, 571e-6, 20e-6};
  const double upright = std::acos(0.0);
  EXPECT_NEAR(rail_friction(0, friction), 7.9e-4, 1e-18);
  EXPECT_NEAR(rail_friction(upright, friction), 0.0056, 1e-15);
  EXPECT_NEAR(rail_offset(0, friction), 1.5 * 571e-6 / 2, 1e-15);
}

TEST(PaperFits_analytic, torsion_force_gives_back_the_torsion_that_made_the_rail_force) {
  const RailFriction friction{3.1e-4, 0.0056, 600e-6, 40e-6};
  for (const double angle : {0.4, 0.8, 1.05})
    for (const double f : {1e-4, 1e-3}) {
      const double lateral = rail_friction(angle, friction) * (f + rail_offset(angle, friction));
      EXPECT_NEAR(torsion_force(angle, lateral, f, friction.rolling, friction.rolling_offset) /
                      (0.0056 * (f + 40e-6)),
                  1, 1e-12);
      EXPECT_NEAR(torsion_from_rail(angle, rail_friction(angle, friction), friction.rolling) / 0.0056, 1,
                  1e-12);
      EXPECT_NEAR(torsion_offset_from_rail(angle, rail_friction(angle, friction),
                                           rail_offset(angle, friction), friction) /
                      40e-6,
                  1, 1e-9);
    }
}

TEST(PaperFits_analytic, undamped_hertz_collision_gives_everything_back) {
  EXPECT_NEAR(hertz_restitution(0), 1, 1e-8);
  // gamma = 2 (5/6)^(1/2) beta (m k)^(1/2) with k = 2 E* a, beta = -ln e/(ln^2 e + pi^2)^(1/2) (Tsuji et al.
  // 1992; Thornton et al. 2013).
  for (const double e : {0.97, 0.5}) {
    const double beta = -std::log(e) / std::hypot(std::log(e), std::acos(-1.0));
    EXPECT_NEAR(hertz_damping_factor(e), 2 * std::sqrt(5.0 / 6) * beta, 2e-3 * 2 * beta);
  }
  EXPECT_NE(message_of<InputError>([] { hertz_restitution(2); }).find("comes back"), std::string::npos);
}

}  // namespace
}  // namespace asperity
