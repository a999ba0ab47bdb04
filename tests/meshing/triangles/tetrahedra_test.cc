#include "meshing/triangles/tetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "meshing/triangles/gap_query.h"
#include "meshing/triangles/quality.h"
#include "meshing/triangles/surface_check.h"
#include "tests/meshing/triangles/bodies.h"

namespace asperity::meshing {

namespace {

constexpr double radius = 8.5e-6, degree = M_PI / 180;

/// What perturbation of the slivers that Delaunay refinement leaves (Tournois et al., Proc. 18th Int. Meshing
/// Roundtable, 2009) reaches on every body tried here; it stops at 12 degrees.
constexpr double least_dihedral_angle = 10 * degree, least_radius_ratio = 0.15;

TriangleSurface rough_hemisphere() {
  const auto rough = [](double x, double y) {
    return testing::waves(x, y, 20e-9, 400e-9) * std::exp(-(x * x + y * y) / 1e-12);
  };
  const auto block = testing::hemisphere(48, radius, rough, 2);
  return triangles_of_quads(block.points, block.quads);
}

TriangleSurface rough_block() {
  const auto block = testing::mapped_block(40, 40, 10, [](const Point& p) {
    const double x = std::copysign(p[0] * p[0], p[0]) * 2e-6, y = std::copysign(p[1] * p[1], p[1]) * 2e-6;
    const double rough = testing::waves(x, y, 10e-9, 300e-9) * std::exp(-(x * x + y * y) / 0.25e-12);
    return Point{x, y, (p[2] - 1) * 3e-6 + p[2] * rough};
  });
  return triangles_of_quads(block.points, block.quads);
}

TetrahedraOptions options_for(double fine_size, double fine_radius) {
  TetrahedraOptions options;
  options.fine_size = fine_size;
  options.fine_radius = fine_radius;
  return options;
}

void expect_sound(const TetrahedralMesh& mesh, const TriangleSurface& surface,
                  const TetrahedraOptions& options) {
  const auto quality_of_mesh = quality(mesh);
  const double volume_of_surface = volume(surface);
  EXPECT_NEAR(quality_of_mesh.volume / volume_of_surface, 1, options.volume_tolerance);
  EXPECT_GT(quality_of_mesh.smallest_dihedral_angle, least_dihedral_angle);
  EXPECT_GT(quality_of_mesh.smallest_radius_ratio, least_radius_ratio);
  EXPECT_GT(quality_of_mesh.mean_radius_ratio, 0.7);
  EXPECT_GT(quality_of_mesh.smallest_scaled_jacobian, 0);
  const auto boundary = check_surface(mesh.surface());
  EXPECT_TRUE(boundary.bounds_a_body()) << boundary.defects();
  EXPECT_NEAR(boundary.volume / quality_of_mesh.volume, 1, 1e-12)
      << "the boundary encloses exactly the tetrahedra";
}

}  // namespace

TEST(Tetrahedra_analytic, block_with_sharp_edges_keeps_its_volume_exactly) {
  const auto surface = testing::box(2e-6, 3e-6, 1e-6, 2);
  const auto options = options_for(0.1e-6, 0.2e-6);
  const auto mesh = tetrahedra(surface, options);
  expect_sound(mesh, surface, options);
  // Facets lie in the faces and their outer edges on the block's edges.
  EXPECT_NEAR(quality(mesh).volume, 6e-18, 6e-18 * 1e-6);
  EXPECT_EQ(*std::max_element(mesh.patch.begin(), mesh.patch.end()), 6);
}

TEST(Tetrahedra_analytic, rough_hemisphere_keeps_its_volume_and_refines_towards_the_contact) {
  const auto surface = rough_hemisphere();
  const auto options = options_for(60e-9, 500e-9);
  const auto mesh = tetrahedra(surface, options);
  expect_sound(mesh, surface, options);
  EXPECT_EQ(*std::max_element(mesh.patch.begin(), mesh.patch.end()), 2)
      << "the ball's surface and the flat face";
  // Sizes: a facet's circumradius is at most the size asked for, so an edge is at most twice it.
  double longest_near = 0, longest = 0;
  for (const auto& triangle : mesh.boundary)
    for (int side = 0; side < 3; ++side) {
      const auto &a = mesh.points[triangle[side]], &b = mesh.points[triangle[(side + 1) % 3]];
      const double length = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
      longest = std::max(longest, length);
      if (a[2] < radius / 2 && std::max(std::hypot(a[0], a[1]), std::hypot(b[0], b[1])) < options.fine_radius)
        longest_near = std::max(longest_near, length);
    }
  EXPECT_LE(longest_near, 2 * options.fine_size * 1.001);
  EXPECT_GT(longest, 10 * options.fine_size);
}

TEST(Tetrahedra_analytic, rough_block_keeps_its_volume_and_its_roughness_at_the_contact) {
  const auto surface = rough_block();
  auto options = options_for(40e-9, 400e-9);
  const auto mesh = tetrahedra(surface, options);
  expect_sound(mesh, surface, options);
  std::vector<std::array<double, 2>> places;
  for (double x = -250e-9; x <= 250e-9; x += 11e-9)
    for (double y = -250e-9; y <= 250e-9; y += 13e-9) places.push_back({x, y});
  const SurfaceQuery original(surface), sampled(mesh.surface());
  double sum_of_squares = 0;
  for (const auto& [x, y] : places)
    sum_of_squares += std::pow(original.highest_z(x, y) - sampled.highest_z(x, y), 2);
  // Each facet's circumcentre is within distance_per_size of the surface; their RMS is less.
  EXPECT_LT(std::sqrt(sum_of_squares / static_cast<double>(places.size())),
            options.distance_per_size * options.fine_size);
}

TEST(Tetrahedra_behaviour, same_input_gives_the_same_mesh) {
  // A box, whose symmetry leaves ties that must not be broken by memory addresses.
  const auto surface = testing::box(1e-6, 1e-6, 1e-6, 2);
  const auto first = tetrahedra(surface, options_for(0.08e-6, 0.1e-6));
  for (int repetition = 0; repetition < 3; ++repetition) {
    const std::vector<char> shifts_the_heap(100000 * (repetition + 1));
    const auto again = tetrahedra(surface, options_for(0.08e-6, 0.1e-6));
    EXPECT_EQ(first.points, again.points);
    EXPECT_EQ(first.tetrahedra, again.tetrahedra);
    EXPECT_EQ(first.boundary, again.boundary);
  }
}

TEST(Tetrahedra_behaviour, refuses_an_open_surface_impossible_options_and_a_missed_volume) {
  auto open = testing::box(1e-6, 1e-6, 1e-6);
  open.triangles.pop_back();
  EXPECT_THROW(tetrahedra(open, options_for(0.1e-6, 0)), InputError);
  const auto box = testing::box(1e-6, 1e-6, 1e-6);
  EXPECT_THROW(tetrahedra(box, options_for(0, 0)), InputError);
  auto too_sharp = options_for(0.1e-6, 0);
  too_sharp.radius_edge_ratio = 1;
  EXPECT_THROW(tetrahedra(box, too_sharp), InputError);
  const auto block = testing::hemisphere(16, radius);
  auto strict = options_for(1e-6, 0);
  strict.volume_tolerance = 1e-6;
  EXPECT_THROW(tetrahedra(triangles_of_quads(block.points, block.quads), strict), WorkError);
}

}  // namespace asperity::meshing
