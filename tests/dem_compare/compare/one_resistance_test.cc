// Derive, compare and the study of resistances find the same steady resistance in the same case.
#include <gtest/gtest.h>

#include "dem_compare/compare/finite_element_column.h"
#include "dem_compare/derive/derivation.h"
#include "dem_compare/resistance/moving_study.h"
#include "tests/dem_compare/resistance/moving_folder.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

/// Yields on the first way, hardly on the way back over its track, among hills that force alone would take
/// for resistance.
test::MovingFolder yielding(const std::string& type) {
  test::MovingFolder made;
  made.experiment = type;
  const double size = type == "sliding" ? 1 : made.contact_radius();
  made.friction = 10e-6 * size, made.plastic = 20e-6 * size, made.hills = 3, made.reverse = true,
  made.back = 0.25;
  return made;
}

TEST(OneResistance_analytic, is_what_the_first_way_dissipates_for_derive_compare_and_resistance) {
  for (const auto& [type, quantity] :
       {std::pair{"sliding", Quantity::sliding_friction}, std::pair{"rolling", Quantity::rolling_friction},
        std::pair{"torsion", Quantity::torsion_friction}}) {
    const test::TemporaryFolder root;
    const test::MovingFolder made = yielding(type);
    const auto folder = test::write_moving(root.path / "case", made);
    const double truth = made.friction + made.plastic;
    const CaseCollection collection = collect_cases({folder});
    const MovingStudy study = collect_moving(collection);
    ASSERT_EQ(study.contacts.size(), 1u) << type;
    EXPECT_NEAR(study.contacts[0].states[0].resistance.value / truth, 1, 1e-6) << type;

    const Derivation derivation =
        derive_parameters(reduced_set(collect_parameter_sets({folder}).sets.front()));
    bool found = false;
    for (const auto& law : derivation.laws)
      for (const auto& point : law.points) {
        found = true;
        EXPECT_NEAR(point.value / truth, 1, 1e-6) << type;
      }
    EXPECT_TRUE(found) << type;

    const double length = type == std::string("sliding") ? 1 : made.radius;
    found = false;
    for (const auto& point : finite_element_points(collection, compare_with_hertz(collection, 0.05)))
      if (point.quantity == quantity) {
        found = true;
        EXPECT_NEAR(point.value.value * made.load * length / truth, 1, 1e-6) << type;
      }
    EXPECT_TRUE(found) << type;
  }
}

TEST(OneResistance_behaviour, rolling_stiffness_is_as_doubtful_to_compare_as_to_derive) {
  const test::TemporaryFolder root;
  const auto folder = test::write_moving(root.path / "case", yielding("rolling"));
  const auto derived =
      derive_parameters(reduced_set(collect_parameter_sets({folder}).sets.front())).parameters;
  ASSERT_TRUE(derived.rolling_stiffness && derived.rolling_stiffness->sd > 0);
  const CaseCollection collection = collect_cases({folder});
  bool found = false;
  for (const auto& point : finite_element_points(collection, compare_with_hertz(collection, 0.05)))
    if (point.quantity == Quantity::rolling_stiffness) {
      found = true;
      EXPECT_NEAR(point.value.value / derived.rolling_stiffness->value, 1, 1e-9);
      EXPECT_NEAR(point.value.sd / derived.rolling_stiffness->sd, 1, 1e-9);
    }
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace asperity
