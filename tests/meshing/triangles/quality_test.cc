#include "meshing/triangles/quality.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::meshing {

namespace {

std::array<Point, 8> unit_cube(double size = 1) {
  return {{{0, 0, 0},
           {size, 0, 0},
           {size, size, 0},
           {0, size, 0},
           {0, 0, size},
           {size, 0, size},
           {size, size, size},
           {0, size, size}}};
}

std::array<Point, 4> regular_tetrahedron(double size = 1) {
  return {{{0, 0, 0},
           {size, 0, 0},
           {size / 2, size * std::sqrt(3.) / 2, 0},
           {size / 2, size / std::sqrt(12.), size * std::sqrt(2. / 3)}}};
}

}  // namespace

TEST(HexahedronQuality_analytic, any_box_has_one_at_any_size) {
  EXPECT_NEAR(scaled_jacobian(unit_cube()), 1, 1e-15);
  EXPECT_NEAR(scaled_jacobian(unit_cube(5e-9)), 1, 1e-14);
  auto slab = unit_cube();
  for (auto& point : slab) point[2] *= 0.01;
  EXPECT_NEAR(scaled_jacobian(slab), 1, 1e-14);
}

TEST(HexahedronQuality_analytic, sheared_by_an_angle_it_is_the_cosine_of_that_angle) {
  for (const double angle : {0.1, 0.5, 1.2}) {
    auto sheared = unit_cube();
    for (auto& point : sheared) point[0] += std::tan(angle) * point[2];
    EXPECT_NEAR(scaled_jacobian(sheared), std::cos(angle), 1e-14);
  }
}

TEST(HexahedronQuality_analytic, the_worst_corner_counts) {
  for (int corner = 0; corner < 8; ++corner) {
    auto dented = unit_cube();
    const Point centre{0.5, 0.5, 0.5};
    for (int axis = 0; axis < 3; ++axis) dented[corner][axis] += 0.6 * (centre[axis] - dented[corner][axis]);
    // Moved 0.3 along each axis: its own edges become (0.7, -0.3, -0.3) and permutations, with det 0.7^3 - 3
    // (0.7)(0.09) - 2 (0.027).
    const double own = (0.343 - 0.189 - 0.054) / std::pow(0.49 + 0.18, 1.5);
    EXPECT_NEAR(scaled_jacobian(dented), own, 1e-14) << corner;
  }
}

TEST(HexahedronQuality_analytic, inverted_is_negative_and_collapsed_is_zero) {
  auto inverted = unit_cube();
  for (int i = 0; i < 4; ++i) std::swap(inverted[i], inverted[i + 4]);
  EXPECT_NEAR(scaled_jacobian(inverted), -1, 1e-15);
  auto collapsed = unit_cube();
  collapsed[1] = collapsed[0];
  EXPECT_EQ(scaled_jacobian(collapsed), 0);
}

TEST(TetrahedronQuality_analytic, regular_one_is_best_at_any_size) {
  for (const double size : {1., 3e-9}) {
    const auto tetrahedron = regular_tetrahedron(size);
    EXPECT_NEAR(scaled_jacobian(tetrahedron), 1, 1e-13);
    EXPECT_NEAR(radius_ratio(tetrahedron), 1, 1e-13);
    EXPECT_NEAR(smallest_dihedral_angle(tetrahedron), std::acos(1. / 3), 1e-13);
    EXPECT_NEAR(volume(tetrahedron), std::pow(size, 3) / (6 * std::sqrt(2.)), std::pow(size, 3) * 1e-14);
  }
}

TEST(TetrahedronQuality_analytic, corner_of_a_cube) {
  const std::array<Point, 4> corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  EXPECT_NEAR(volume(corner), 1. / 6, 1e-15);
  // r = 1 / (3 + sqrt 3), R = sqrt(3) / 2; dihedral angles: 90 degrees and atan(sqrt 2).
  EXPECT_NEAR(radius_ratio(corner), 3 / (3 + std::sqrt(3.)) / (std::sqrt(3.) / 2), 1e-14);
  EXPECT_NEAR(smallest_dihedral_angle(corner), std::atan(std::sqrt(2.)), 1e-14);
  EXPECT_NEAR(scaled_jacobian(corner), std::sqrt(2.) / 2, 1e-14);  // largest product: 1 sqrt2 sqrt2
}

TEST(TetrahedronQuality_analytic, sliver_is_bad_and_inverted_is_negative) {
  const std::array<Point, 4> sliver{{{1, 0, 0}, {0, 1, 1e-3}, {-1, 0, 0}, {0, -1, 1e-3}}};
  EXPECT_LT(std::abs(radius_ratio(sliver)), 1e-2);
  EXPECT_LT(smallest_dihedral_angle(sliver), 1e-2);
  auto inverted = regular_tetrahedron();
  std::swap(inverted[0], inverted[1]);
  EXPECT_NEAR(radius_ratio(inverted), -1, 1e-13);
  EXPECT_NEAR(scaled_jacobian(inverted), -1, 1e-13);
}

}  // namespace asperity::meshing
