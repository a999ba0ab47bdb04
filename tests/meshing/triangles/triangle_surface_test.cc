#include "meshing/triangles/triangle_surface.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/error.h"
#include "meshing/triangles/surface_check.h"
#include "tests/meshing/triangles/bodies.h"

namespace asperity::meshing {

using testing::box;
using testing::hemisphere;

TEST(TriangleSurface_analytic, box_has_its_area_and_volume_and_bounds_a_body) {
  const auto surface = box(2e-6, 3e-6, 4e-6, 3);
  const auto check = check_surface(surface);
  EXPECT_NEAR(check.area, 52e-12, 52e-12 * 1e-14);
  EXPECT_NEAR(check.volume, 24e-18, 24e-18 * 1e-14);
  EXPECT_TRUE(check.bounds_a_body());
  EXPECT_EQ(check.components, 1u);
  EXPECT_EQ(surface.triangles.size(), 6u * 9u * 2u);
  EXPECT_EQ(surface.points.size(), 4u * 4u * 4u - 2u * 2u * 2u) << "points inside the block are left out";
}

TEST(TriangleSurface_analytic, hemisphere_volume_converges_with_the_square_of_the_spacing) {
  constexpr double radius = 8.5e-6, exact = 2 * M_PI / 3 * radius * radius * radius;
  std::vector<double> error;
  for (const std::uint32_t cells : {8, 16, 32}) {
    const auto block = hemisphere(cells, radius);
    const auto check = check_surface(triangles_of_quads(block.points, block.quads));
    EXPECT_TRUE(check.bounds_a_body());
    error.push_back(1 - check.volume / exact);
  }
  EXPECT_NEAR(error[0] / error[1], 4, 0.2);
  EXPECT_NEAR(error[1] / error[2], 4, 0.05);
  EXPECT_LT(error[2], 5e-3);
}

TEST(TriangleSurface_behaviour, hanging_nodes_of_a_refined_mesh_leave_no_slit) {
  // Four cells, the one at the corner refined into four: two of its nodes hang on its neighbours.
  std::vector<Point> points;
  for (int iy = 0; iy <= 4; ++iy)
    for (int ix = 0; ix <= 4; ++ix)
      points.push_back({ix * 1e-8, iy * 1e-8, testing::waves(ix * 1e-8, iy * 1e-8, 1e-9, 4e-8)});
  const auto node = [](std::uint32_t ix, std::uint32_t iy) { return iy * 5 + ix; };
  std::vector<QuadIndices> quads;
  const auto add = [&](std::uint32_t ix, std::uint32_t iy, std::uint32_t size) {
    quads.push_back({node(ix, iy), node(ix + size, iy), node(ix + size, iy + size), node(ix, iy + size)});
  };
  for (const std::uint32_t iy : {0, 1})
    for (const std::uint32_t ix : {0, 1}) add(ix, iy, 1);
  add(2, 0, 2);
  add(0, 2, 2);
  add(2, 2, 2);
  const auto check = check_surface(triangles_of_quads(points, quads));
  // The rim alone stays open: four fine edges and six coarse ones.
  EXPECT_EQ(check.boundary_edges, 10u);
  EXPECT_EQ(check.degenerate_triangles, 0u);
  EXPECT_EQ(check.self_intersections, 0u);
  EXPECT_TRUE(check.manifold());
  EXPECT_EQ(check.components, 1u);
}

TEST(TriangleSurface_analytic, flat_plate_with_hanging_nodes_has_no_triangle_without_area) {
  std::vector<Point> points;
  for (int iy = 0; iy <= 2; ++iy)
    for (int ix = 0; ix <= 4; ++ix) points.push_back({ix * 1e-9, iy * 1e-9, 0});
  const auto surface = triangles_of_quads(
      points, {{0, 1, 6, 5}, {1, 2, 7, 6}, {5, 6, 11, 10}, {6, 7, 12, 11}, {2, 4, 14, 12}});
  const auto check = check_surface(surface);
  EXPECT_EQ(surface.triangles.size(), 4u * 2u + 3u);
  EXPECT_EQ(check.degenerate_triangles, 0u);
  EXPECT_EQ(check.boundary_edges, 4u + 2u + 3u);
  EXPECT_NEAR(check.area, 8e-18, 1e-31);
}

TEST(SurfaceCheck_behaviour, tells_an_open_an_inverted_and_a_torn_surface_from_a_body) {
  auto open = box(1e-6, 1e-6, 1e-6, 2);
  open.triangles.pop_back();
  EXPECT_EQ(check_surface(open).boundary_edges, 3u);
  EXPECT_FALSE(check_surface(open).bounds_a_body());

  auto inverted = box(1e-6, 1e-6, 1e-6, 2);
  for (auto& triangle : inverted.triangles) std::swap(triangle[1], triangle[2]);
  const auto check = check_surface(inverted);
  EXPECT_TRUE(check.closed());
  EXPECT_FALSE(check.outward());
  EXPECT_NEAR(check.volume, -1e-18, 1e-31);

  auto one_flipped = box(1e-6, 1e-6, 1e-6, 2);
  std::swap(one_flipped.triangles[0][1], one_flipped.triangles[0][2]);
  EXPECT_EQ(check_surface(one_flipped).non_manifold_edges, 3u);
}

TEST(SurfaceCheck_analytic, finds_the_point_where_two_bodies_touch) {
  auto surface = box(1e-6, 1e-6, 1e-6);
  const auto other = translated(surface, {1e-6, 1e-6, 1e-6});
  const auto offset = static_cast<std::uint32_t>(surface.points.size());
  std::uint32_t shared = 0, shared_in_other = 0;
  for (std::uint32_t i = 0; i < offset; ++i) {
    if (surface.points[i][0] > 0 && surface.points[i][1] > 0 && surface.points[i][2] > 0) shared = i;
    if (surface.points[i][0] < 0 && surface.points[i][1] < 0 && surface.points[i][2] == 0)
      shared_in_other = i;
  }
  surface.points.insert(surface.points.end(), other.points.begin(), other.points.end());
  for (auto triangle : other.triangles) {
    for (auto& index : triangle) index = index == shared_in_other ? shared : index + offset;
    surface.triangles.push_back(triangle);
  }
  const auto check = check_surface(surface);
  EXPECT_EQ(check.components, 2u);
  EXPECT_EQ(check.non_manifold_vertices, 1u);
  EXPECT_EQ(check.non_manifold_edges, 0u);
}

TEST(SurfaceCheck_behaviour, finds_asperities_that_cross_at_every_size_in_use) {
  for (const double size : {1e-9, 1e-7, 1e-5}) {
    const auto block = testing::mapped_block(6, 6, 3, [&](const Point& p) {
      return Point{size * p[0], size * p[1], size * p[2]};
    });
    auto surface = triangles_of_quads(block.points, block.quads);
    EXPECT_EQ(check_surface(surface).self_intersections, 0u) << size;
    // One node of the top pushed through the bottom.
    for (auto& point : surface.points)
      if (std::abs(point[0]) < 1e-3 * size && std::abs(point[1]) < 1e-3 * size && point[2] > 0.9 * size)
        point[2] = -0.1 * size;
    const auto check = check_surface(surface);
    EXPECT_TRUE(check.manifold());
    EXPECT_GT(check.self_intersections, 0u) << size;
    try {
      require_body(check, "the particle");
      ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("cross"), std::string::npos) << error.what();
    }
  }
}

TEST(TriangleSurface_behaviour, missing_heights_leave_a_hole_and_no_invented_height) {
  HeightField field{5, 5, 1e-9, 2e-9, 0, 0, std::vector<double>(25, 3e-9)};
  field.heights[2 * 5 + 2] = std::numeric_limits<double>::quiet_NaN();
  const auto surface = triangles_of_heights(field);
  for (const auto& point : surface.points) EXPECT_EQ(point[2], 3e-9);
  EXPECT_EQ(surface.points.size(), 24u);
  EXPECT_NEAR(area(surface), (16 - 4 * 0.5) * 2e-18, 1e-30)
      << "four cells keep the half whose corners are known";
  const auto check = check_surface(surface);
  EXPECT_TRUE(check.manifold());
  EXPECT_EQ(check.boundary_edges, 16u + 4u);
}

TEST(TriangleSurface_behaviour, refuses_what_cannot_be_a_surface) {
  EXPECT_THROW(triangles_of_quads({{0, 0, 0}}, {}), InputError);
  EXPECT_THROW(triangles_of_quads({{0, 0, 0}}, {{0, 0, 0, 1}}), InputError);
  EXPECT_THROW(triangles_of_heights({2, 2, 1e-9, 1e-9, 0, 0, {0, 0, 0}}), InputError);
  EXPECT_THROW(triangles_of_heights({2, 2, 0, 1e-9, 0, 0, {0, 0, 0, 0}}), InputError);
}

}  // namespace asperity::meshing
