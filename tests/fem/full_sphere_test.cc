// A full sphere, glued at its top, against a hemisphere driven at its equator: the contact must not know the
// difference.
#include <gtest/gtest.h>

#include <cmath>

#include "fem/case/mesh_quality.h"
#include "fem/contact/contact_solver.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity::fem;

struct Pressed {
  double approach, far_field, radius, peak, volume, smallest_jacobian, reaction;
};

Pressed press(bool full) {
  ContactSystemOptions o;
  constexpr double a = 230e-9, load = 100e-6;
  auto& s = o.mesh.sizes;
  s.radius = 8.5e-6, s.block_half_width = 6e-6;
  s.full_sphere = full;
  s.spacing_particle = s.spacing_substrate = a / 8;
  s.offset_substrate_x = 0.3 * s.spacing_substrate;
  s.region_particle = 1.2 * a;
  s.region_substrate = 1.2 * a + 3 * s.spacing_substrate;
  o.materials = {J2Material::elastic(71e9, 0.17), J2Material::elastic(179e9, 0.25)};
  ContactSystem system(MPI_COMM_WORLD, o);
  ContactSolver solver(system, {});
  Pressed p{};
  p.far_field = solver.far_field_compliance(0.8 * a);
  ContactState state = solver.first_touch();
  solver.push_rigidly(state, 3e-9);
  EXPECT_TRUE(solver.solve(state, load).converged);
  const auto c = solver.resultants(state);
  p.approach = state.approach - p.far_field * load;
  p.radius = std::sqrt(c.area / M_PI), p.peak = c.largest_pressure, p.reaction = c.reaction_driven;
  p.smallest_jacobian =
      hex_mesh_quality(system.level(), system.positions(), o.mesh).smallest_scaled_jacobian[0];
  return p;
}

TEST(FullSphere_behaviour, contact_is_that_of_the_hemisphere_once_the_far_field_is_taken_out) {
  const Pressed half = press(false), full = press(true);
  EXPECT_NE(full.far_field, half.far_field);
  const auto verified = [](const char* what) {
    return asperity::test::Verified{
        "Hertz", what + std::string(" of a full sphere, far field taken out, a/h 8"), "hemisphere"};
  };
  EXPECT_TRUE(verified("approach").within(full.approach, half.approach, 2e-3));
  EXPECT_TRUE(verified("largest pressure").within(full.peak, half.peak, 2e-3));
  EXPECT_TRUE(verified("contact radius").within(full.radius, half.radius, 1e-3));
  EXPECT_NEAR(full.reaction / 100e-6, 1, 1e-6);
  EXPECT_GT(full.smallest_jacobian, 0.2);
  std::printf("far field: hemisphere %.3g, full sphere %.3g m/N; approach %.5g against %.5g nm\n",
              half.far_field, full.far_field, 1e9 * half.approach, 1e9 * full.approach);
}

}  // namespace
