#include "fem/experiments/external_work.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/verification.h"

namespace {

using asperity::fem::external_work;

asperity::test::Verified work_along(const char* path, const char* source) {
  return {"Experiment", std::string("work of the driven plane along ") + path, source};
}

struct Path {
  std::vector<double> delta, force;
  void to(double d, double f) { delta.push_back(d), force.push_back(f); }
};

TEST(ExternalWork_analytic, of_hertz_is_two_fifths_of_force_times_approach_after_any_number_of_steps) {
  asperity::test::Largest error;
  for (const int steps : {1, 2, 5, 9}) {
    Path p;
    for (int i = 1; i <= steps; ++i) p.to(i * 1e-9, 3 * std::pow(i, 1.5));
    error.count(external_work(p.delta, p.force).back() / (0.4 * p.delta.back() * p.force.back()) - 1);
  }
  EXPECT_TRUE(work_along("Hertz' law, 1 to 9 steps", "2/5 P delta").below(error, 1e-7));
}

TEST(ExternalWork_analytic, of_a_power_law_is_exact_from_the_first_step_on) {
  Path p;
  for (int i = 1; i <= 4; ++i) p.to(i * 2e-9, std::pow(i, 2.3));
  const auto work = external_work(p.delta, p.force);
  asperity::test::Largest error;
  for (int k = 0; k < 4; ++k) error.count(work[k] / (p.delta[k] * p.force[k] / 3.3) - 1);
  EXPECT_TRUE(work_along("a power law, from the first step on", "its integral").below(error, 1e-7));
}

TEST(ExternalWork_analytic, unloading_from_an_imprint_returns_the_integral_of_its_own_law) {
  Path p;
  for (int i = 1; i <= 4; ++i) p.to(i * 2e-9, std::pow(0.25 * i, 1.2));
  const double imprint = 3e-9, peak = 8e-9;
  for (const double d : {7e-9, 6e-9, 4.5e-9, 3.2e-9})
    p.to(d, std::pow((d - imprint) / (peak - imprint), 1.9));
  const auto work = external_work(p.delta, p.force);
  const auto stored = [&](double d) {
    return (peak - imprint) * std::pow((d - imprint) / (peak - imprint), 2.9) / 2.9;
  };
  EXPECT_TRUE(work_along("the unloading from an imprint", "its integral")
                  .below((work[3] - work[7]) / (stored(peak) - stored(3.2e-9)) - 1, 1e-6));
}

TEST(ExternalWork_analytic, holding_costs_nothing_and_an_elastic_cycle_returns_all) {
  Path p;
  const auto hertz = [](double d) { return std::pow(d, 1.5); };
  for (const double d : {1.0, 2.0, 3.0, 3.0, 2.0, 1.0, 0.01, 1.0, 3.0}) p.to(d, hertz(d));
  const auto work = external_work(p.delta, p.force);
  EXPECT_EQ(work[3], work[2]);
  EXPECT_NEAR(work[6], 0.4 * std::pow(0.01, 2.5), 1e-6 * work[2]);
  EXPECT_NEAR(work[8], work[2], 1e-6 * work[2]);
}

}  // namespace
