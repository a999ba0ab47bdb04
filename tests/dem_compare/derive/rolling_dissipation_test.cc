// Rolling of rough bodies: the moment is that of hills, the resistance what is dissipated.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/dem_compare/derive/found.h"
#include "tests/dem_compare/resistance/moving_folder.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/verification.h"

namespace asperity {
namespace {

TEST(RollingDerivation_analytic, finds_the_law_of_what_is_dissipated_below_hills_twenty_times_as_high) {
  const test::TemporaryFolder root;
  constexpr double mu = 2e-4, offset = 40e-6, radius = 8.5e-6;
  int seed = 0;
  for (const double load : {30e-6, 100e-6, 300e-6, 1e-3}) {
    test::MovingFolder made;
    made.experiment = "rolling";
    made.load = load;
    made.friction = 0, made.adhesion = mu * radius * (load + offset), made.hills = 20, made.noise = 0.02;
    made.random = 5 + static_cast<unsigned>(++seed);
    made.reverse = true;
    test::write_moving(root.path / std::to_string(seed), made);
  }
  const auto sets = collect_parameter_sets({root.path});
  ASSERT_EQ(sets.sets.size(), 1u);
  const Derivation derivation = derive_parameters(reduced_set(sets.sets.front()));
  const ContactParameters& p = derivation.parameters;
  ASSERT_TRUE(p.rolling_friction);
  EXPECT_EQ(p.rolling_friction->length_scale, LengthScale::particle_radius);
  EXPECT_NEAR(p.rolling_friction->value, mu, 3 * p.rolling_friction->sd);
  const auto verified = [](const char* what) {
    return test::Verified{
        "Reduced laws",
        std::string("derive: rolling law of what is dissipated below hills twenty times as high, ") + what,
        "what made it"};
  };
  EXPECT_TRUE(verified("mu").within(p.rolling_friction->value, mu, 0.05));
  EXPECT_TRUE(verified("h").within(p.rolling_offset->value, offset, 0.15));
  EXPECT_TRUE(
      test::origin(derivation, &ContactParameters::rolling_friction, Origin::From::dissipation_per_angle));
  EXPECT_TRUE(test::found<DissipationFact>(derivation.law_of(Motion::rolling)));
  // Rolled back, the made moment falls by twice the resistance at once: a spring of half of that over the
  // first steps, of a twentieth of a contact radius each.
  ASSERT_TRUE(p.rolling_stiffness);
  const double load = p.rolling_stiffness->at_load, moment = mu * radius * (load + offset);
  const double step = test::MovingFolder{"rolling", load}.unit() / 20;
  EXPECT_GT(p.rolling_stiffness->value, moment / (4 * step));
  EXPECT_LT(p.rolling_stiffness->value, 2 * moment / step);
  ASSERT_TRUE(p.rolling_stiffness->load_range);
  EXPECT_NEAR(p.rolling_stiffness->load_range->high, 1e-3, 1e-9);
  const auto* stiffness = test::found<StiffnessFact>(derivation.law_of(Motion::rolling));
  ASSERT_TRUE(stiffness);
  EXPECT_EQ(stiffness->source, StiffnessSource::second_pass);
}

TEST(SlidingDerivation_analytic, tells_how_few_contact_diameters_a_short_way_has) {
  const test::TemporaryFolder root;
  test::MovingFolder made;
  made.path_in_radii = 3;  // in steps of a twentieth, two of them of onset before and after
  test::write_moving(root.path / "short", made);
  const Derivation derivation =
      derive_parameters(reduced_set(collect_parameter_sets({root.path}).sets.front()));
  const auto* open = test::asked(derivation.law_of(Motion::sliding), OpenQuestion::About::long_paths);
  ASSERT_TRUE(open);
  EXPECT_NEAR(open->number, 1.5, 0.05);
}

/// The same history on two meshes: 3 h/a of the stiffness is the mesh's share of its sd
/// (docs/verification.md, rolling stiffness).
TEST(RollingDerivation_analytic, stiffness_of_rolling_back_states_what_the_mesh_leaves) {
  const test::TemporaryFolder root;
  const auto derived = [&](const char* name, double spacing) {
    test::MovingFolder made;
    made.experiment = "rolling", made.friction = 1e-13, made.hills = 20, made.reverse = true,
    made.spacing = spacing;
    test::write_moving(root.path / name, made);
    return *derive_parameters(reduced_set(collect_parameter_sets({root.path / name}).sets.front()))
                .parameters.rolling_stiffness;
  };
  const EffectiveQuantity fine = derived("fine", 10e-9), coarse = derived("coarse", 40e-9);
  ASSERT_GT(fine.value, 0);
  EXPECT_DOUBLE_EQ(coarse.value, fine.value);
  const double a = test::MovingFolder{"rolling"}.contact_radius();
  const double added = 3 * std::sqrt(40e-9 * 40e-9 - 10e-9 * 10e-9) / a * fine.value;
  EXPECT_NEAR(std::sqrt(coarse.sd * coarse.sd - fine.sd * fine.sd), added, 1e-3 * added);
}

/// Energies are there, but no steady stretch: the moment of hills must not stand in.
TEST(RollingDerivation_behaviour, of_a_way_too_short_is_not_told) {
  const test::TemporaryFolder root;
  test::MovingFolder made;
  made.experiment = "rolling", made.friction = 1e-13, made.hills = 20, made.path_in_radii = 0.9;
  test::write_moving(root.path / "short", made);
  const Derivation derivation =
      derive_parameters(reduced_set(collect_parameter_sets({root.path}).sets.front()));
  EXPECT_FALSE(derivation.parameters.rolling_friction);
  EXPECT_TRUE(test::asked(derivation.law_of(Motion::rolling), OpenQuestion::About::slip));
}

}  // namespace
}  // namespace asperity
