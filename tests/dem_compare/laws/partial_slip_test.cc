#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/csv.h"
#include "tests/dem_compare/laws/partial_slip_contact.h"
#include "tests/support/shared_files.h"
#include "tests/support/verification.h"

namespace asperity::test::partial_slip {
namespace {

Verified verified(const std::string& what, const std::string& source) {
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
  EXPECT_TRUE(verified("virgin curve, force", "Cattaneo (1938)").below(error, 1e-12, "mu P"));
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
  EXPECT_TRUE(verified("way back, force", "Masing's rule").below(error, 1e-12, "mu P"));
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
  EXPECT_TRUE(verified("force at a shift", "table, closed form")
                  .below(force, 3e-8, "mu P"));  // eight digits in the table
  EXPECT_TRUE(verified("energy of a loop", "table, quadrature").below(loop, 1e-6));
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
  EXPECT_TRUE(verified("shift in histories H1 to H3 and oblique loading", table_of)
                  .below(straight, 5e-8, unit));  // digits of the table
  EXPECT_TRUE(verified("shift as the load falls at constant shear (H4), 2000 steps", table_of)
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

}  // namespace
}  // namespace asperity::test::partial_slip
