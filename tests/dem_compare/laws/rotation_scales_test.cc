#include "dem_compare/laws/rotation_scales.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(RotationScales_analytic, the_length_of_a_limit_is_the_lever_the_contact_radius_or_one) {
  NormalState normal;
  normal.contact_radius = 2e-7;
  EXPECT_EQ(length_of(LengthScale::particle_radius, normal, 8.5e-6), 8.5e-6);
  EXPECT_EQ(length_of(LengthScale::contact_radius, normal, 8.5e-6), 2e-7);
  EXPECT_EQ(length_of(LengthScale::none, normal, 8.5e-6), 1);  // the coefficient is a length itself
}

}  // namespace
}  // namespace asperity
