// A sphere pressed and then shifted: Cattaneo (1938), Mindlin (1949), Mindlin & Deresiewicz (1953); Johnson
// (1985), ch. 7. Equal bodies: pressure and shear do not couple.
#include <gtest/gtest.h>

#include <vector>

#include "tests/fem/support/frictional_contact.h"
#include "tests/support/verification.h"

namespace {

using asperity::test::FrictionalContact;

/// Shift over that of full slip, on first loading to a force over mu P.
double cattaneo_shift(double force) { return 1 - std::pow(1 - force, 2.0 / 3); }

/// Shift of full slip, 3 mu P / (16 G* a).
double full_slip(const FrictionalContact& contact) {
  return 3 * contact.friction_force / (16 * contact.system.reduced_shear_modulus() * contact.contact_radius);
}

/// Force over mu P and shift, without the finite bodies' own, over that of full slip; reaction less tractions
/// over mu P.
struct Point {
  double force, shift, unbalanced;
};
Point shift_to(FrictionalContact& contact, double ratio) {
  const auto r = contact.shift(ratio * full_slip(contact));
  EXPECT_NEAR(r.lateral_reaction[0], r.lateral_force[0], 1e-6 * contact.friction_force);
  EXPECT_LT(std::abs(r.lateral_force[1]), 1e-3 * contact.friction_force);
  const Point p{
      r.lateral_force[0] / contact.friction_force,
      (contact.state.motion.x - contact.lateral_far_field * r.lateral_force[0]) / full_slip(contact),
      (r.lateral_reaction[0] - r.lateral_force[0]) / contact.friction_force};
  std::printf("Q/muP %+.4f  shift %+.4f  sticking %d of %d  newton %d cg %d\n", p.force, p.shift, r.sticking,
              r.active, contact.newton, contact.linear);
  return p;
}

void expect_glued_stiffness(double cells) {
  asperity::test::FrictionalContactOptions o;
  o.cells_per_radius = cells;
  FrictionalContact contact(o);
  const double expected = 8 * contact.system.reduced_shear_modulus() * contact.contact_radius;
  const double measured =
      1 / (1 / contact.solver.lateral_stiffness(contact.state) - contact.lateral_far_field);
  // Glued nodes make the contact wider by part of a spacing: first order in the spacing, 2 % at 12 cells.
  const std::string place = "a/h " + std::to_string(std::lround(cells)) +
                            (cells < 12 ? " (2 % wanted, which finer meshes meet)" : "");
  const asperity::test::Verified verified{"Sliding", "lateral stiffness without slip, " + place,
                                          "8 G* a, Mindlin (1949)"};
  EXPECT_TRUE(verified.within(measured, expected, 0.24 / cells));
}

TEST(Mindlin_analytic, stiffness_without_slip_approaches_8_G_a) {
  for (const double cells : {8.0, 12.0, 18.0}) expect_glued_stiffness(cells);
}

/// Cattaneo's and Mindlin's bodies are half-spaces. Of a sphere of which the contact is 0.03 radii wide, part
/// of the traction is not theirs, of the order of these 0.03, on any mesh; this one's is 0.003. Cells that
/// grow fast away from the contact add another part that does not fall with the spacing.
asperity::test::FrictionalContactOptions nearly_half_spaces(double cells) {
  asperity::test::FrictionalContactOptions o;
  o.load = 100e-9;
  o.layers = 8;
  o.slip_tolerance = 1e-3;
  o.cells_per_radius = cells;
  return o;
}

/// Shifts in parts of full slip's. The traction peaks at the border of sticking, in a ring of which some
/// spacings must fit between that and the rim: it is compared where the stick radius is below
/// `traction_below` contact radii.
void expect_cattaneo(double cells, const std::vector<double>& ratios, double traction_below) {
  FrictionalContact contact(nearly_half_spaces(cells));
  const double a = contact.contact_radius, h = contact.system.options().mesh.sizes.spacing_particle;
  for (const double ratio : ratios) {
    const Point p = shift_to(contact, ratio);
    char place[64];
    std::snprintf(place, sizeof place, ", shift %g of full slip's, a/h %g", ratio, cells);
    const auto verified = [&](const char* what) {
      return asperity::test::Verified{"Sliding", what + std::string(place), "Cattaneo (1938)"};
    };
    EXPECT_TRUE(verified("shift").within(p.shift, cattaneo_shift(p.force), 0.02));
    const double stick_radius = a * std::cbrt(1 - p.force), p0 = 1.5 * contact.options.load / (M_PI * a * a);
    double difference = 0, size = 0;
    int misplaced = 0;  // nodes more than a spacing from the border of sticking that are on its wrong side
    for (std::size_t r = 0; r < contact.system.rows().size(); ++r) {
      const auto& x = contact.system.interface_points()[contact.system.rows()[r].node];
      const double radius = std::hypot(x[0], x[1]), area = contact.system.areas()[r];
      const auto dome = [&](double outer) {
        return radius < outer ? std::sqrt(1 - radius * radius / (outer * outer)) : 0.0;
      };
      const double expected =
          contact.options.friction * p0 * (dome(a) - stick_radius / a * dome(stick_radius));
      const double measured = -contact.state.shear[0][r];
      difference += area * std::pow(measured - expected, 2), size += area * expected * expected;
      if (radius > a - 0.5 * h)
        continue;  // the rim, where pressures are a small fraction of what they are one node further in
      const double used = std::hypot(measured, contact.state.shear[1][r]) /
                          (contact.options.friction * contact.state.multiplier[r]);
      const bool slips = used > 0.995;
      const bool is_misplaced = (radius < stick_radius - h && slips) || (radius > stick_radius + h && !slips);
      misplaced += is_misplaced;
      if (is_misplaced)
        std::printf("  a node %.2f spacings outside the border of sticking uses %.4f of its friction\n",
                    (radius - stick_radius) / h, used);
    }
    EXPECT_TRUE(verified("nodes more than a spacing on the wrong side of sticking").below(misplaced, 0));
    std::printf("  stick radius %.3f a: traction differs by %.2f %% in the 2-norm\n", stick_radius / a,
                100 * std::sqrt(difference / size));
    if (stick_radius < traction_below * a) {
      EXPECT_TRUE(verified("traction in the 2-norm").below(100 * std::sqrt(difference / size), 3, "%"));
    }
  }
  const Point p = shift_to(contact, 1.1);
  EXPECT_NEAR(p.force, 1, 1e-3);
}

TEST(Mindlin_analytic, force_stick_radius_and_traction_follow_Cattaneo_to_full_slip) {
  expect_cattaneo(18, {0.05, 0.3, 0.55, 0.8}, 0.7);
}
TEST(MindlinNightly_analytic, traction_of_a_slip_ring_of_a_seventh_of_the_radius_follows_Cattaneo) {
  expect_cattaneo(36, {0.3, 0.55}, 0.85);
}
TEST(MindlinNightly_analytic, traction_of_a_slip_ring_of_a_fortieth_of_the_radius_nears_Cattaneo) {
  expect_cattaneo(72, {0.05, 0.3}, 0.85);
}

/// Loaded to Q* and unloaded to no force: what slipped one way now slips the other in a ring of its own,
/// between them stress is locked in (Mindlin & Deresiewicz 1953; Johnson 1985, eq. 7.47).
double error_of_unloaded_traction(double cells) {
  const auto o = nearly_half_spaces(cells);
  FrictionalContact contact(o);
  const double a = contact.contact_radius;
  const Point top = shift_to(contact, 0.75);
  const auto shift_of = [&](double force) { return top.shift - 2 * cattaneo_shift((top.force - force) / 2); };
  // Without force the finite bodies' own shift is none.
  const Point end = shift_to(contact, shift_of(0));
  EXPECT_NEAR(end.force, 0, 0.01);
  EXPECT_NEAR(end.shift, shift_of(end.force), 0.01);
  const double stuck = a * std::cbrt(1 - top.force),
               stuck_since = a * std::cbrt(1 - (top.force - end.force) / 2);
  const double limit = o.friction * 1.5 * o.load / (M_PI * a * a);
  double difference = 0, size = 0;
  for (std::size_t r = 0; r < contact.system.rows().size(); ++r) {
    const auto& x = contact.system.interface_points()[contact.system.rows()[r].node];
    const double radius = std::hypot(x[0], x[1]), area = contact.system.areas()[r];
    const auto dome = [&](double outer) {
      return radius < outer ? outer / a * std::sqrt(1 - radius * radius / (outer * outer)) : 0.0;
    };
    const double expected = limit * (dome(a) - dome(stuck) - 2 * (dome(a) - dome(stuck_since)));
    difference += area * std::pow(-contact.state.shear[0][r] - expected, 2),
        size += area * expected * expected;
  }
  std::printf(
      "%g cells: unloaded traction differs by %.2f %% in the 2-norm (stuck %.3f a, since the turn %.3f a)\n",
      cells, 100 * std::sqrt(difference / size), stuck / a, stuck_since / a);
  return std::sqrt(difference / size);
}

/// Its norm is half of that at the turn, and the errors of both rings are in it.
TEST(MindlinNightly_analytic, traction_that_unloading_locks_in_has_both_rings) {
  const asperity::test::Verified verified{
      "Sliding", "traction left after unloading from Q/(mu P) 0.87, 2-norm, of its own, a/h 36",
      "Mindlin & Deresiewicz (1953)"};
  EXPECT_TRUE(verified.below(100 * error_of_unloaded_traction(36), 3, "%"));
}

/// Friction would hold five times the load: what stuck, and leaves within one step, slips under the shear
/// that it had and not under that limit.
TEST(Mindlin_analytic, contact_that_is_lifted_at_once_dissipates_what_its_shear_had_stored) {
  asperity::test::FrictionalContactOptions o;
  o.friction = 5, o.cells_per_radius = 8;
  FrictionalContact contact(o);
  const double glued = 8 * contact.system.reduced_shear_modulus() * contact.contact_radius;
  const auto shifted = contact.shift(0.3 * o.load * (1 / glued + contact.lateral_far_field));
  const double stored = 0.5 * shifted.lateral_force[0] * contact.state.motion.x;
  EXPECT_NEAR(shifted.lateral_force[0], 0.3 * o.load, 0.03 * 0.3 * o.load);
  EXPECT_LT(contact.friction_work, 0.05 * stored);
  contact.step(contact.state.motion, 1e-3 * o.load);
  EXPECT_TRUE((asperity::test::Verified{"Sliding", "glued contact lifted in one step: dissipated [J]",
                                        "half of force and shift, which its shear had stored"}
                   .within(contact.friction_work, stored, 0.01)));
}

TEST(Mindlin_analytic, loop_follows_Masings_rule_and_dissipates_what_Mindlin_and_Deresiewicz_found) {
  FrictionalContact contact({});
  const double amplitude = 0.6;
  const Point top = shift_to(contact, amplitude);
  double dissipated = 0, work = 0, before = contact.state.motion.x, force = top.force;
  asperity::test::Largest masing, unbalanced;
  const auto go = [&](double ratio) {
    const Point p = shift_to(contact, ratio);
    unbalanced.count(p.unbalanced);
    work += 0.5 * (force + p.force) * contact.friction_force * (contact.state.motion.x - before);
    before = contact.state.motion.x, force = p.force;
    EXPECT_GE(contact.friction_work, 0);
    dissipated += contact.friction_work;
    return p;
  };
  for (const double ratio : {0.45, 0.2, -0.1, -0.4}) {
    const Point p = go(ratio);
    // Unloading is the first loading, twice as large: the drop of the shift from the top.
    const double expected = top.shift - 2 * cattaneo_shift((top.force - p.force) / 2);
    masing.count(p.shift - expected);
  }
  const auto verified = [](const std::string& what, const char* source) {
    return asperity::test::Verified{"Sliding", what, source};
  };
  EXPECT_TRUE(verified("way back of a loop, a/h 12", "Masing's rule on Cattaneo (1938)")
                  .below(masing, 0.01, "of full slip's shift"));
  const Point bottom = go(-amplitude);
  EXPECT_NEAR(bottom.force, -top.force, 2e-3);
  for (const double ratio : {-0.45, -0.2, 0.1, 0.4}) go(ratio);
  const Point end = go(amplitude);
  EXPECT_NEAR(end.force, top.force, 2e-3);
  // Energy of a cycle between +-Q* (Mindlin & Deresiewicz 1953; Johnson 1985, eq. 7.51), both bodies.
  const double x = top.force, mp = contact.friction_force;
  const double expected = 0.9 * mp * mp / (contact.system.reduced_shear_modulus() * contact.contact_radius) *
                          (1 - std::pow(1 - x, 5.0 / 3) - 5 * x / 6 * (1 + std::pow(1 - x, 2.0 / 3)));
  std::printf("loop energy %.5g J dissipated by slip, %.5g J work of the shift; expected %.5g J (%+.2f %%)\n",
              dissipated, work, expected, 100 * (dissipated / expected - 1));
  EXPECT_TRUE(verified("energy of a loop between +-0.68 mu P, a/h 12", "Mindlin & Deresiewicz (1953)")
                  .within(dissipated, expected, 0.03));
  EXPECT_TRUE(verified("lateral reaction against tractions along that loop", "balance")
                  .below(unbalanced, 1e-6, "mu P"));
  EXPECT_NEAR(work, expected, 0.1 * expected);  // trapezia over ten steps
}

}  // namespace
