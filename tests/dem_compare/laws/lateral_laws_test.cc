// Lateral laws without partial slip, and what all of them do.
#include <gtest/gtest.h>

#include "dem_compare/laws/linear_sliding.h"
#include "dem_compare/laws/mindlin.h"
#include "tests/dem_compare/laws/partial_slip_contact.h"

namespace asperity::test::partial_slip {
namespace {

const Mindlin no_slip{shear, {mu, 0}};

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
}  // namespace asperity::test::partial_slip
