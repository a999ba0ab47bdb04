// What effects say in a case: the entries that stand for them.
#include <gtest/gtest.h>

#include <cmath>

#include "diagnosis/catalogue/effect.h"
#include "tests/diagnosis/support/made_recording.h"

namespace asperity {
namespace {

using test::nm;

constexpr double radius_in_case = 8.5e-6;
const ElasticBody particle_in_case{71e9, 0.17}, substrate_in_case{179e9, 0.25};

TEST(EffectsInCase_analytic, a_bridge_is_attraction_out_to_where_it_ruptures) {
  Experiment e;
  e.particle = particle_in_case, e.substrate = substrate_in_case, e.radius = radius_in_case,
  e.largest_force = 100e-6;
  const double of_bridge[] = {5e-6, 8 * nm};
  const Effect& bridge = effect_of("capillary");
  const auto changes = bridge.case_changes(e, of_bridge);
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_EQ(changes[0].entry, "Interface/Work of adhesion");
  EXPECT_NEAR(changes[0].value, 5e-6 / (2 * M_PI * radius_in_case), 1e-9);
  EXPECT_EQ(changes[1].entry, "Interface/Adhesion range");
  EXPECT_DOUBLE_EQ(changes[1].value, 8 * nm);
  EXPECT_GT(bridge.opening_distance(e, of_bridge), 1.25 * 8 * nm);
}

TEST(EffectsInCase_analytic, a_film_lies_on_the_softer_body_and_is_all_of_its_modulus) {
  Experiment e;
  e.particle = particle_in_case, e.substrate = substrate_in_case, e.radius = radius_in_case,
  e.largest_force = 100e-6;
  e.largest_displacement = 6 * nm, e.by_finite_elements = true;
  const double of_film[] = {0.25, 40 * nm};
  const Effect& film = effect_of("film");
  const auto changes = film.case_changes(e, of_film);
  ASSERT_EQ(changes.size(), 3u);
  EXPECT_EQ(changes[0].entry, "Particle/Film thickness");
  EXPECT_DOUBLE_EQ(changes[0].value, 40 * nm);
  // The other body against a film alone has a quarter of the pair's modulus.
  EXPECT_NEAR(reduced_modulus(substrate_in_case, {changes[1].value, changes[2].value}) /
                  (0.25 * reduced_modulus(particle_in_case, substrate_in_case)),
              1, 1e-9);
  // No film makes the pair stiffer than the other body is.
  const double stiffest = film.parameters(e)[0].high;
  EXPECT_LT(stiffest * reduced_modulus(particle_in_case, substrate_in_case),
            reduced_modulus(substrate_in_case, {1e18, 0}));
}

}  // namespace
}  // namespace asperity
