// Partial slip under shear that turns: strips of the contact are cut to their limits one by one.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/dem_compare/laws/partial_slip_contact.h"

namespace asperity::test::partial_slip {
namespace {

TEST(PartialSlip_behaviour, shear_that_turns_converges_with_the_step_and_keeps_its_limit) {
  const auto circle = [&](int steps) {
    Contact contact;
    contact.press(load);
    SlidingHistory history = contact.history;
    Vector3d at = Vector3d::Zero();
    for (int i = 1; i <= steps; ++i) {
      const double angle = 4 * M_PI * i / steps;
      const Vector3d next = 0.8 * unit_shift() * Vector3d(std::sin(angle), 1 - std::cos(angle), 0);
      history = law.advance(history, contact.normal, next - at);
      at = next;
      EXPECT_LE(history.spring.resistance.norm(), mu * load * (1 + 1e-12));
      EXPECT_LE(history.profile.size(), 200u);
    }
    return history.spring.resistance;
  };
  const Vector3d coarse = circle(200), fine = circle(400), finest = circle(800);
  const double first = (coarse - fine).norm(), second = (fine - finest).norm();
  EXPECT_LT(second, 0.7 * first);  // first order halves the difference
  EXPECT_LT(second, 0.01 * mu * load);
}

/// 8 G* int u(x^2/R) dx over the contact by Simpson's rule, for a shift u(s) that a test knows.
Vector3d resistance_of_shift(double approach, const std::function<Vector3d(double)>& shift) {
  constexpr int panels = 20000;
  const double step = std::sqrt(radius * approach) / panels;
  const auto at = [&](double x) { return shift(std::min(approach, x * x / radius)); };
  Vector3d sum = Vector3d::Zero();
  for (int i = 0; i < panels; ++i)
    sum += step / 6 * (at(i * step) + 4 * at((i + 0.5) * step) + at((i + 1) * step));
  return 8 * shear * sum;
}

Vector3d cut(const Vector3d& shift, double limit) {
  return shift.norm() > limit ? Vector3d(shift * (limit / shift.norm())) : shift;
}

/// What the law says of its chords: error in size, and of direction in radians, over the limit.
void expect_within_chords(const Vector3d& force, const Vector3d& expected) {
  EXPECT_NEAR(force.norm() / (mu * load), expected.norm() / (mu * load), 6e-5);
  EXPECT_LT((force - expected).norm() / (mu * load), 4e-3);
}

TEST(PartialSlip_analytic, shear_that_turns_out_of_full_slip_is_cut_strip_by_strip) {
  for (const double angle : {0.05, 0.3, 1.0, 1.6, 2.2, 2.9, 3.1, -2.2})
    for (const double size : {0.1, 0.6, 1.0, 5.0}) {
      Contact contact;
      contact.press(load);
      contact.lead(load, 2 * unit_shift());
      const double approach = contact.normal.approach, kappa = unit_shift() / approach;
      const Vector3d step = size * unit_shift() * Vector3d(std::cos(angle), std::sin(angle), 0);
      const SlidingHistory turned = law.advance(contact.history, contact.normal, step);
      const Vector3d expected = resistance_of_shift(approach, [&](double s) {
        const double limit = kappa * (approach - s);
        return cut(limit * Vector3d::UnitX() + step, limit);
      });
      expect_within_chords(turned.spring.resistance, expected);
    }
}

/// Two turns: the inner strips slip one way and the outer ones another, with strips between them that stick.
TEST(PartialSlip_analytic, a_second_turn_cuts_what_the_first_has_left) {
  for (const double angle : {0.5, 1.5, 2.5, -1.0})
    for (const double size : {0.2, 0.7, 1.5}) {
      Contact contact;
      contact.press(load);
      contact.lead(load, 2 * unit_shift());
      const double approach = contact.normal.approach, kappa = unit_shift() / approach;
      const Vector3d first = -0.5 * unit_shift() * Vector3d::UnitX(),
                     second = size * unit_shift() * Vector3d(std::cos(angle), std::sin(angle), 0);
      SlidingHistory history = law.advance(contact.history, contact.normal, first);
      history = law.advance(history, contact.normal, second);
      const Vector3d expected = resistance_of_shift(approach, [&](double s) {
        const double limit = kappa * (approach - s);
        return cut(cut(limit * Vector3d::UnitX() + first, limit) + second, limit);
      });
      expect_within_chords(history.spring.resistance, expected);
    }
}

/// With an offset h the limit of a strip, kappa (delta - s), has another slope at another load: strips that
/// were sheared under a small load may be steeper than the limit under a larger one.
TEST(PartialSlip_analytic, strips_sheared_under_another_load_are_cut_to_the_present_limit) {
  MindlinDeresiewicz sticky = law;
  const Hertz contact{hertz.reduced_modulus, radius};
  sticky.friction.adhesion_force = contact.force(1e-9 / 0.36);  // a^3 = h at an approach of 2.78 nm
  const auto at = [&](double approach) { return hertz.advance({}, approach); };
  const auto kappa = [&](const NormalState& normal) {
    return sticky.gross_slip_shift(normal) / normal.approach;
  };
  const NormalState low = at(0.25 / 0.36 * 1e-9), high = at(1e-9);
  const SlidingHistory pressed = sticky.advance({}, low, Vector3d::Zero());
  const SlidingHistory slid =
      sticky.advance(pressed, low, 3 * sticky.gross_slip_shift(low) * Vector3d::UnitX());
  const double first = kappa(low), second = kappa(high);
  ASSERT_GT(first, 1.3 * second);
  for (const double back : {0.0, 0.2, 0.35, 0.6, 1.0}) {
    const Vector3d step = -back * sticky.gross_slip_shift(high) * Vector3d::UnitX();
    const SlidingHistory now = sticky.advance(slid, high, step);
    const Vector3d expected = resistance_of_shift(high.approach, [&](double s) {
      const Vector3d before = s < low.approach
                                  ? Vector3d(first * (low.approach - s) * Vector3d::UnitX() + step)
                                  : Vector3d(step * ((high.approach - s) / (high.approach - low.approach)));
      return cut(before, second * (high.approach - s));
    });
    EXPECT_NEAR(now.spring.resistance.x() / sticky.friction.limit(high.force),
                expected.x() / sticky.friction.limit(high.force), 1e-7)
        << back;
  }
}

}  // namespace
}  // namespace asperity::test::partial_slip
