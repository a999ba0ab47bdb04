// Partial slip of a sphere against Cattaneo, Mindlin and Masing.
#include "half_space/partial_slip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/error.h"
#include "core/hertz.h"
#include "half_space/normal_contact.h"
#include "tests/support/verification.h"

namespace asperity::half_space {
namespace {

using test::Verified;

/// Bodies without lateral contraction, for which the traction along the shift alone is the whole answer.
struct SphereThatSlips {
  static constexpr double modulus = 50e9, radius = 8.5e-6, load = 100e-6, friction = 0.3;
  static constexpr double shear = modulus;  ///< of both bodies: E* = E/2 = G
  Hertz hertz{modulus, radius};
  double a = hertz.contact_radius(load), stiffness = 8 * a / (4 / shear),
         full_slip = 1.5 * friction * load / stiffness;
  Grid grid;
  Field pressure;
  StuckContact stuck;

  explicit SphereThatSlips(int n)
      : grid(square_grid(1.2 * hertz.contact_radius(load), n)), stuck(grid, {2 / shear, 0}) {
    Field gap(grid.cells());
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        gap[j * n + i] = (grid.x(i) * grid.x(i) + grid.y(j) * grid.y(j)) / (2 * radius);
    pressure = NormalContact(grid, Boundary::free, modulus, gap).at_force(load).pressure;
  }
  PartialSlip partial_slip() const {
    Field limit = pressure;
    for (double& value : limit) value *= friction;
    return PartialSlip(stuck, limit);
  }
  /// Lateral force on first shifting (Cattaneo 1938; Mindlin 1949).
  double force(double shift) const {
    return friction * load * (1 - std::pow(std::max(0.0, 1 - shift / full_slip), 1.5));
  }
  /// Of one cycle between shifts of this size, by Masing's rule (Mindlin & Deresiewicz 1953).
  double loss_of_cycle(double shift) const {
    const double work =
        friction * load * (shift - 0.4 * full_slip * (1 - std::pow(1 - shift / full_slip, 2.5)));
    return 8 * (work - 0.5 * force(shift) * shift);
  }
};

TEST(PartialSlip_analytic, of_a_sphere_follows_Cattaneo_and_Mindlin_and_loses_what_its_loop_encloses) {
  const SphereThatSlips sphere(128);
  const PartialSlip contact = sphere.partial_slip();
  const auto verified = [](const std::string& what) {
    return Verified{"Half-space", "sphere that slips partly, 107 cells over the contact: " + what,
                    "Cattaneo (1938), Mindlin & Deresiewicz (1953)"};
  };
  EXPECT_NEAR(contact.full_slip() / (sphere.friction * sphere.load), 1, 1e-9);
  SlipState state = contact.at_rest();
  for (const double share : {0.3, 0.6}) {
    state = contact.shifted(state, share * sphere.full_slip, 0);
    const std::string at = " at " + std::to_string(share).substr(0, 3) + " of full slip";
    EXPECT_TRUE(
        verified("lateral force" + at).within(state.force_x, sphere.force(share * sphere.full_slip), 0.001));
    const double stick =
        std::pow(1 - sphere.force(share * sphere.full_slip) / (sphere.friction * sphere.load), 2.0 / 3);
    EXPECT_TRUE(verified("share of the area that slips" + at).within(state.slipping, 1 - stick, 0.03));
  }
  const double turn = 0.6 * sphere.full_slip, first = state.dissipated;
  for (const double share : {0.2, -0.2, -0.6, -0.2, 0.2, 0.6})
    state = contact.shifted(state, share * sphere.full_slip, 0);
  EXPECT_NEAR(state.force_x / sphere.force(turn), 1, 0.003);
  EXPECT_TRUE(verified("energy that a cycle dissipates")
                  .within(state.dissipated - first, sphere.loss_of_cycle(turn), 0.01));
  EXPECT_NEAR(state.force_y / state.force_x, 0, 1e-3);
}

TEST(PartialSlip_behaviour, all_slips_from_full_slip_on_in_any_direction) {
  const SphereThatSlips sphere(64);
  const PartialSlip contact = sphere.partial_slip();
  const double far = 1.5 * sphere.full_slip, along = std::cos(0.7), across = std::sin(0.7);
  const SlipState state = contact.shifted(contact.at_rest(), far * along, far * across);
  EXPECT_EQ(state.slipping, 1);
  EXPECT_NEAR(std::hypot(state.force_x, state.force_y) / contact.full_slip(), 1, 1e-3);
  EXPECT_NEAR(state.force_y / state.force_x, std::tan(0.7), 1e-3);
  EXPECT_GT(state.dissipated, 0);
  // In one step or in many, the way there is the same for a shift in one direction.
  SlipState steps = contact.at_rest();
  for (int n = 1; n <= 4; ++n) steps = contact.shifted(steps, 0.1 * n * sphere.full_slip, 0);
  const SlipState once = contact.shifted(contact.at_rest(), 0.4 * sphere.full_slip, 0);
  EXPECT_NEAR(steps.force_x / once.force_x, 1, 1e-3);
}

TEST(PartialSlip_behaviour, limits_are_checked) {
  const Grid grid = square_grid(1e-7, 16);
  const StuckContact stuck(grid, {1e-11, 1e-12});
  EXPECT_THROW(PartialSlip(stuck, Field(3, 1.0)), InputError);
  EXPECT_THROW(PartialSlip(stuck, Field(grid.cells(), -1.0)), InputError);
  const PartialSlip open(stuck, Field(grid.cells(), 0.0));
  EXPECT_EQ(open.shifted(open.at_rest(), 1e-9, 0).force_x, 0);
}

}  // namespace
}  // namespace asperity::half_space
