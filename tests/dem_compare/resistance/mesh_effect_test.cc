// Studies with a contact on two meshes.
#include "dem_compare/resistance/mesh_effect.h"

#include <gtest/gtest.h>

#include "tests/dem_compare/resistance/known_studies.h"

namespace asperity {
namespace {

using namespace test;

TEST(MeshEffect_analytic, of_first_order_is_found_on_the_coarse_mesh_that_counts) {
  test::TemporaryFolder root;
  const auto findings = find_resistances(
      collect_cases({test::write_moving_study(root.path, {{"1.5 nm", on_spacing(32e-9)},
                                                          {"1.5 nm finer", on_spacing(16e-9)},
                                                          {"2.7 nm", on_spacing(32e-9, 2.7)}})}));
  ASSERT_EQ(findings.study.contacts.size(), 2u);
  for (const auto& contact : findings.study.contacts)
    EXPECT_DOUBLE_EQ(contact.states.front().spacing, 32e-9);  // one mesh for all that is compared
  ASSERT_EQ(findings.meshes.size(), 1u);
  const MeshEffect& effect = findings.meshes.front();
  EXPECT_FALSE(effect.counts_fine);
  EXPECT_EQ(effect.contact->label, "1.5 nm");
  // The same noise on both meshes: it drops out.
  EXPECT_NEAR(effect.ratio.value, 1.08 / 1.16, 1e-6);
  EXPECT_LT(effect.ratio.sd, 1e-6);
  EXPECT_NEAR(effect.excess().value, 0.16, 1e-5);
}

TEST(MeshEffect_analytic, of_each_finer_mesh_is_told_and_of_first_order_all_tell_the_same) {
  test::TemporaryFolder root;
  const auto findings = find_resistances(
      collect_cases({test::write_moving_study(root.path, {{"1.5 nm", on_spacing(32e-9)},
                                                          {"1.5 nm finest", on_spacing(12.5e-9)},
                                                          {"1.5 nm finer", on_spacing(20e-9)},
                                                          {"2.7 nm", on_spacing(32e-9, 2.7)}})}));
  ASSERT_EQ(findings.meshes.size(), 2u);
  EXPECT_DOUBLE_EQ(findings.meshes[0].fine, 20e-9);
  EXPECT_DOUBLE_EQ(findings.meshes[1].fine, 12.5e-9);
  for (const auto& effect : findings.meshes) {
    EXPECT_DOUBLE_EQ(effect.coarse, 32e-9);
    EXPECT_NEAR(effect.excess().value, 0.16, 1e-5);
  }
}

TEST(MeshEffect_analytic, where_all_have_the_finer_mesh_it_counts) {
  test::TemporaryFolder root;
  const auto findings = find_resistances(
      collect_cases({test::write_moving_study(root.path, {{"1.5 nm", on_spacing(32e-9)},
                                                          {"1.5 nm finer", on_spacing(16e-9)},
                                                          {"2.7 nm", on_spacing(32e-9, 2.7)},
                                                          {"2.7 nm finer", on_spacing(16e-9, 2.7)}})}));
  ASSERT_EQ(findings.meshes.size(), 2u);
  for (const auto& effect : findings.meshes) {
    EXPECT_TRUE(effect.counts_fine);
    EXPECT_NEAR(effect.excess().value, 0.08, 1e-5);
  }
}

TEST(MeshEffect_analytic, error_of_the_excess_is_that_of_the_ratio) {
  MovingState state;
  MeshEffect effect;
  effect.state = &state;
  effect.coarse = 32e-9, effect.fine = 16e-9;
  for (const bool fine : {false, true}) {
    effect.counts_fine = fine;
    effect.ratio = {0.95, 1e-4};
    const Uncertain excess = effect.excess();
    effect.ratio.value += 1e-4;
    EXPECT_NEAR(std::abs(effect.excess().value - excess.value), excess.sd, 1e-2 * excess.sd);
  }
}

}  // namespace
}  // namespace asperity
