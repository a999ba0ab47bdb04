// Normal load and shear that change together: Mindlin & Deresiewicz (1953), Trans. ASME 75, 327; Jaeger
// (1995). Equal bodies.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/fem/support/frictional_contact.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;
using test::FrictionalContact;
using test::FrictionalContactOptions;

/// Shift of a first loading to shear Q under load P, 3 mu P / (16 G* a) (1 - (1 - Q / mu P)^(2/3)) (Cattaneo
/// 1938).
double cattaneo_shift(const FrictionalContact& c, double P, double Q) {
  const double limit = c.options.friction * P,
               a = std::cbrt(3 * P * c.options.radius / (4 * c.reduced_modulus));
  return 3 * limit / (16 * c.system.reduced_shear_modulus() * a) * (1 - std::pow(1 - Q / limit, 2.0 / 3));
}

test::Verified oblique(const std::string& what) { return {"Sliding", what, "Mindlin & Deresiewicz (1953)"}; }

/// To a shift of half-spaces at load P; the finite bodies' own shift under the shear `expected` [N] is added.
fem::ContactResultants go(FrictionalContact& c, double P, double shift, double expected) {
  fem::RigidMotion motion;
  motion.x = shift + c.lateral_far_field * expected;
  return c.step(motion, P);
}

FrictionalContactOptions in_steps(double largest_load) {
  FrictionalContactOptions o;
  o.friction = 0.3, o.load = largest_load, o.loaded = false;
  return o;
}

/// Shear over alpha P at the end of a loading in proportion, alpha = 0.25 < mu, in so many steps. All that
/// closes sticks: the shift over D0 = 3 mu P / (16 G* a) is alpha / mu.
double shear_of_proportional_loading(int steps) {
  constexpr double P0 = 100e-6, alpha = 0.25;
  auto o = in_steps(P0);
  o.cells_per_radius = 8;
  FrictionalContact c(o);
  fem::ContactResultants r;
  for (int k = 1; k <= steps; ++k) {
    const double P = P0 * std::pow(k / static_cast<double>(steps), 1.5), Q = alpha * P;
    const double a = std::cbrt(3 * P * c.options.radius / (4 * c.reduced_modulus));
    r = go(c, P, 3 * Q / (16 * c.system.reduced_shear_modulus() * a), Q);
  }
  return r.lateral_force[0] / (alpha * P0);
}

TEST(ObliqueNightly_analytic, load_and_shear_that_grow_in_proportion_below_friction_stick) {
  for (const int steps : {10, 20}) {
    const double share = shear_of_proportional_loading(steps);
    std::printf("%d steps: Q / (alpha P) %.4f\n", steps, share);
    const std::string what = "load and shear that grow in proportion below friction, shear, a/h 8, " +
                             std::to_string(steps) + " steps";
    EXPECT_TRUE(oblique(what).within(share, 1, 0.03));
  }
}

TEST(Oblique_analytic, load_that_grows_at_constant_shear_leaves_the_shift_and_its_memory) {
  // Histories H3 and H3b: Q = 0.5 mu P0 at P0, then 2 P0 at the same Q (the shift stays), then more shear.
  constexpr double P0 = 50e-6;
  FrictionalContact c(in_steps(2 * P0));
  const double limit = c.options.friction * P0,
               a0 = std::cbrt(3 * P0 * c.options.radius / (4 * c.reduced_modulus));
  const double D0 = 3 * limit / (16 * c.system.reduced_shear_modulus() * a0);
  c.step({}, P0);
  auto r = go(c, P0, cattaneo_shift(c, P0, 0.5 * limit), 0.5 * limit);
  EXPECT_NEAR(r.lateral_force[0], 0.5 * limit, 0.02 * limit);
  for (const double P : {1.25 * P0, 1.5 * P0, 1.75 * P0, 2 * P0}) r = c.step(c.state.motion, P);
  const std::string h3 = "history H3 (load to 2 P0 at constant shear): ";
  EXPECT_TRUE(oblique(h3 + "shear at 2 P0, 0.5 mu P0").within(r.lateral_force[0], 0.5 * limit, 0.02));
  r = go(c, 2 * P0, 0.7663021 * D0, 1.2 * limit);
  EXPECT_TRUE(oblique(h3 + "more shear, 1.2 mu P0").within(r.lateral_force[0], 1.2 * limit, 0.02));
  r = go(c, 2 * P0, 1.2454059 * D0, 1.8 * limit);
  EXPECT_TRUE(oblique(h3 + "more shear, 1.8 mu P0").within(r.lateral_force[0], 1.8 * limit, 0.02));
}

TEST(Oblique_analytic, load_that_falls_at_constant_shear_slips_as_if_loaded_there_at_once) {
  constexpr double P0 = 100e-6;  // history H4
  FrictionalContact c(in_steps(P0));
  const double Q = 0.5 * c.options.friction * P0;
  c.step({}, P0);
  go(c, P0, cattaneo_shift(c, P0, Q), Q);
  for (const double share : {0.9, 0.8, 0.7}) {
    const auto r = go(c, share * P0, cattaneo_shift(c, share * P0, Q), Q);
    const std::string what =
        "history H4 (load falls at constant shear): shear at " + std::to_string(share).substr(0, 3) + " P0";
    EXPECT_TRUE(oblique(what).within(r.lateral_force[0], Q, 0.02));
  }
}

}  // namespace
