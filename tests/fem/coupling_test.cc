// What both surfaces displace on the mean, taken out of displacements that are known.
#include "fem/mortar/coupling.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace asperity::fem;
using Places = std::vector<std::array<double, 3>>;

const Places places{{1, 0, 0.1}, {4, 1, 0.2}, {3, -2, 0}, {-1, 2, 0.3}, {2, 2, 0}};
const std::vector<double> weights{1, 2, 0.5, 3, 0};

/// A shift, and a turn about the axis, of the points at `places`.
std::array<std::vector<double>, 2> displaced(double x, double y, double turn) {
  std::array<std::vector<double>, 2> along;
  for (const auto& p : places) along[0].push_back(x - turn * p[1]), along[1].push_back(y + turn * p[0]);
  return along;
}

TEST(MeanSurfaceDisplacement_analytic, finds_a_shift_and_a_turn_about_the_axis_under_any_weights) {
  const auto mean = mean_surface_displacement(places, weights, displaced(0.3, -0.7, 0.02));
  EXPECT_NEAR(mean.x, 0.3, 1e-14);
  EXPECT_NEAR(mean.y, -0.7, 1e-14);
  EXPECT_NEAR(mean.turn, 0.02, 1e-14);
}

TEST(MeanSurfaceDisplacement_analytic, leaves_of_other_displacements_no_mean_and_no_turn) {
  auto along = displaced(0.1, 0.2, -0.03);
  for (std::size_t k = 0; k < places.size(); ++k)
    along[0][k] += 0.05 * std::sin(5.0 * k), along[1][k] -= 0.04 * k * k;
  const auto mean = mean_surface_displacement(places, weights, along);
  const auto fitted = displaced(mean.x, mean.y, mean.turn);
  double x = 0, y = 0, turning = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double rx = along[0][k] - fitted[0][k], ry = along[1][k] - fitted[1][k];
    x += weights[k] * rx, y += weights[k] * ry,
        turning += weights[k] * (places[k][0] * ry - places[k][1] * rx);
  }
  EXPECT_NEAR(x, 0, 1e-13);
  EXPECT_NEAR(y, 0, 1e-13);
  EXPECT_NEAR(turning, 0, 1e-13);
}

TEST(MeanSurfaceDisplacement_behaviour, needs_weight_and_for_a_turn_more_than_one_point) {
  const auto along = displaced(0.3, -0.7, 0.02);
  EXPECT_EQ(mean_surface_displacement(places, {0, 0, 0, 0, 0}, along), SurfaceDisplacement{});
  const auto mean = mean_surface_displacement(places, {0, 0, 1, 0, 0}, along);
  EXPECT_DOUBLE_EQ(mean.x, along[0][2]);
  EXPECT_DOUBLE_EQ(mean.y, along[1][2]);
  EXPECT_EQ(mean.turn, 0);
}

TEST(Coupling_analytic, moves_the_surface_by_the_frames_and_by_what_is_elastic) {
  const RigidMotion surface = Coupling{{1, 2, 0.5, 0.3}, {0.25, -0.5, 0.125}}.surface();
  EXPECT_EQ(surface, (RigidMotion{1.25, 1.5, 0.625, 0.3}));
}

}  // namespace
