// What shear and pressure share between two elastic bodies.
#include "core/shear_moduli.h"

#include <gtest/gtest.h>

namespace {

using asperity::dundurs_beta;

/// Against a rigid body beta is (1 - 2 nu) / (2 (1 - nu)): a half for nu = 0, none for what does not change
/// its volume (Johnson 1985, section 5.1).
TEST(DundursBeta_analytic, is_that_of_one_body_against_a_rigid_one) {
  constexpr double rigid = 1e30;
  EXPECT_NEAR(dundurs_beta({1e9, 0}, {rigid, 0.3}), 0.5, 1e-9);
  EXPECT_NEAR(dundurs_beta({1e9, 0.3}, {rigid, 0.3}), 0.4 / 1.4, 1e-9);
  EXPECT_NEAR(dundurs_beta({1e9, 0.5}, {rigid, 0.3}), 0, 1e-9);
}

TEST(DundursBeta_analytic, is_none_of_equal_bodies_and_changes_its_sign_with_their_order) {
  EXPECT_EQ(dundurs_beta({71e9, 0.17}, {71e9, 0.17}), 0);
  const double beta = dundurs_beta({71e9, 0.17}, {179e9, 0.25});
  // By hand: G of 30.34 and 71.6 GPa, (0.66 / 30.34 - 0.5 / 71.6) / (2 (0.83 / 30.34 + 0.75 / 71.6)).
  EXPECT_NEAR(beta, 0.1952, 2e-4);
  EXPECT_DOUBLE_EQ(dundurs_beta({179e9, 0.25}, {71e9, 0.17}), -beta);
}

}  // namespace
