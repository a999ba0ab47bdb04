#include "fem/contact/contact_area.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace asperity::fem;

/// Hertz' pressure and gap (Johnson 1985 eqs. 3.39, 3.42) of E* = R = 1 on a lattice with n spacings per
/// radius; nodes up to `reach` spacings beyond the edge carry a little, as those of finite elements do.
struct HertzLattice {
  std::vector<std::array<int, 4>> quads;
  std::vector<std::array<double, 2>> points;
  std::vector<double> pressure, gap;
  double a = 0.05;

  HertzLattice(double spacings, double shift, double reach = 2 * outset) {
    const double h = a / spacings;
    const int half = static_cast<int>(1.4 * spacings), n = 2 * half + 1;
    for (int j = -half; j <= half; ++j)
      for (int i = -half; i <= half; ++i) {
        points.push_back({(i + shift) * h, (j + 0.6 * shift) * h});
        const double s = std::hypot(points.back()[0], points.back()[1]) / a;
        pressure.push_back(s < 1 + reach / spacings ? 2 * a / M_PI * std::sqrt(std::max(1e-6, 1 - s * s))
                                                    : 0);
        gap.push_back(s > 1 ? a * a / M_PI * ((s * s - 2) * std::acos(1 / s) + std::sqrt(s * s - 1)) : 0);
      }
    for (int j = 0; j + 1 < n; ++j)
      for (int i = 0; i + 1 < n; ++i)
        quads.push_back({j * n + i, j * n + i + 1, (j + 1) * n + i, (j + 1) * n + i + 1});
  }
  double radius() const { return std::sqrt(contact_shape(quads, points, pressure, gap, 1.0).area / M_PI); }
};

TEST(ContactArea_analytic, edge_between_two_nodes_is_where_pressure_and_gap_vanish_together) {
  for (const double s : {0.05, 0.3, 0.5, 0.9}) {
    const double modulus = 3, slope = 2, h = 0.1;
    const double p = slope * std::sqrt(s * h), g = 4 * slope / (3 * modulus) * std::pow((1 - s) * h, 1.5);
    EXPECT_NEAR(edge_fraction(p, g, h, modulus), s, 1e-9);
  }
}

TEST(ContactArea_analytic, radius_of_a_circle_of_closed_nodes_is_found_within_a_tenth_of_a_spacing) {
  for (const double spacings : {3.0, 5.0, 8.0, 12.0})
    for (const double shift : {0.0, 0.25, 0.5}) {
      const HertzLattice lattice(spacings, shift);
      EXPECT_NEAR((lattice.radius() - lattice.a) * spacings / lattice.a, 0, 0.1)
          << spacings << " spacings, shifted by " << shift;
    }
}

TEST(ContactArea_analytic, all_closed_is_the_whole_and_corner_contacts_stay_apart) {
  const std::vector<std::array<int, 4>> quad{{0, 1, 2, 3}};
  const std::vector<std::array<double, 2>> points{{0, 0}, {2, 0}, {0, 1}, {2, 1}};
  EXPECT_DOUBLE_EQ(contact_shape(quad, points, {1, 1, 1, 1}, {0, 0, 0, 0}, 1).area, 2);
  EXPECT_DOUBLE_EQ(contact_shape(quad, points, {0, 0, 0, 0}, {1, 1, 1, 1}, 1).area, 0);
  const double corner = contact_shape(quad, points, {1, 0, 0, 0}, {0, 1, 1, 1}, 1).area,
               both = contact_shape(quad, points, {1, 0, 0, 1}, {0, 1, 1, 0}, 1).area;
  EXPECT_GT(corner, 0);
  EXPECT_LT(corner, 0.5);
  EXPECT_NEAR(both, 2 * corner, 1e-12);
}

TEST(ContactArea_analytic, perimeter_of_hertz_is_that_of_the_circle_and_it_is_one_spot) {
  for (const double spacings : {4.0, 8.0, 16.0}) {
    const HertzLattice lattice(spacings, 0.3, 0);
    const ContactShape shape =
        contact_shape(lattice.quads, lattice.points, lattice.pressure, lattice.gap, 1.0);
    EXPECT_NEAR(shape.perimeter / (2 * M_PI * lattice.a), 1, 0.2 / spacings) << spacings << " spacings";
    EXPECT_EQ(shape.spots, 1);
  }
}

TEST(ContactArea_analytic, spots_that_touch_at_a_corner_alone_are_two_and_their_edges_add_up) {
  const std::vector<std::array<int, 4>> quad{{0, 1, 2, 3}};
  const std::vector<std::array<double, 2>> points{{0, 0}, {2, 0}, {0, 1}, {2, 1}};
  const ContactShape one = contact_shape(quad, points, {1, 0, 0, 0}, {0, 1, 1, 1}, 1),
                     two = contact_shape(quad, points, {1, 0, 0, 1}, {0, 1, 1, 0}, 1);
  EXPECT_EQ(one.spots, 1);
  EXPECT_EQ(two.spots, 2);
  EXPECT_NEAR(two.perimeter, 2 * one.perimeter, 1e-12);
  EXPECT_EQ(contact_shape(quad, points, {1, 1, 0, 1}, {0, 0, 1, 0}, 1).spots, 1);
  EXPECT_EQ(contact_shape(quad, points, {1, 1, 1, 1}, {0, 0, 0, 0}, 1).perimeter, 0);
}

}  // namespace
