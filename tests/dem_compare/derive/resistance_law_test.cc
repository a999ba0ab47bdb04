#include "dem_compare/derive/resistance_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/error.h"
#include "dem_compare/cases/case_numbers.h"
#include "dem_compare/derive/length_choice.h"
#include "tests/support/verification.h"

namespace asperity {
namespace {

const Hertz hertz{52.87e9, 8.5e-6};
constexpr auto contact_radius = LengthScale::contact_radius, particle_radius = LengthScale::particle_radius,
               none = LengthScale::none;

struct Truth {
  double mu = 0.11, offset = 2e-5;
  double way_scatter = 0.01, case_scatter = 0.02, realisation_scatter = 0.03;
};

std::vector<ResistancePoint> measure(const Truth& truth, const std::vector<double>& loads, int realisations,
                                     LengthScale scale, std::mt19937& random, const Hertz& sphere = hertz) {
  std::normal_distribution<double> normal;
  std::vector<ResistancePoint> points;
  for (int r = 0; r < realisations; ++r) {
    const double common = 1 + truth.realisation_scatter * normal(random);
    for (const double load : loads) {
      ResistancePoint point{load, 0, 0, std::to_string(r), sphere.radius, sphere.contact_radius(load)};
      const double exact = truth.mu * point.length(scale) * (load + truth.offset);
      point.value =
          exact * common * (1 + truth.case_scatter * normal(random) + truth.way_scatter * normal(random));
      point.sd = truth.way_scatter * exact;
      points.push_back(point);
    }
  }
  return points;
}

const std::vector<double> wide{1e-4, 3e-4, 1e-3, 3e-3};

TEST(ResistanceLaw_analytic, passes_through_exact_resistances) {
  std::mt19937 random(1);
  const Truth exact{0.23, 1.2e-5, 0, 0, 0};
  const ResistanceLaw law = fit_resistance(measure(exact, wide, 1, none, random), none);
  EXPECT_NEAR(law.coefficient, 0.23, 1e-9);
  EXPECT_NEAR(law.offset, 1.2e-5, 1e-12);
  EXPECT_LT(law.misfit, 1e-9);
  EXPECT_EQ(law.degrees_of_freedom, 2);
  EXPECT_EQ(law.loads.low, 1e-4);
  EXPECT_EQ(law.loads.high, 3e-3);
}

TEST(ResistanceLaw_behaviour, from_one_load_has_no_offset) {
  std::mt19937 random(1);
  const ResistanceLaw law = fit_resistance(measure({0.23, 0, 0.01, 0, 0}, {1e-4}, 1, none, random), none);
  EXPECT_FALSE(law.has_offset);
  EXPECT_EQ(law.offset, 0);
  EXPECT_NEAR(law.coefficient, 0.23, 0.01);
  EXPECT_NEAR(law.coefficient_sd() / 0.23, std::hypot(0.01, 0.001),
              1e-4);  // of the way, and of any solved case
}

/// Through two points the law is exact algebra: mu = (v2 - v1)/(f2 - f1), h = v1/mu - f1.
TEST(ResistanceLaw_analytic, of_two_loads_has_the_errors_of_a_straight_line_through_two_points) {
  constexpr double f1 = 1e-4, f2 = 1e-3, mu = 0.2, h = 3e-5, thousandth = 1e-3;
  const double v1 = mu * (f1 + h), v2 = mu * (f2 + h), of_way = 0.02;
  std::vector<ResistancePoint> points(2);
  points[0] = {f1, v1, of_way * v1, "a", hertz.radius, hertz.contact_radius(f1)};
  points[1] = {f2, v2, of_way * v2, "a", hertz.radius, hertz.contact_radius(f2)};
  const ResistanceLaw law = fit_resistance(points, none);
  const double relative = std::hypot(of_way, thousandth), s1 = relative * v1, s2 = relative * v2,
               width = f2 - f1;
  EXPECT_NEAR(law.coefficient, mu, 1e-9);
  EXPECT_NEAR(law.coefficient_sd() / (std::hypot(s1, s2) / width), 1, 1e-3);
  // h = (v1 f2 - v2 f1)/(v2 - v1)
  const double by_v1 = v2 * width / std::pow(v2 - v1, 2), by_v2 = v1 * width / std::pow(v2 - v1, 2);
  EXPECT_NEAR(law.offset / h, 1, 1e-6);
  EXPECT_NEAR(law.offset_sd() / std::hypot(by_v1 * s1, by_v2 * s2), 1, 1e-3);
}

/// One load, cases alike: their mean, and what their scatter leaves of it.
TEST(ResistanceLaw_analytic, of_cases_at_one_load_is_their_mean) {
  std::vector<ResistancePoint> points;
  for (const double value : {0.9, 1.0, 1.1, 0.9, 1.1}) points.push_back({2, value, 1e-6, "a", 1, 1});
  const ResistanceLaw law = fit_resistance(points, none);
  EXPECT_NEAR(law.coefficient, 0.5, 1e-9);
  // Scatters are tried in steps of a quarter.
  EXPECT_NEAR(law.coefficient_sd(), 0.5 * 0.1 / std::sqrt(5.0), 0.5 * 0.006);
  EXPECT_NEAR(law.case_scatter, 0.1, 0.015);
  EXPECT_EQ(law.realisation_scatter, 0);
  EXPECT_EQ(law.degrees_of_freedom, 4);
  EXPECT_NEAR(law.misfit, std::sqrt(2 * (std::pow(1 / 9.0, 2) + std::pow(1 / 11.0, 2)) / 5), 1e-9);
}

TEST(ResistanceLaw_analytic, counts_its_coefficient_over_the_length) {
  const std::vector<ResistancePoint> points{{2, 0.9, 0.06, "a", 4, 5}, {2, 1.1, 0.06, "a", 4, 5}};
  const double of_load = fit_resistance(points, none).coefficient_sd();
  for (const auto& [scale, length] : {std::pair{particle_radius, 4.0}, std::pair{contact_radius, 5.0}}) {
    const ResistanceLaw law = fit_resistance(points, scale);
    EXPECT_NEAR(law.coefficient, 1 / (2 * length), 1e-9);
    EXPECT_NEAR(law.coefficient_sd(), of_load / length, 1e-9);
  }
}

/// A case that its way leaves open twice as wide counts a quarter.
TEST(ResistanceLaw_analytic, weighs_cases_by_what_their_ways_leave_open) {
  const std::vector<ResistancePoint> points{{1, 1, 0.05, "a", 1, 1}, {1, 1.05, 0.1, "a", 1, 1}};
  const ResistanceLaw law = fit_resistance(points, none);
  EXPECT_NEAR(law.coefficient, (4 * 1 + 1.05) / 5, 1e-4);
  EXPECT_NEAR(law.coefficient_sd(), 0.1 / std::sqrt(5.0), 1e-4);
  EXPECT_NEAR(law.case_scatter, 1e-3, 1e-9);
}

/// Peelle's puzzle: a common scatter taken of the measured values would draw the fit below all of them.
TEST(ResistanceLaw_analytic, with_a_scatter_common_to_a_realisation_stays_between_its_values) {
  std::vector<ResistancePoint> points;
  for (const double value : {1.0, 1.02}) points.push_back({1, value, 1e-3, "a", 1, 1});
  for (const double value : {1.5, 1.52}) points.push_back({1, value, 1e-3, "b", 1, 1});
  const ResistanceLaw law = fit_resistance(points, none);
  EXPECT_NEAR(law.coefficient, 1.26, 1e-6);
  EXPECT_NEAR(law.coefficient_sd(), 0.25, 0.05);  // of two realisations, not of four cases
  EXPECT_GT(law.realisation_scatter, 5 * law.case_scatter);
  for (auto& point : points) point.realisation = "a";
  EXPECT_EQ(fit_resistance(points, none).realisation_scatter, 0);
}

/// The definition of log_evidence() by inverse and determinant; for points whose geometric means are one.
double evidence_by_definition(const std::vector<ResistancePoint>& points, bool has_common_scatter) {
  const auto n = static_cast<Eigen::Index>(points.size());
  Eigen::VectorXd y(n), level(n), load(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    y[i] = points[static_cast<std::size_t>(i)].value, load[i] = points[static_cast<std::size_t>(i)].load;
    double sum = 0, count = 0;
    for (const auto& other : points)
      if (std::abs(other.load / load[i] - 1) < 1e-3) sum += other.value, ++count;
    level[i] = sum / count;
  }
  const auto density = [&](double own, double common) {
    Eigen::MatrixXd V(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < n; ++j) {
        const auto &p = points[static_cast<std::size_t>(i)], &q = points[static_cast<std::size_t>(j)];
        V(i, j) = load[i] * load[j] + 1;  // mu and mu h of sd one
        if (p.realisation == q.realisation) V(i, j) += common * common * level[i] * level[j];
        if (i == j) V(i, j) += p.sd * p.sd + own * own * level[i] * level[i];
      }
    return std::exp(-0.5 * y.dot(V.inverse() * y)) / std::sqrt((2 * M_PI * V).determinant());
  };
  double sum = 0;
  int count = 0;
  for (int o = 0; o <= 30; ++o)
    for (int c = 0; c <= (has_common_scatter ? 30 : 0); ++c, ++count)
      sum += density(std::pow(10, -3 + 0.1 * o), has_common_scatter ? std::pow(10, -3 + 0.1 * c) : 0);
  return std::log(sum / count);
}

/// Four cases at loads of 1/2, 1/2, 2 and 2; product of the values one.
std::vector<ResistancePoint> four_cases(const std::vector<std::string>& realisations) {
  const double values[] = {0.5, 0.6, 1.8, 1 / (0.5 * 0.6 * 1.8)};
  std::vector<ResistancePoint> points;
  for (std::size_t i = 0; i < 4; ++i)
    points.push_back({i < 2 ? 0.5 : 2, values[i], 0.03 * values[i], realisations[i], 1, 1});
  return points;
}

TEST(ResistanceLaw_analytic, has_the_evidence_of_its_definition) {
  const auto several = four_cases({"a", "b", "a", "b"}), one = four_cases({"a", "a", "a", "a"}),
             apart = four_cases({"a", "b", "c", "d"});
  EXPECT_NEAR(log_evidence(several, none), evidence_by_definition(several, true), 1e-9);
  // Of a single realisation, or where each has one case, a common scatter is not apart from the cases' own.
  EXPECT_NEAR(log_evidence(one, none), evidence_by_definition(one, false), 1e-9);
  EXPECT_NEAR(log_evidence(apart, none), evidence_by_definition(apart, false), 1e-9);
}

TEST(ResistanceLaw_analytic, has_an_evidence_that_does_not_depend_on_units) {
  auto points = four_cases({"a", "b", "a", "b"});
  const double expected = log_evidence(points, contact_radius);
  for (auto& point : points) {
    point.load *= 1e-4, point.contact_radius *= 1e-7;
    point.value *= 3e-11, point.sd *= 3e-11;
  }
  EXPECT_NEAR(log_evidence(points, contact_radius), expected, 1e-9);
}

/// Through two loads the law is a line: predictions of the third by hand.
TEST(ResistanceLaw_analytic, leaves_each_contact_out_once) {
  std::vector<ResistancePoint> points;
  const double values[] = {1, 2.1, 3};
  for (int i = 0; i < 3; ++i) points.push_back({i + 1.0, values[i], 1e-3, "a", 1, 1});
  const double first = (2 * 2.1 - 3) / 1 - 1, second = (1 + 3) / 2.0 / 2.1 - 1, third = (2 * 2.1 - 1) / 3 - 1;
  const double expected = std::sqrt((first * first + second * second + third * third) / 3);
  EXPECT_NEAR(leave_one_out(points, none), expected, 1e-9);
  // A second realisation at the same load is the same contact, and left out with it.
  points.push_back(points.back());
  points.back().realisation = "b";
  const double twice = std::sqrt((first * first + second * second + 2 * third * third) / 4);
  EXPECT_NEAR(leave_one_out(points, none), twice, 1e-9);
  points.resize(2);
  EXPECT_TRUE(std::isnan(leave_one_out(points, none)));
}

TEST(ResistanceLaw_analytic, tells_loads_apart_by_a_thousandth) {
  const auto at = [](double load) { return ResistancePoint{load, 1, 0, "a", 1, 1}; };
  EXPECT_EQ(distinct_loads({at(2), at(1), at(1.0005), at(2.003)}), (std::vector<double>{1, 2, 2.003}));
  EXPECT_TRUE(same_load(1000, 1001));
  EXPECT_TRUE(same_load(1001, 1000));
  EXPECT_FALSE(same_load(1000, 1002));
}

TEST(ResistanceLaw_analytic, grows_with_its_length_and_the_load_above_the_offset) {
  const ResistancePoint point{3, 0, 0, "a", 5, 7};
  ResistanceLaw law;
  law.coefficient = 0.5, law.offset = 1;
  EXPECT_EQ(law.at(point, none), 0.5 * 4);
  EXPECT_EQ(law.at(point, particle_radius), 0.5 * 5 * 4);
  EXPECT_EQ(law.at(point, contact_radius), 0.5 * 7 * 4);
}

TEST(ResistanceLaw_behaviour, needs_a_case) { EXPECT_THROW(fit_resistance({}, none), InputError); }

TEST(ResistanceLaw_analytic, finds_the_scatter_over_cases_that_they_were_made_with) {
  std::mt19937 random(9);
  const Truth truth{0.11, 2e-5, 1e-4, 0.03, 0};
  constexpr int repetitions = 40;
  double squares = 0;
  for (int i = 0; i < repetitions; ++i)
    squares +=
        std::pow(fit_resistance(measure(truth, wide, 6, none, random), none).case_scatter, 2) / repetitions;
  EXPECT_NEAR(std::sqrt(squares) / truth.case_scatter, 1, 0.1);
}

/// Share of many repetitions in which a fitted number lies within its sd of the truth.
struct Coverage {
  double coefficient = 0, offset = 0;
};
Coverage coverage(const Truth& truth, int realisations, LengthScale scale) {
  std::mt19937 random(3);
  constexpr int repetitions = 200;
  Coverage share;
  for (int i = 0; i < repetitions; ++i) {
    const ResistanceLaw law = fit_resistance(measure(truth, wide, realisations, scale, random), scale);
    share.coefficient += (std::abs(law.coefficient - truth.mu) < law.coefficient_sd()) / double(repetitions);
    share.offset += (std::abs(law.offset - truth.offset) < law.offset_sd()) / double(repetitions);
  }
  return share;
}

// 200 draws of a share of 0.683 scatter by 0.033. Few realisations make an sd that is itself uncertain:
// Student's t with four degrees of freedom puts 0.626 within one sd.
constexpr double normal_share = 0.683, student_share_of_4 = 0.626, three_sigma = 0.1;

void expect_coverage(const std::string& of, const Coverage& share, double coefficient, double offset) {
  const auto verified = [&](const std::string& what) {
    return test::Verified{"Reduced laws",
                          "resistance law, " + of + ": " + what + " within one stated sd, share of 200 draws",
                          "Gauss, Student"};
  };
  EXPECT_TRUE(
      verified("mu").between(share.coefficient, coefficient - three_sigma, coefficient + three_sigma));
  EXPECT_TRUE(verified("h").between(share.offset, offset - three_sigma, offset + three_sigma));
}

TEST(ResistanceLaw_analytic, states_an_uncertainty_that_covers_the_truth_two_times_in_three) {
  expect_coverage("ways scatter", coverage({0.11, 2e-5, 0.01, 0, 0}, 3, contact_radius), normal_share,
                  normal_share);
}

TEST(ResistanceLaw_analytic, covers_the_truth_when_realisations_differ_more_than_their_ways_tell) {
  expect_coverage("realisations scatter", coverage({}, 5, contact_radius), student_share_of_4, normal_share);
}

TEST(LengthChoice_analytic, finds_the_length_the_moments_were_made_with_when_loads_span_a_factor_of_thirty) {
  std::mt19937 random(4);
  int right_contact = 0, right_radius = 0;
  constexpr int repetitions = 30;
  for (int i = 0; i < repetitions; ++i) {
    const Truth truth{0.11, 2e-5, 0.01, 0.01, 0.01};
    right_contact += choose_length(measure(truth, wide, 3, contact_radius, random)).log_odds > std::log(20);
    right_radius += choose_length(measure(truth, wide, 3, particle_radius, random)).log_odds < -std::log(20);
  }
  const auto verified = [](const char* length) {
    return test::Verified{"Reduced laws",
                          std::string("lambda = ") + length + " told with odds above 20, loads 0.1 to 3 mN",
                          "what made the moments"};
  };
  EXPECT_TRUE(verified("a").above(right_contact, 29, "of 30"));
  EXPECT_TRUE(verified("r").above(right_radius, 29, "of 30"));
}

TEST(LengthChoice_analytic, finds_it_from_one_smooth_case_per_load) {
  std::mt19937 random(5);
  const Truth smooth{0.177, 0, 1e-3, 0, 0};
  const LengthChoice contact = choose_length(measure(smooth, wide, 1, contact_radius, random));
  EXPECT_GT(contact.log_odds, std::log(20));
  EXPECT_EQ(contact.scale(), LengthScale::contact_radius);
  EXPECT_LT(contact.contact_error, 0.01);
  EXPECT_GT(contact.radius_error, 0.03);
  const LengthChoice radius = choose_length(measure(smooth, wide, 1, particle_radius, random));
  EXPECT_LT(radius.log_odds, -std::log(20));
  EXPECT_EQ(radius.scale(), LengthScale::particle_radius);
}

TEST(LengthChoice_analytic, does_not_pretend_to_know_when_loads_span_little) {
  std::mt19937 random(6);
  double largest = 0;
  for (int i = 0; i < 30; ++i)
    for (const auto length : {contact_radius, particle_radius}) {
      const LengthChoice choice = choose_length(measure({}, {1e-3, 1.1e-3, 1.2e-3}, 3, length, random));
      largest = std::max(largest, std::abs(choice.log_odds));
      EXPECT_FALSE(choice.is_told());
    }
  EXPECT_TRUE((test::Verified{"Reduced laws", "odds of lambda = a or r, loads 1 to 1.2 mN, 60 draws",
                              "they do not tell"}
                   .below(std::exp(largest), 3)));
}

TEST(LengthChoice_analytic, is_told_by_two_radii_where_loads_alone_cannot) {
  std::mt19937 random(8);
  const Hertz small{hertz.reduced_modulus, 2.5e-6};
  for (const auto length : {contact_radius, particle_radius}) {
    const Truth truth{0.11, 0, 0.01, 0.01, 0.01};
    std::vector<ResistancePoint> points = measure(truth, {0.9e-3, 1e-3}, 3, length, random);
    EXPECT_FALSE(choose_length(points).is_told());
    for (auto point : measure(truth, {0.9e-3, 1e-3}, 3, length, random, small)) {
      point.realisation += " of the small sphere";
      points.push_back(point);
    }
    const LengthChoice choice = choose_length(points);
    EXPECT_TRUE(choice.is_told());
    EXPECT_EQ(choice.scale(), length);
  }
}

TEST(LengthChoice_analytic, has_even_odds_from_a_single_load) {
  std::mt19937 random(7);
  const LengthChoice choice = choose_length(measure({}, {1e-3}, 3, contact_radius, random));
  EXPECT_EQ(choice.log_odds, 0);
  EXPECT_TRUE(std::isnan(choice.contact_error));
}

}  // namespace
}  // namespace asperity
