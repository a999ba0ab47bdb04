#include <gtest/gtest.h>

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <functional>
#include <map>

#include "core/csv.h"
#include "core/shear_moduli.h"
#include "dem_compare/laws/hertz_offset.h"
#include "dem_compare/laws/linear_sliding.h"
#include "dem_compare/laws/mindlin.h"
#include "dem_compare/laws/mindlin_deresiewicz.h"
#include "tests/support/shared_files.h"
#include "tests/support/verification.h"

namespace asperity {
namespace {

using Eigen::Vector3d;
constexpr double radius = 8.5e-6, mu = 0.3, load = 1e-4;
const ElasticBody borosilicate{71e9, 0.17}, silicon{179e9, 0.25};
const HertzOffset hertz{reduced_modulus(borosilicate, silicon), radius, 0};
const double shear = reduced_shear_modulus(borosilicate, silicon);
const MindlinDeresiewicz law{shear, radius, {mu, 0}};
const Mindlin no_slip{shear, {mu, 0}};

/// One contact of Hertz with partial slip, led along straight lines of approach and shift.
struct Contact {
  NormalState normal;
  SlidingHistory history;
  double shift = 0;

  void press(double force) { lead(force, shift); }
  void lead(double force, double to_shift, Vector3d direction = Vector3d::UnitX()) {
    normal = hertz.advance(normal, hertz.approach(force));
    history = law.advance(history, normal, (to_shift - shift) * direction);
    shift = to_shift;
  }
  double force() const { return history.spring.resistance.x(); }
  /// Shift that reaches a lateral force, with the load changing to `normal_force` on the way, in `steps`
  /// parts.
  void lead_to_force(double normal_force, double lateral_force, int steps = 1) {
    const double first_load = normal.force, first_force = force();
    for (int i = 1; i <= steps; ++i) {
      const double p = first_load + (normal_force - first_load) * i / steps,
                   q = first_force + (lateral_force - first_force) * i / steps;
      const double reach =
          4 * law.gross_slip_shift(hertz.advance({}, hertz.approach(std::max(p, first_load))));
      std::uintmax_t iterations = 200;
      const auto missing = [&](double to) {
        Contact trial = *this;
        trial.lead(p, to);
        return trial.force() - q;
      };
      const auto bracket = boost::math::tools::toms748_solve(
          missing, shift - reach, shift + reach, boost::math::tools::eps_tolerance<double>(), iterations);
      lead(p, (bracket.first + bracket.second) / 2);
    }
  }
};

/// 3 mu P/(16 G* a), the shift at gross slip under the first load.
double unit_shift() { return law.gross_slip_shift(hertz.advance({}, hertz.approach(load))); }
double virgin_shift(double q) { return 1 - std::pow(1 - q, 2.0 / 3); }

test::Verified partial_slip(const std::string& what, const std::string& source) {
  return {"Reduced laws", "partial slip with history: " + what, source};
}

TEST(PartialSlip_analytic, virgin_curve_is_that_of_Cattaneo_and_Mindlin) {
  test::Largest error;
  for (const double q : {0.05, 0.3, 0.6, 0.9, 0.99}) {
    Contact contact;
    contact.press(load);
    contact.lead(load, virgin_shift(q) * unit_shift());
    error.count(contact.force() / (mu * load) - q);
  }
  EXPECT_TRUE(partial_slip("virgin curve, force", "Cattaneo (1938)").below(error, 1e-12, "mu P"));
}

TEST(PartialSlip_analytic, force_does_not_depend_on_the_number_of_steps_along_one_line) {
  Contact one, many;
  one.press(load);
  many.press(load);
  one.lead(load, 0.7 * unit_shift());
  for (int i = 1; i <= 1000; ++i) many.lead(load, 0.7 * unit_shift() * i / 1000);
  EXPECT_NEAR(one.force() / many.force(), 1, 1e-12);
  EXPECT_LE(many.history.profile.size(), 4u);  // stick, slip, edge: straight nodes are dropped
}

TEST(PartialSlip_analytic, gross_slip_is_Coulombs_limit_and_begins_at_the_gross_slip_shift) {
  Contact contact;
  contact.press(load);
  contact.lead(load, 0.999 * unit_shift());
  EXPECT_FALSE(contact.history.spring.yields);
  contact.lead(load, 1.001 * unit_shift());
  EXPECT_TRUE(contact.history.spring.yields);
  EXPECT_NEAR(contact.force() / (mu * load), 1, 1e-12);
  contact.lead(load, 200 * unit_shift());
  EXPECT_NEAR(contact.force() / (mu * load), 1, 1e-12);
}

TEST(PartialSlip_analytic, initial_stiffness_is_8_G_a_also_after_each_reversal) {
  Contact contact;
  contact.press(load);
  const double a = contact.normal.contact_radius, step = 1e-7 * unit_shift();
  for (const double to : {0.8, -0.5, 0.2}) {
    const double before = contact.force();
    const double sign = to * unit_shift() > contact.shift ? 1 : -1;
    contact.lead(load, contact.shift + sign * step);
    EXPECT_NEAR((contact.force() - before) / (sign * step) / (8 * shear * a), 1, 1e-6);
    contact.lead(load, to * unit_shift());
  }
}

TEST(PartialSlip_analytic, each_branch_is_the_virgin_curve_at_twice_the_size_as_Masing_says) {
  Contact contact;
  contact.press(load);
  const double top = virgin_shift(0.8);
  contact.lead(load, top * unit_shift());
  test::Largest error;
  for (const double q : {0.6, 0.1, -0.5, -0.79}) {
    contact.lead(load, (top - 2 * virgin_shift((0.8 - q) / 2)) * unit_shift());
    error.count(contact.force() / (mu * load) - q);
  }
  EXPECT_TRUE(partial_slip("way back, force", "Masing's rule").below(error, 1e-12, "mu P"));
}

TEST(PartialSlip_analytic, a_closed_inner_loop_is_forgotten) {
  Contact with, without;
  for (Contact* contact : {&with, &without}) {
    contact->press(load);
    contact->lead(load, 0.6 * unit_shift());
  }
  with.lead(load, 0.2 * unit_shift());
  with.lead(load, 0.4 * unit_shift());
  with.lead(load, 0.2 * unit_shift());
  for (Contact* contact : {&with, &without}) contact->lead(load, 0.75 * unit_shift());
  EXPECT_NEAR(with.force() / without.force(), 1, 1e-12);
}

TEST(PartialSlip_other_code, shift_and_loop_energy_agree_with_the_reference) {
  const auto path = asperity::test::reference_table("03_mindlin_table_Qdelta.csv");
  const CsvTable table = read_csv(path);
  const auto q = table.numbers("Q_over_muP"), shift = table.numbers("delta_over_delta_gs"),
             energy = table.numbers("loop_energy_over_muP_delta_gs(closed)");
  ASSERT_GE(q.size(), 10u);
  test::Largest force, loop;
  for (std::size_t i = 0; i < q.size(); ++i) {
    Contact contact;
    contact.press(load);
    contact.lead(load, shift[i] * unit_shift());
    force.count(contact.force() / (mu * load) - q[i]);
    // One cycle, its work by Simpson's rule. The rule meets cusps of power 5/3 at the ends: refined there by
    // a power law.
    double work = 0;
    constexpr int panels = 400;
    for (const double end : {-1.0, 1.0}) {
      const double from = contact.shift, to = end * shift[i] * unit_shift();
      const auto place = [&](double t) { return from + (to - from) * t * t * t; };
      double before = contact.force(), at = from;
      for (int k = 1; k <= panels; ++k) {
        const double next = place(double(k) / panels);
        contact.lead(load, (at + next) / 2);
        const double middle = contact.force();
        contact.lead(load, next);
        work += (next - at) * (before + 4 * middle + contact.force()) / 6;
        before = contact.force();
        at = next;
      }
    }
    loop.count((work / (mu * load * unit_shift()) - energy[i]) / (energy[i] + 1e-3));
  }
  EXPECT_TRUE(partial_slip("force at a shift", "table, closed form")
                  .below(force, 3e-8, "mu P"));  // eight digits in the table
  EXPECT_TRUE(partial_slip("energy of a loop", "table, quadrature").below(loop, 1e-6));
}

TEST(PartialSlip_other_code, histories_with_changing_load_agree_with_the_reference) {
  const auto path = asperity::test::reference_table("03_mindlin_table_histories.csv");
  const CsvTable table = read_csv(path);
  std::map<std::string, double> expected;
  const auto closed = table.numbers("delta_t_over_D0_closed_form (D0=3muP0/(16G*a0))");
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    expected[table.rows[i][0].substr(0, 3) +
             (table.rows[i][0].find("alpha=") != std::string::npos
                  ? table.rows[i][0].substr(table.rows[i][0].find("alpha=0."))
                  : table.rows[i][0].substr(2, 8)) +
             "|" + table.rows[i][1]] = closed[i];
  const double force = mu * load;
  std::vector<double> values;
  const auto note = [&](const Contact& contact) { values.push_back(contact.shift / unit_shift()); };

  Contact h1;
  h1.press(load);
  for (const double q : {0.6, 0.0, -0.6, 0.0, 0.6}) {
    h1.lead_to_force(load, q * force);
    note(h1);
  }
  for (const double alpha :
       {0.15, 0.25, 0.29}) {  // a straight line of approach and shift is one of load and shear too
    Contact h2;
    h2.lead_to_force(load, alpha * load);
    note(h2);
  }
  Contact h3;
  h3.press(load);
  h3.lead_to_force(load, 0.5 * force);
  note(h3);
  h3.lead_to_force(2 * load, 0.5 * force);
  note(h3);
  Contact h3b = h3;
  h3.lead_to_force(2 * load, 0.9 * 2 * force);
  note(h3);
  h3b.lead_to_force(2 * load, 1.2 * force);
  note(h3b);
  Contact h4;
  h4.press(load);
  h4.lead_to_force(load, 0.5 * force);
  h4.lead_to_force(0.7 * load, 0.5 * force,
                   2000);  // constant shear is no straight line: of second order in the step
  note(h4);
  ASSERT_EQ(values.size(), closed.size());
  test::Largest straight;
  for (std::size_t i = 0; i + 1 < values.size(); ++i) straight.count(values[i] - closed[i]);
  const std::string unit = "of full slip's shift", table_of = "table, closed form";
  EXPECT_TRUE(partial_slip("shift in histories H1 to H3 and oblique loading", table_of)
                  .below(straight, 5e-8, unit));  // digits of the table
  EXPECT_TRUE(partial_slip("shift as the load falls at constant shear (H4), 2000 steps", table_of)
                  .below(values.back() - closed.back(), 1e-6, unit));
}

TEST(PartialSlip_analytic,
     oblique_loading_below_the_coefficient_sticks_everywhere_and_above_it_slips_everywhere) {
  for (const double ratio : {0.1, 0.5, 0.9, 1.1, 2.0}) {
    Contact contact;
    contact.lead(load, ratio * unit_shift());
    EXPECT_NEAR(contact.force() / (mu * load), std::min(1.0, ratio), 1e-12);
  }
}

TEST(PartialSlip_analytic,
     after_unloading_and_reloading_without_shear_only_the_contact_that_lasted_remembers) {
  Contact contact;
  contact.press(load);
  contact.lead(load, 0.5 * unit_shift());
  contact.press(0.3 * load);
  const double remembered = contact.force();
  EXPECT_NEAR(remembered / (mu * 0.3 * load), 1, 1e-12);  // 0.65 mu P0 cannot be carried by 0.3 P0
  contact.press(load);
  EXPECT_NEAR(contact.force() / remembered, 1, 1e-12);
}

TEST(PartialSlip_analytic, closed_cycles_of_load_and_shear_never_give_energy) {
  // The cycle of Elata and Berryman: shear at the high load, back at the low one, and the other way round.
  for (const double sign : {1.0, -1.0}) {
    Contact contact;
    double work = 0;
    const auto go = [&](double force, double to) {
      constexpr int steps = 200;
      const double from_load = contact.normal.force, from = contact.shift;
      for (int i = 1; i <= steps; ++i) {
        const double before = contact.force(), at = contact.shift;
        contact.lead(from_load + (force - from_load) * i / steps, from + (to - from) * i / steps);
        work += (before + contact.force()) / 2 * (contact.shift - at);
      }
    };
    contact.press(load);
    go(load, sign * 0.4 * unit_shift());
    for (int cycle = 0; cycle < 3; ++cycle) {
      work = 0;
      go(0.5 * load, contact.shift);
      go(0.5 * load, 0);
      go(load, 0);
      go(load, sign * 0.4 * unit_shift());
      EXPECT_GT(work, 0);
    }
  }
}

TEST(PartialSlip_analytic, force_and_history_turn_with_the_contact) {
  Contact contact;
  contact.press(load);
  contact.lead(load, 0.7 * unit_shift());
  contact.lead(load, 0.1 * unit_shift());
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.9, Vector3d(0.2, -0.5, 1).normalized()));
  SlidingHistory turned = contact.history;
  turned.rotate(turn);
  const Vector3d step = 0.4 * unit_shift() * Vector3d(0.6, 0.8, 0);
  const Vector3d plain = law.advance(contact.history, contact.normal, step).spring.resistance;
  const Vector3d both = law.advance(turned, contact.normal, turn * step).spring.resistance;
  EXPECT_LT((both - turn * plain).norm(), 1e-12 * mu * load);
}

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

TEST(PartialSlip_analytic, adhesion_offset_raises_the_limit_and_keeps_the_curve) {
  MindlinDeresiewicz sticky = law;
  sticky.friction.adhesion_force = 12e-6;
  const NormalState normal = hertz.advance({}, hertz.approach(load));
  const double limit = mu * (load + 12e-6), gross = sticky.gross_slip_shift(normal);
  EXPECT_NEAR(sticky.advance({{}, {}}, normal, 2 * gross * Vector3d::UnitX()).spring.resistance.x() / limit,
              1, 1e-12);
  const SlidingHistory pressed = sticky.advance({}, normal, Vector3d::Zero());
  EXPECT_NEAR(
      sticky.advance(pressed, normal, virgin_shift(0.5) * gross * Vector3d::UnitX()).spring.resistance.x() /
          limit,
      0.5, 1e-12);
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

TEST(PartialSlip_analytic, without_area_there_is_no_lateral_force) {
  MindlinDeresiewicz sticky = law;
  sticky.friction.adhesion_force = 1e-5;
  const SlidingHistory point = sticky.advance({}, {0, 0, 0, 0, true}, 1e-9 * Vector3d::UnitX());
  EXPECT_EQ(point.spring.resistance.norm(), 0);
  EXPECT_TRUE(point.profile.empty());
}

TEST(PartialSlip_analytic, tells_its_stiffness_and_whether_the_whole_contact_slips) {
  Contact contact;
  contact.press(load);
  contact.lead(load, 0.5 * unit_shift());
  EXPECT_NEAR(contact.history.spring.stiffness / (8 * shear * contact.normal.contact_radius), 1, 1e-14);
  EXPECT_FALSE(contact.history.spring.yields);
  contact.lead(load, -2 * unit_shift());
  EXPECT_TRUE(contact.history.spring.yields);
  EXPECT_NEAR(contact.force() / (mu * load), -1, 1e-12);
}

TEST(Coulomb_analytic, limit_is_mu_times_load_and_offset_and_never_negative) {
  const CoulombLimit friction{0.25, 4};
  EXPECT_EQ(friction.limit(8), 3);
  EXPECT_EQ(friction.limit(-2), 0.5);
  EXPECT_EQ(friction.limit(-4), 0);
  EXPECT_EQ(friction.limit(-10), 0);
}

TEST(LinearSliding_analytic, keeps_its_stiffness_at_any_load) {
  const LinearSliding linear{1e4, {mu, 0}};
  SlidingHistory history =
      linear.advance({}, hertz.advance({}, hertz.approach(load)), 1e-10 * Vector3d::UnitY());
  EXPECT_NEAR(history.spring.resistance.y(), 1e-6, 1e-20);
  history = linear.advance(history, hertz.advance({}, hertz.approach(0.5 * load)), Vector3d::Zero());
  EXPECT_NEAR(history.spring.resistance.y(), 1e-6, 1e-20);
}

TEST(Mindlin_analytic, stiffness_is_8_G_a_up_to_Coulombs_limit) {
  const NormalState normal = hertz.advance({}, hertz.approach(load));
  const double k = 8 * shear * normal.contact_radius;
  EXPECT_NEAR(k, 2.1645e4, 0.5);  // borosilicate on silicon at 100 uN: five digits
  SlidingHistory history = no_slip.advance({}, normal, 0.5e-9 * Vector3d::UnitX());
  EXPECT_NEAR(history.spring.resistance.x() / (k * 0.5e-9), 1, 1e-14);
  history = no_slip.advance(history, normal, 10e-9 * Vector3d::UnitX());
  EXPECT_TRUE(history.spring.yields);
  EXPECT_NEAR(history.spring.resistance.x() / (mu * load), 1, 1e-14);
}

/// Work of the cycle of Elata and Berryman (1996): shear at the high load, unload, shear back, reload.
double work_of_cycle(const Mindlin& mindlin) {
  const NormalState high = hertz.advance({}, hertz.approach(load)),
                    low = hertz.advance({}, hertz.approach(0.2 * load));
  const Vector3d shift = 0.1e-9 * Vector3d::UnitX();
  SlidingHistory history = mindlin.advance({}, high, Vector3d::Zero());
  double work = 0;
  const auto go = [&](const NormalState& normal, const Vector3d& step) {
    const SlidingHistory next = mindlin.advance(history, normal, step);
    work += (history.spring.resistance + next.spring.resistance).dot(step) / 2;
    history = next;
  };
  go(high, shift);
  go(low, Vector3d::Zero());
  go(low, -shift);
  go(high, Vector3d::Zero());
  return work;
}

TEST(Mindlin_analytic, plain_increments_create_energy_where_rescaling_on_unloading_spends_it) {
  Mindlin plain = no_slip, rescaled = no_slip;
  plain.friction.coefficient = rescaled.friction.coefficient = 1e3;  // no slip anywhere
  plain.changing_load = ChangingLoad::plain;
  const double high = 8 * shear * hertz.advance({}, hertz.approach(load)).contact_radius,
               low = 8 * shear * hertz.advance({}, hertz.approach(0.2 * load)).contact_radius;
  EXPECT_NEAR(work_of_cycle(plain) / (-(high - low) * 1e-20 / 2), 1, 1e-10);
  EXPECT_NEAR(work_of_cycle(rescaled) / ((high - low) * 1e-20 / 2), 1, 1e-10);
}

TEST(SlidingLaw_behaviour, a_contact_that_opened_forgets) {
  const NormalState closed = hertz.advance({}, hertz.approach(load)), open = hertz.advance(closed, -1e-9);
  for (const SlidingLaw& any :
       {SlidingLaw(no_slip), SlidingLaw(law), SlidingLaw(LinearSliding{1e4, {mu, 0}})}) {
    SlidingHistory history = any->advance({}, closed, 0.3e-9 * Vector3d::UnitX());
    EXPECT_GT(history.spring.resistance.x(), 0);
    history = any->advance(history, open, 0.3e-9 * Vector3d::UnitX());
    EXPECT_EQ(history.spring.resistance.norm(), 0);
    EXPECT_TRUE(history.profile.empty());
  }
}

TEST(ShearModuli_analytic, values_for_the_paper_are_those_of_the_correct_formula) {
  EXPECT_NEAR(shear / 1e9, 11.7989, 5e-5);
  EXPECT_NEAR(reduced_shear_modulus(borosilicate, {1140e9, 0.07}) / 1e9, 15.6407, 5e-5);
  EXPECT_NEAR(torsion_modulus(borosilicate, silicon) / 1e9, 21.311, 5e-4);
}

}  // namespace
}  // namespace asperity
