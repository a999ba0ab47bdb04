#include "fem/contact/line_search.h"

#include <gtest/gtest.h>

namespace {

using asperity::fem::LineSearch;

/// Slope of an energy that is lowest at `lowest` and rises there as |x|^3 does on either side.
struct Energy {
  double lowest;
  int asked = 0;
  double operator()(double step) {
    ++asked;
    const double d = lowest - step;
    return d * std::abs(d);
  }
};

TEST(LineSearch_analytic, takes_the_whole_step_of_newton_where_it_does_not_overshoot_far) {
  Energy e{0.8};
  EXPECT_EQ(LineSearch(1, 3).step(0.64, [&](double s) { return e(s); }), 1);
  EXPECT_EQ(e.asked, 1);
}

TEST(LineSearch_analytic, cuts_a_step_far_beyond_the_lowest_energy_only_in_part) {
  Energy e{0.1};
  const double step = LineSearch(1, 3).step(0.01, [&](double s) { return e(s); });
  EXPECT_LT(step, 0.4);
  EXPECT_GT(step, 0.1);
}

TEST(LineSearch_analytic, goes_on_where_a_whole_step_leads_far_short_of_the_lowest_energy) {
  Energy far{6};
  EXPECT_EQ(LineSearch(1, 0).step(36, [&](double s) { return far(s); }), 2);
  EXPECT_EQ(far.asked, 2);
  const auto falls_late = [&](double s) {
    return s < 4 ? 4.0 : Energy{2}(s);
  };  // gone past the lowest energy it comes back by a quarter
  EXPECT_EQ(LineSearch(1, 3).step(4, falls_late), 3);
  Energy endless{1e6};
  EXPECT_EQ(LineSearch(1, 3).step(1e12, [&](double s) { return endless(s); }), 32);
}

TEST(LineSearch_analytic, finds_the_lowest_energy_closely_after_steps_without_progress) {
  LineSearch search(1, 3);
  for (int k = 0; k < 3; ++k) search.reached(1.5);
  Energy e{0.1};
  const double step = search.step(0.01, [&](double s) { return e(s); });
  EXPECT_NEAR(step, 0.1, 0.06);
  LineSearch content(1, 3);
  for (int k = 0; k < 3; ++k) content.reached(1.0 / (k + 2));
  EXPECT_EQ(content.step(0.64, [&](double s) { return Energy{0.8}(s); }), 1);
}

}  // namespace
