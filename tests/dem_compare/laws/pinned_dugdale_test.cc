#include "dem_compare/laws/pinned_dugdale.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dem_compare/laws/maugis_dugdale.h"
#include "tests/support/verification.h"

namespace asperity {
namespace {

using Contact = PinnedDugdale::Contact;

/// Led along approaches in small steps.
class Led {
 public:
  explicit Led(const PinnedDugdale& law) : law_(law) {}
  /// Returns the work that was done on the contact.
  double to(double approach) {
    constexpr int steps = 2000;
    const double from = state_.approach;
    double work = 0;
    for (int i = 1; i <= steps; ++i) {
      const Contact next = law_.at(from + (approach - from) * i / steps, state_);
      work += 0.5 * (state_.force + next.force) * (next.approach - state_.approach);
      state_ = next;
    }
    return work;
  }
  const Contact& state() const { return state_; }

 private:
  const PinnedDugdale& law_;
  Contact state_{};
};

/// Of the larger work, in its units.
MaugisDugdale maugis(double lambda) { return {0.75, 1, 1 / M_PI, lambda / 2}; }

TEST(PinnedDugdale_analytic, a_cycle_loses_the_difference_of_works_on_the_area_that_its_edge_sweeps) {
  test::Largest error;
  for (const double lambda : {1.0, 3.0, 10.0})
    for (const double ratio : {1e-4, 0.05, 0.3, 0.7, 0.95}) {
      const PinnedDugdale law(lambda, ratio);
      Led led(law);
      led.to(4);
      const double widest = led.state().held_edge;
      const double given_back = led.to(0.2), least = led.state().held_edge, given = led.to(4);
      ASSERT_GT(widest, 1.1 * least);
      error.count((given_back + given) / ((1 - ratio) * (widest * widest - least * least)) - 1);
    }
  EXPECT_TRUE(test::Verified({"Reduced laws", "hysteresis of adhesion with a range: what a cycle loses",
                              "w_o - w_c on the area that the edge sweeps"})
                  .below(error, 1e-5));
}

TEST(PinnedDugdale_other_code, with_works_alike_it_is_Maugis_solution) {
  for (const double lambda : {0.3, 1.0, 5.0}) {
    const PinnedDugdale law(lambda, 1);
    const MaugisDugdale other = maugis(lambda);
    Contact state{};
    NormalState expected;
    for (const double approach : {0.5, 2.0, 3.0, 1.0, -0.05, 0.4}) {
      state = law.at(approach, state), expected = other.advance(expected, approach);
      EXPECT_NEAR(state.force, expected.force, 1e-8) << lambda << " " << approach;
      EXPECT_NEAR(state.radius, expected.contact_radius, 1e-7) << lambda << " " << approach;
    }
  }
}

/// f = (3/2)(a d - a^3/3), the state of any contact of JKR, with a of the turn; the zone of attraction, whose
/// width is (3/4)/lambda^2 on Maugis' radius, is what it is off by.
TEST(PinnedDugdale_analytic, in_JKRs_limit_it_unloads_as_a_flat_punch) {
  constexpr double lambda = 300;
  const PinnedDugdale law(lambda, 0.1);
  const Contact turn = law.at(3, {});
  const double a = turn.radius;
  for (const double approach : {2.9, 2.5, 2.0}) {
    const Contact held = law.at(approach, turn);
    EXPECT_EQ(held.held_edge, a);
    EXPECT_NEAR(held.force, 1.5 * (a * approach - a * a * a / 3), 2e-3 * turn.force) << approach;
  }
}

TEST(PinnedDugdale_analytic, stiffness_at_the_turn_is_that_of_a_punch) {
  for (const double lambda : {0.5, 2.0}) {
    const PinnedDugdale law(lambda, 0.2);
    const Contact turn = law.at(3, {});
    constexpr double step = 1e-5;
    const double c = turn.attraction_edge, a = turn.radius, t = std::acos(a / c);
    const Contact held = law.at(3 - step, turn);
    // The punch's, and the attraction beyond c that is lost or won.
    const double beyond = 2 * lambda * 0.2 * c * t * (held.attraction_edge - c) / step;
    EXPECT_NEAR((turn.force - held.force) / step, 1.5 * a + beyond, 1e-3);
  }
}

TEST(PinnedDugdale_analytic, has_the_approach_under_a_force_at_which_it_has_that_force) {
  for (const double lambda : {0.4, 1.0, 6.0})
    for (const double ratio : {0.01, 0.5}) {
      const PinnedDugdale law(lambda, ratio);
      Contact state{};
      for (const double force : {2.0, 6.0, 5.5, 3.0, 4.0, 0.0, -0.6 * law.pull_off()}) {
        const Contact under = law.under(force, state);
        EXPECT_NEAR(law.at(under.approach, state).force, force, 1e-8) << lambda << " " << ratio;
        state = under;
      }
      EXPECT_TRUE(std::isnan(law.under(-1.01 * law.pull_off(), state).radius));
    }
}

/// A long range holds surfaces that no longer touch: down to where they part, with no jump of force.
TEST(PinnedDugdale_analytic, surfaces_of_a_long_range_attract_on_once_they_no_longer_touch) {
  const PinnedDugdale law(0.2, 0.3);
  Contact state = law.at(0.5, {});
  double largest_jump = 0;
  bool was_apart = false;
  const int steps = 4000;
  const double end = law.parting();
  for (int i = 1; i <= steps; ++i) {
    const Contact next = law.at(end + (0.5 - end) * (steps - i) / steps, state);
    largest_jump = std::max(largest_jump, std::abs(next.force - state.force));
    EXPECT_LE(next.held_edge, state.held_edge);
    was_apart = was_apart || next.apart();
    state = next;
  }
  EXPECT_TRUE(was_apart);
  const double smallest_disc = 8 * 0.2 / (3 * M_PI);  // where surfaces apart jump off (Maugis 1992)
  EXPECT_NEAR(state.force, -0.5 * M_PI * 0.2 * smallest_disc * smallest_disc, 1e-6);
  EXPECT_LT(largest_jump, 0.02);
  EXPECT_EQ(law.at(1.01 * end, state).force, 0);
  EXPECT_EQ(law.at(-0.01, law.at(1.01 * end, state)).force, 0);  // the contact forms at 0
}

TEST(PinnedDugdale_analytic, a_table_of_states_is_the_law) {
  test::Largest error;
  for (const double lambda : {0.1, 1.0, 10.0})
    for (const double ratio : {1e-4, 0.3, 0.95})
      for (const double depth : {1.0, 20.0}) {
        const PinnedDugdale law(lambda, ratio);
        const Contact turn = law.at(depth, {});
        const HeldCurve curve = law.curve(turn.held_edge);
        constexpr int steps = 500;
        int held = 0;
        for (int i = 1; i < steps; ++i) {
          const double approach = depth + (law.release() - depth) * i / steps;
          const Contact state = law.at(approach, turn);
          const bool is_held = state.held_edge == turn.held_edge && !state.apart();
          EXPECT_EQ(curve.holds(approach), is_held) << lambda << " " << ratio << " " << approach;
          if (is_held) error.count(curve.at(approach).force - state.force);
          held += is_held ? 1 : 0;
        }
        EXPECT_GT(held, 2);
      }
  EXPECT_LT(std::abs(error), 1e-5);
}

/// Below the smallest radius of JKR that is stable under fixed grips the edge lets go of all at once: with
/// K_I = (2 E* w)^(1/2) of a punch, at d = a^2 - (8 a/3)^(1/2) in Maugis' units.
TEST(PinnedDugdale_analytic, a_contact_too_small_to_be_stable_breaks_before_the_branch_does) {
  const PinnedDugdale law(100, 1e-6);
  const Contact turn = law.at(0.09, {});
  const double a = turn.radius, breaks = a * a - std::sqrt(8 * a / 3);
  ASSERT_LT(a, std::cbrt(1.0 / 6));
  ASSERT_GT(breaks, law.release());
  EXPECT_LT(law.at(breaks + 0.02, turn).force, 0);
  EXPECT_EQ(law.at(breaks - 0.02, turn).force, 0);
  const HeldCurve curve = law.curve(turn.held_edge);
  EXPECT_TRUE(curve.is_beyond(breaks - 0.02));
  EXPECT_FALSE(curve.is_beyond(breaks + 0.02));
  EXPECT_EQ(law.at(breaks - 0.02, turn, turn, &curve).force, 0);
}

}  // namespace
}  // namespace asperity
