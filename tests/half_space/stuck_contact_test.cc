// Half-spaces that stick together against closed forms of a circle, and against each other's directions.
#include "half_space/stuck_contact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "half_space/contact_shape.h"
#include "half_space/normal_contact.h"
#include "tests/support/verification.h"

namespace asperity::half_space {
namespace {

using test::Verified;

/// Of borosilicate on silicon.
struct Pair {
  double nu[2] = {0.17, 0.25}, G[2] = {71e9 / (2 * 1.17), 179e9 / (2 * 1.25)};
  ShearCompliance shear() const {
    return {(1 - nu[0]) / G[0] + (1 - nu[1]) / G[1], nu[0] / G[0] + nu[1] / G[1]};
  }
  double reduced_modulus() const { return 1 / ((1 - nu[0]) / (2 * G[0]) + (1 - nu[1]) / (2 * G[1])); }
};

/// Cells within an ellipse of half axes a and b, turned by an angle.
Field pressed_ellipse(const Grid& grid, double a, double b, double turned) {
  Field pressure(grid.cells(), 0.0);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const double x = grid.x(i) * std::cos(turned) + grid.y(j) * std::sin(turned),
                   y = grid.y(j) * std::cos(turned) - grid.x(i) * std::sin(turned);
      if (x * x / (a * a) + y * y / (b * b) < 1) pressure[j * grid.nx + i] = 1e9;
    }
  return pressure;
}

TEST(StuckHalfSpace_analytic, circle_is_as_stiff_as_Mindlin_and_Reissner_and_Sagoci_found) {
  const Pair pair;
  constexpr double a = 200e-9;
  const Grid grid = square_grid(1.2 * a, 256);
  const Field pressure = pressed_ellipse(grid, a, a, 0);
  const StuckContact stuck(grid, pair.shear());
  NormalContactSolution pressed;
  pressed.pressure = pressure;
  const double normal = NormalContact(grid, Boundary::free, pair.reduced_modulus(), Field(grid.cells(), 0.0))
                            .stiffness(pressed);
  const double lateral = 8 * a / ((2 - pair.nu[0]) / pair.G[0] + (2 - pair.nu[1]) / pair.G[1]),
               torsion = 16.0 / 3 * a * a * a / (1 / pair.G[0] + 1 / pair.G[1]);
  const auto verified = [](const char* what, const char* source) {
    return Verified{"Half-space", std::string("circle of 213 cells that sticks: ") + what, source};
  };
  EXPECT_TRUE(verified("lateral stiffness", "Mindlin (1949)")
                  .within(stuck.lateral_stiffness(pressure), lateral, 0.005));
  EXPECT_TRUE(verified("lateral over normal stiffness", "Mindlin (1949)")
                  .within(stuck.lateral_stiffness(pressure) / normal,
                          lateral / (2 * a * pair.reduced_modulus()), 0.002));
  EXPECT_TRUE(verified("torsion stiffness", "Reissner & Sagoci (1944)")
                  .within(stuck.torsion_stiffness(pressure), torsion, 0.01));
}

/// Lateral force over shift of an ellipse, along its half axis a, by the traction 1/sqrt(1 - x^2/a^2 -
/// y^2/b^2), which shifts all of it alike (Mindlin 1949): integrated along rays from the middle.
double stiffness_along_axis(double a, double b, const ShearCompliance& c) {
  constexpr int steps = 2000;
  double sum = 0;
  for (int n = 0; n < steps; ++n) {
    const double angle = 2 * M_PI * (n + 0.5) / steps, x = std::cos(angle), y = std::sin(angle);
    sum += (c.across + c.along * x * x) / std::hypot(x / a, y / b) * 2 * M_PI / steps;
  }
  return 8 * M_PI * a * b / sum;
}

TEST(StuckHalfSpace_analytic, ellipse_is_softer_along_its_longer_axis) {
  const Pair pair;
  constexpr double a = 200e-9, b = 80e-9;
  const Grid grid = square_grid(1.2 * a, 256);
  const StuckContact stuck(grid, pair.shear());
  const auto lateral = [&](double turned) {
    return stuck.lateral_stiffness(pressed_ellipse(grid, a, b, turned));
  };
  const double along = stiffness_along_axis(a, b, pair.shear()),
               across = stiffness_along_axis(b, a, pair.shear());
  const auto verified = [](const char* what) {
    return Verified{"Half-space", std::string("ellipse of 213 by 85 cells that sticks: ") + what,
                    "Mindlin (1949)"};
  };
  EXPECT_LT(along, across);
  EXPECT_TRUE(verified("lateral stiffness along the longer axis").within(lateral(0), along, 0.005));
  EXPECT_TRUE(verified("lateral stiffness along the shorter axis").within(lateral(M_PI / 2), across, 0.005));
  // Halfway between, what goes across is held, so that both directions are shifted alike.
  EXPECT_TRUE(
      verified("lateral stiffness halfway between").within(lateral(M_PI / 4), 0.5 * (along + across), 0.005));
  EXPECT_NEAR(stuck.torsion_stiffness(pressed_ellipse(grid, a, b, 0.6)) /
                  stuck.torsion_stiffness(pressed_ellipse(grid, a, b, 0)),
              1, 0.01);
}

TEST(StuckHalfSpace_behaviour, nothing_that_touches_has_no_stiffness_and_compliances_are_checked) {
  const Grid grid = square_grid(1e-7, 32);
  const StuckContact stuck(grid, Pair().shear());
  EXPECT_EQ(stuck.lateral_stiffness(Field(grid.cells(), 0.0)), 0);
  EXPECT_EQ(stuck.torsion_stiffness(Field(grid.cells(), 0.0)), 0);
  EXPECT_THROW(StuckContact(grid, {0, 0}), InputError);
  EXPECT_THROW(StuckContact(grid, {1e-11, -1e-12}), InputError);
}

}  // namespace
}  // namespace asperity::half_space
