#include "meshing/triangles/gap_query.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/error.h"
#include "tests/meshing/triangles/bodies.h"

namespace asperity::meshing {

using testing::box;
using testing::hemisphere;
using testing::waves;

namespace {

constexpr double radius = 8.5e-6;

std::vector<std::array<double, 2>> random_places(double half_width, int count) {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> coordinate(-half_width, half_width);
  std::vector<std::array<double, 2>> places(count);
  for (auto& place : places) place = {coordinate(engine), coordinate(engine)};
  return places;
}

double longest_edge_within(const TriangleSurface& surface, double half_width) {
  double longest = 0;
  for (const auto& triangle : surface.triangles)
    for (int side = 0; side < 3; ++side) {
      const auto &a = surface.points[triangle[side]], &b = surface.points[triangle[(side + 1) % 3]];
      if (a[2] < radius / 2 && std::max(std::abs(a[0]), std::abs(a[1])) < 2 * half_width)
        longest = std::max(longest, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
    }
  return longest;
}

}  // namespace

TEST(GapQuery_analytic, sphere_over_plane_within_the_sagitta_of_its_facets) {
  constexpr double half_width = 1e-6, separation = 20e-9;
  const auto plane = box(4e-6, 4e-6, 4e-6);  // its top is at z = 4 um
  double previous_error = 0;
  for (const std::uint32_t cells : {24, 48}) {
    const auto block = hemisphere(cells, radius, nullptr, 1.5);
    const auto sphere = triangles_of_quads(block.points, block.quads);
    const double edge = longest_edge_within(sphere, half_width);
    const auto placed = translated(sphere, {0, 0, 4e-6 + separation});
    const auto places = random_places(half_width, 4000);
    const auto gaps = vertical_gaps(SurfaceQuery(plane), SurfaceQuery(placed), places);
    // A facet whose corners lie on the sphere is inside it, by R - sqrt(R^2 - rho^2) at most, with rho its
    // circumradius; right-angled facets, as the split quads are nearly, have rho = half their longest edge.
    // The factor takes the normal's slope.
    const double rho = 0.52 * edge, slope_factor = 1 / std::sqrt(1 - 2 * std::pow(half_width / radius, 2));
    const double sagitta = (radius - std::sqrt(radius * radius - rho * rho)) * slope_factor;
    double largest_error = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double exact = separation + radius -
                           std::sqrt(radius * radius - std::pow(places[i][0], 2) - std::pow(places[i][1], 2));
      EXPECT_GT(gaps[i], exact - 1e-18);
      EXPECT_LT(gaps[i], exact + sagitta);
      largest_error = std::max(largest_error, gaps[i] - exact);
    }
    EXPECT_GT(largest_error, sagitta / 4) << "the bound is not idle";
    if (previous_error > 0) {
      EXPECT_GT(previous_error / largest_error, 2);
    }
    previous_error = largest_error;
  }
}

TEST(GapQuery_analytic, closest_distance_to_a_sphere_is_signed) {
  const auto block = hemisphere(48, radius);
  const SurfaceQuery sphere(triangles_of_quads(block.points, block.quads));
  ASSERT_TRUE(sphere.closed());
  const double edge = 8.5e-6 * M_PI / 2 / 48 * 2.2, sagitta = edge * edge / (8 * radius) * 1.3;
  const Point centre{0, 0, radius};
  for (const double distance : {-1e-6, -50e-9, 50e-9, 3e-6}) {
    std::vector<Point> points;
    for (const double polar : {0.0, 0.3, 0.7, 1.1})
      for (const double azimuth : {0.2, 2.0, 4.5}) {
        const double reach = radius + distance;
        points.push_back({centre[0] + reach * std::sin(polar) * std::cos(azimuth),
                          centre[1] + reach * std::sin(polar) * std::sin(azimuth),
                          centre[2] - reach * std::cos(polar)});
      }
    for (const double signed_distance : sphere.signed_distances(points)) {
      EXPECT_GT(signed_distance, distance - 1e-15);
      EXPECT_LT(signed_distance, distance + sagitta);
    }
  }
}

TEST(GapQuery_analytic, distances_to_a_box_face_edge_and_corner) {
  const SurfaceQuery cube(box(2e-9, 2e-9, 2e-9, 2));
  EXPECT_NEAR(cube.distance({0, 0, 5e-9}), 3e-9, 1e-23);
  EXPECT_NEAR(cube.distance({4e-9, 5e-9, 1e-9}), 5e-9, 1e-23);
  EXPECT_NEAR(cube.signed_distance({2e-9, 2e-9, 3e-9}), std::sqrt(3.) * 1e-9, 1e-23);
  EXPECT_NEAR(cube.signed_distance({0.2e-9, 0.1e-9, 0.4e-9}), -0.4e-9, 1e-23);
  const Point nearest = cube.nearest_point({0.3e-9, -7e-9, 0.6e-9});
  EXPECT_NEAR(nearest[0], 0.3e-9, 1e-23);
  EXPECT_NEAR(nearest[1], -1e-9, 1e-23);
  EXPECT_NEAR(nearest[2], 0.6e-9, 1e-23);
}

TEST(GapQuery_analytic, rough_heights_follow_bilinear_interpolation_within_the_cell_twist) {
  HeightField field{41, 31, 5e-9, 5e-9, -100e-9, -75e-9, {}};
  for (int iy = 0; iy < field.ny; ++iy)
    for (int ix = 0; ix < field.nx; ++ix)
      field.heights.push_back(
          waves(field.origin_x + ix * field.dx, field.origin_y + iy * field.dy, 2e-9, 30e-9));
  const SurfaceQuery query(triangles_of_heights(field));
  EXPECT_FALSE(query.closed());
  double largest_share = 0;
  for (const auto& [x, y] : random_places(70e-9, 3000)) {
    const double u = (x - field.origin_x) / field.dx, v = (y - field.origin_y) / field.dy;
    const int ix = static_cast<int>(u), iy = static_cast<int>(v);
    const double s = u - ix, t = v - iy;
    const auto z = [&](int dx, int dy) { return field.heights[(iy + dy) * field.nx + ix + dx]; };
    const double bilinear =
        (1 - s) * (1 - t) * z(0, 0) + s * (1 - t) * z(1, 0) + (1 - s) * t * z(0, 1) + s * t * z(1, 1);
    const double twist = std::abs(z(0, 0) + z(1, 1) - z(1, 0) - z(0, 1));
    EXPECT_LE(std::abs(query.highest_z(x, y) - bilinear), twist / 4 + 1e-20);
    EXPECT_EQ(query.highest_z(x, y), query.lowest_z(x, y));
    if (twist > 0)
      largest_share = std::max(largest_share, std::abs(query.highest_z(x, y) - bilinear) / (twist / 4));
  }
  EXPECT_GT(largest_share, 0.9) << "the bound is not idle";
}

TEST(GapQuery_analytic, rough_over_rough_gap_at_nodes_is_the_difference_of_heights) {
  HeightField lower{33, 33, 5e-9, 5e-9, 0, 0, {}}, upper{65, 65, 2.5e-9, 2.5e-9, 0, 0, {}};
  const auto below = [](double x, double y) { return waves(x, y, 2e-9, 40e-9); };
  const auto above = [](double x, double y) { return 30e-9 - waves(y, -x, 1e-9, 25e-9); };
  for (auto* field : {&lower, &upper})
    for (int iy = 0; iy < field->ny; ++iy)
      for (int ix = 0; ix < field->nx; ++ix)
        field->heights.push_back(field == &lower ? below(ix * field->dx, iy * field->dy)
                                                 : above(ix * field->dx, iy * field->dy));
  std::vector<std::array<double, 2>> nodes;
  for (int iy = 0; iy < lower.ny; ++iy)
    for (int ix = 0; ix < lower.nx; ++ix) nodes.push_back({ix * lower.dx, iy * lower.dy});
  const SurfaceQuery lower_query(triangles_of_heights(lower));
  const auto upper_surface = triangles_of_heights(upper);
  const auto gaps = vertical_gaps(lower_query, SurfaceQuery(upper_surface), nodes);
  double smallest = 1;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double exact = above(nodes[i][0], nodes[i][1]) - below(nodes[i][0], nodes[i][1]);
    EXPECT_NEAR(gaps[i], exact, 1e-18) << i;
    smallest = std::min(smallest, exact);
  }
  const double shift = shift_to_first_contact(gaps);
  EXPECT_NEAR(shift, -smallest, 1e-18);
  const auto touching =
      vertical_gaps(lower_query, SurfaceQuery(translated(upper_surface, {0, 0, shift})), nodes);
  EXPECT_NEAR(*std::min_element(touching.begin(), touching.end()), 0, 1e-18);
}

TEST(GapQuery_behaviour, a_missed_surface_has_no_gap) {
  const SurfaceQuery lower(box(1e-6, 1e-6, 1e-6)), upper(translated(box(2e-6, 2e-6, 1e-6), {0, 0, 1.5e-6}));
  const auto gaps = vertical_gaps(lower, upper, {{0.1e-6, 0.2e-6}, {0.8e-6, 0}, {9e-6, 0}});
  EXPECT_NEAR(gaps[0], 0.5e-6, 1e-18);
  EXPECT_TRUE(std::isnan(gaps[1]));
  EXPECT_TRUE(std::isnan(gaps[2]));
  EXPECT_THROW(shift_to_first_contact({gaps[1], gaps[2]}), InputError);
  EXPECT_THROW(SurfaceQuery(TriangleSurface{}), InputError);
  EXPECT_THROW(SurfaceQuery(triangles_of_heights({2, 2, 1e-9, 1e-9, 0, 0, {0, 0, 0, 0}}))
                   .signed_distance({0, 0, 1e-9}),
               InputError);
}

}  // namespace asperity::meshing
