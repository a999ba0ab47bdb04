// Spheres on rails, made from known powers, beside rolling and torsion of the same contact.
#include "dem_compare/resistance/rails.h"

#include <gtest/gtest.h>

#include "tests/dem_compare/resistance/known_studies.h"

namespace asperity {
namespace {

using namespace test;

TEST(Rails_analytic, resistance_about_the_axis_and_its_spin_come_back) {
  const TemporaryFolder root;
  const auto findings =
      find_resistances(collect_cases({test::write_moving_study(root.path, rails_beside_separate_motions())}));
  ASSERT_EQ(findings.study.contacts.size(), 1u);
  const auto& rails = findings.study.contacts[0].rails;
  ASSERT_EQ(rails.size(), 2u);
  for (const int which : {0, 1}) {
    const RailState& rail = rails[which];
    const double angle = (which == 0 ? 25 : 60) * degree;
    EXPECT_NEAR(rail.inclination, angle, 1e-5);
    const double c = std::cos(angle), s = std::sin(angle);
    const double expected = c * rolling_moment + share_of_torsion * s * torsion_moment,
                 sum = c * rolling_moment + s * torsion_moment;
    EXPECT_NEAR(rail.resistance.value / expected, 1, 1e-4);
    EXPECT_NEAR(rail.sum.value / sum, 1, 1e-4);
    EXPECT_NEAR(rail.over_sum().value, expected / sum, 1e-4);
    EXPECT_NEAR(rail.spin_over_torsion.value, share_of_torsion, 1e-4);
    EXPECT_NEAR(rail.parts.friction.value / (share_of_torsion * s * torsion_moment), 1, 1e-4);
    EXPECT_NEAR(rail.parts.adhesion.value / (c * rolling_moment), 1, 1e-4);
  }
}

TEST(Rails_analytic, resist_alike_whichever_way_they_roll_and_spin) {
  for (const int rolls : {1, -1})
    for (const int spins : {1, -1}) {
      const TemporaryFolder root;
      MovingFolder made = on_rail(45 * degree);
      made.rolls_towards = rolls, made.spins_towards = spins, made.hills = 0;
      const auto findings =
          find_resistances(collect_cases({test::write_moving_study(root.path, {{"1.5 nm", made}})}));
      ASSERT_EQ(findings.study.contacts.size(), 1u);
      ASSERT_EQ(findings.study.contacts[0].rails.size(), 1u);
      const RailState& rail = findings.study.contacts[0].rails[0];
      EXPECT_NEAR(rail.inclination, 45 * degree, 1e-5);
      EXPECT_NEAR(rail.spin_moment.value / made.spin_moment, 1, 1e-4) << rolls << spins;
      EXPECT_NEAR(rail.cases[0].first.force.value / (made.friction + made.adhesion), 1, 1e-4)
          << rolls << spins;
      EXPECT_NEAR(rail.resistance.value / (made.friction + made.adhesion), 1, 1e-4) << rolls << spins;
    }
}

TEST(Rails_behaviour, without_the_separate_motions_tell_their_resistance_alone) {
  const TemporaryFolder root;
  const auto findings = find_resistances(
      collect_cases({test::write_moving_study(root.path, {{"1.5 nm", on_rail(45 * degree)}})}));
  ASSERT_EQ(findings.study.contacts.size(), 1u);
  EXPECT_TRUE(std::isnan(findings.study.contacts[0].rails.at(0).sum.value));
}

TEST(Rails_behaviour, are_programs_of_one_part_that_rolls_and_spins) {
  const auto inclination = [](const std::string& type, const std::string& program) {
    SolvedCase solved;
    solved.entries = CaseEntries({{"Experiment/Type", type},
                                  {"Experiment/Program", program},
                                  {"Particle/Radius", "8.5 um"},
                                  {"Particle/Young modulus", "71 GPa"},
                                  {"Particle/Poisson ratio", "0.17"},
                                  {"Substrate/Young modulus", "179 GPa"},
                                  {"Substrate/Poisson ratio", "0.25"}});
    return rail_inclination(solved);
  };
  ASSERT_TRUE(inclination("program", "roll 850 nm and spin 100 mrad"));
  EXPECT_NEAR(*inclination("program", "roll 850 nm and spin -100 mrad"), 45 * degree, 1e-9);
  EXPECT_NEAR(*inclination("program", "roll 100 mrad and spin 173.205 mrad"), 60 * degree, 1e-6);
  for (const char* other : {"roll 850 nm", "spin 100 mrad", "roll 850 nm and spin 100 mrad and slide 3 nm",
                            "press 50 uN; roll 850 nm and spin 100 mrad"})
    EXPECT_FALSE(inclination("program", other)) << other;
  EXPECT_FALSE(inclination("rolling", "roll 850 nm and spin 100 mrad"));
}

}  // namespace
}  // namespace asperity
