#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>
#include <gtest/gtest.h>

#include <limits>

#include "meshing/triangles/surface_check.h"
#include "meshing/triangles/triangle_surface.h"
#include "tests/meshing/triangles/bodies.h"

namespace asperity::meshing {

namespace {

/// Unit cube refined `levels` times towards the middle of its top face and one of its edges, as contact
/// meshes are.
dealii::Triangulation<3> graded_cube(int levels) {
  dealii::Triangulation<3> cube(dealii::Triangulation<3>::limit_level_difference_at_vertices);
  dealii::GridGenerator::hyper_cube(cube);
  cube.refine_global(2);
  for (int level = 0; level < levels; ++level) {
    for (const auto& cell : cube.active_cell_iterators()) {
      const double reach = 1.2 * cell->diameter();
      const dealii::Point<3> centre = cell->center();
      if (centre.distance({0.5, 0.5, 1}) < reach || std::hypot(centre[0], centre[1]) < 0.4 * reach)
        cell->set_refine_flag();
    }
    cube.execute_coarsening_and_refinement();
  }
  return cube;
}

/// Boundary faces as quads that face outward.
std::vector<QuadIndices> boundary_quads(const dealii::Triangulation<3>& triangulation) {
  std::vector<QuadIndices> quads;
  for (const auto& cell : triangulation.active_cell_iterators())
    for (const auto face_number : cell->face_indices()) {
      const auto face = cell->face(face_number);
      if (!face->at_boundary()) continue;
      QuadIndices quad{face->vertex_index(0), face->vertex_index(1), face->vertex_index(3),
                       face->vertex_index(2)};
      const auto normal =
          dealii::cross_product_3d(face->vertex(1) - face->vertex(0), face->vertex(2) - face->vertex(0));
      if (normal * (face->center() - cell->center()) < 0) std::swap(quad[1], quad[3]);
      quads.push_back(quad);
    }
  return quads;
}

}  // namespace

TEST(HangingNodes_analytic, surface_of_an_octree_mesh_is_closed_and_has_its_volume) {
  const auto cube = graded_cube(5);
  ASSERT_TRUE(cube.has_hanging_nodes());
  std::vector<Point> points;
  for (const auto& vertex : cube.get_vertices())
    points.push_back({vertex[0] * 1e-6, vertex[1] * 1e-6, vertex[2] * 1e-6});
  const auto surface = triangles_of_quads(points, boundary_quads(cube));
  const auto check = check_surface(surface);
  EXPECT_TRUE(check.bounds_a_body()) << check.defects();
  // A sum of n terms of one sign is rounded by at most n epsilon (Higham 2002, section 4.2).
  const double rounding =
      static_cast<double>(surface.triangles.size()) * std::numeric_limits<double>::epsilon();
  EXPECT_NEAR(check.area / 6e-12, 1, rounding);
  EXPECT_NEAR(check.volume / 1e-18, 1, rounding);
}

TEST(HangingNodes_behaviour, rough_surface_of_an_octree_mesh_is_closed) {
  const auto cube = graded_cube(5);
  std::vector<Point> points;
  for (const auto& vertex : cube.get_vertices())
    points.push_back({vertex[0] * 1e-6, vertex[1] * 1e-6,
                      vertex[2] * (1e-6 + testing::waves(vertex[0] * 1e-6, vertex[1] * 1e-6, 4e-9, 60e-9))});
  const auto check = check_surface(triangles_of_quads(points, boundary_quads(cube)));
  EXPECT_TRUE(check.bounds_a_body()) << check.defects();
}

}  // namespace asperity::meshing
