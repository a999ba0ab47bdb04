#include "fem/case/mesh_quality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/quantity.h"
#include "fem/case/case_setup.h"
#include "fem/contact/contact_system.h"
#include "fem/levels/boundary_surface.h"
#include "meshing/triangles/gap_query.h"
#include "meshing/triangles/surface_check.h"
#include "tests/fem/support/sphere_on_silicon.h"
#include "tests/support/temporary_folder.h"

namespace asperity::fem {
namespace {

using test::generated;
using test::sphere_on_silicon;

struct Meshed {
  explicit Meshed(const CaseInput& input) : Meshed(set_up(input).system.mesh) {}
  explicit Meshed(const meshing::ContactMeshOptions& mesh)
      : options(mesh),
        geometry(options),
        forest(meshing::make_forest(MPI_COMM_WORLD, options)),
        level(*forest, Control::force),
        positions(level.node_positions(geometry)) {}
  HexMeshQuality quality() const { return hex_mesh_quality(level, positions, options); }
  meshing::TriangleSurface surface(meshing::Body body) const {
    return boundary_surface(level, positions, body);
  }

  meshing::ContactMeshOptions options;
  meshing::RoughGeometry geometry;
  std::unique_ptr<meshing::Triangulation> forest;
  MeshLevel level;
  Vector<double> positions;
};

void expect_good(const HexMeshQuality& quality) {
  for (int body = 0; body < 2; ++body) {
    EXPECT_GT(quality.smallest_scaled_jacobian[body], smallest_allowed_scaled_jacobian) << "body " << body;
    EXPECT_NEAR(quality.roughness[body].sq_ratio(), 1, allowed_roughness_error) << "body " << body;
  }
}

TEST(MeshQuality_behaviour, smooth_bodies_have_well_shaped_hexahedra) {
  const Meshed mesh(sphere_on_silicon("smooth", "smooth", 20e-9, 400e-9));
  const auto quality = mesh.quality();
  expect_good(quality);
  EXPECT_TRUE(quality.roughness[0].smooth());
}

/// Facets of n cells over a wave keep sin^2(pi/n) / (pi/n)^2 of its slope variance, as linear interpolation
/// does.
TEST(MeshQuality_analytic, facets_miss_of_a_wave_what_linear_interpolation_misses) {
  constexpr double spacing = 20e-9, amplitude = 0.5e-9;
  for (const double cells_per_wave : {8.0, 4.0, 2.5}) {
    meshing::ContactMeshOptions options =
        set_up(sphere_on_silicon("smooth", "smooth", spacing, 400e-9)).system.mesh;
    const double q = 2 * M_PI / (cells_per_wave * spacing);
    options.substrate_height = [=](double x, double) { return amplitude * std::sin(q * x); };
    options.largest_height_substrate = amplitude;
    const RoughnessFidelity missed = Meshed(options).quality().roughness[1];
    const double half = M_PI / cells_per_wave, kept = std::pow(std::sin(half) / half, 2);
    EXPECT_NEAR(missed.missed_slope_share(), 1 - kept, 0.03 + 0.1 * (1 - kept)) << cells_per_wave;
    EXPECT_NEAR(missed.rms_slope, amplitude * q / std::sqrt(2.0), 0.03 * amplitude * q) << cells_per_wave;
  }
}

/// A mesh of a twelfth of the contact radius on waves of its own spacing keeps the nodes' Sq and misses half
/// of the slope variance.
TEST(MeshQuality_behaviour, a_mesh_whose_facets_miss_the_slopes_is_refused_though_its_nodes_keep_the_Sq) {
  const Meshed mesh(sphere_on_silicon("smooth", generated(1.5, 40, 3), 40e-9, 700e-9));
  const HexMeshQuality quality = mesh.quality();
  EXPECT_GT(quality.roughness[1].missed_slope_share(), 0.4);
  const auto message =
      test::message_of<InputError>([&] { require_quality(quality, mesh.options, "test.prm"); });
  EXPECT_NE(message.find("of the topography's slope variance"), std::string::npos) << message;
  const Meshed fine(sphere_on_silicon("smooth", generated(1.5, 40, 3), 10e-9, 250e-9));
  EXPECT_LT(fine.quality().roughness[1].missed_slope_share(), worth_saying_of_slopes);
  EXPECT_NO_THROW(require_quality(fine.quality(), fine.options, "test.prm"));
}

TEST(MeshQuality_behaviour,
     the_way_from_fine_cells_to_the_border_of_the_cap_is_as_gentle_for_any_distance_rolled) {
  CaseInput input = sphere_on_silicon("smooth", "smooth", 32e-9, 0);
  input.experiment.type = Motion::rolling;
  input.experiment.normal_load = 200e-6;
  constexpr double gentle = 0.28;  // with the finest cells far from the border: 0.297
  for (const double distance : {0.2e-6, 0.6e-6, 0.8e-6, 0.9e-6, 1.0e-6, 1.1e-6, 1.2e-6, 1.4e-6, 1.7e-6}) {
    input.experiment.distance = distance;
    EXPECT_GT(Meshed(input).quality().smallest_scaled_jacobian[0], gentle) << distance;
  }
}

/// The longest path that the message of a refused case names [m].
double longest_path(CaseInput input) {
  input.experiment.distance = 100e-6;
  try {
    check_extent(input);
  } catch (const InputError& error) {
    const std::string message = error.what(), before = "set it to ", after = " or less";
    const auto from = message.find(before) + before.size();
    return parse_quantity(message.substr(from, message.find(after) - from), Dimension::length);
  }
  return 0;
}

TEST(MeshQuality_behaviour, cells_are_good_for_the_longest_way_that_a_contact_may_roll) {
  struct Contact {
    double load, spacing, path_length;
  };
  for (const auto& [load, spacing, path_length] :
       {Contact{100e-6, 32e-9, 5e-6}, {3e-3, 100e-9, 3.9e-6}, {15e-3, 200e-9, 2e-6}}) {
    CaseInput input = sphere_on_silicon("smooth", "smooth", spacing, 0);
    input.experiment.type = Motion::rolling;
    input.experiment.normal_load = load;
    input.experiment.distance = longest_path(input);
    EXPECT_GT(input.experiment.distance, path_length) << load;
    EXPECT_GT(Meshed(input).quality().smallest_scaled_jacobian[0], smallest_allowed_scaled_jacobian) << load;
  }
}

TEST(MeshQuality_behaviour, a_fine_region_that_is_wide_for_its_body_keeps_its_spacing_and_good_cells) {
  CaseInput input = sphere_on_silicon("smooth", "smooth", 32e-9, 0);
  input.experiment.type = Motion::rolling;
  input.experiment.normal_load = 200e-6;
  input.experiment.distance = 1.7e-6;
  const Meshed mesh(input);
  expect_good(mesh.quality());
  const auto& sizes = mesh.options.sizes;
  const meshing::BodyMap& map = mesh.geometry.map();
  const double cells = std::pow(2.0, map.finest_level(meshing::Body::particle));
  double before = 0, widest = 0;
  for (double x = 0, k = 1; x < sizes.region_particle + sizes.reach_particle; ++k, before = x) {
    x = map.position(meshing::cap, {0.5 + k / cells, 0.5, 0})[0];
    widest = std::max(widest, x - before);
  }
  EXPECT_LT(widest, 1.01 * sizes.spacing_particle);
}

CaseInput rolling(double spacing, double distance, double region) {
  CaseInput input = sphere_on_silicon("smooth", "smooth", spacing, region);
  input.experiment.type = Motion::rolling;
  input.experiment.normal_load = 300e-6;
  input.experiment.distance = distance;
  return input;
}

TEST(MeshQuality_behaviour, no_cell_of_the_cap_is_wider_than_those_below_it) {
  constexpr double gentle =
      0.28;  // as above; 0.045 at 31 nm where finer cells below hung their nodes on a wide one
  for (const double spacing : {30e-9, 31e-9, 32e-9, 33e-9, 34e-9})
    EXPECT_GT(Meshed(rolling(spacing, 450e-9, 585e-9)).quality().smallest_scaled_jacobian[0], gentle)
        << spacing;
}

TEST(MeshQuality_behaviour, a_block_finely_meshed_far_from_the_contact_keeps_good_cells) {
  constexpr double gentle = 0.28;  // 0.185 where the last cells were 10.2 times as wide as the first
  EXPECT_GT(Meshed(rolling(46.6e-9, 2.2e-6, 0)).quality().smallest_scaled_jacobian[1], gentle);
}

TEST(MeshQuality_behaviour, bad_cells_of_a_smooth_body_are_not_blamed_on_roughness) {
  HexMeshQuality quality;
  quality.smallest_scaled_jacobian = {0.1, 0.9};
  try {
    require_quality(quality, meshing::ContactMeshOptions{}, "test.prm");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find("roughness"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("Experiment/Distance"), std::string::npos);
  }
}

class RoughMesh_behaviour : public testing::TestWithParam<double> {};

TEST_P(RoughMesh_behaviour, of_4p8_nm_rms_keeps_its_shape_and_follows_the_topography) {
  const std::string size = "1.6 um";
  const Meshed mesh(sphere_on_silicon(generated(4.8, GetParam(), 1, size),
                                      generated(4.8, GetParam(), 2, size), 5e-9, 250e-9));
  const auto quality = mesh.quality();
  expect_good(quality);
  for (const auto& roughness : quality.roughness) {
    EXPECT_GT(roughness.sq_topography, 4.8e-9);  // these seeds are rougher here than on average
    EXPECT_LT(roughness.sq_deviation, 1e-6 * roughness.sq_topography);  // nodes lie on it
  }
  for (const auto body : {meshing::Body::particle, meshing::Body::substrate})
    EXPECT_EQ(meshing::check_surface(mesh.surface(body)).defects(), "");
}

INSTANTIATE_TEST_SUITE_P(shortest_wave_in_nm, RoughMesh_behaviour, testing::Values(40.0, 20.0));

TEST(MeshQuality_behaviour, waves_that_fall_between_the_nodes_are_refused) {
  Meshed mesh(sphere_on_silicon("smooth", "smooth", 20e-9, 200e-9));
  const double spacing = mesh.options.sizes.spacing_substrate;
  mesh.options.substrate_height = [spacing](double x, double) {
    return 1e-9 * std::cos(2 * M_PI * x / spacing);
  };
  const meshing::RoughGeometry geometry(mesh.options);
  const auto quality = hex_mesh_quality(mesh.level, mesh.level.node_positions(geometry), mesh.options);
  EXPECT_NEAR(quality.roughness[1].sq_topography, 1e-9 / std::sqrt(2), 1e-12);
  EXPECT_LT(quality.roughness[1].sq_nodes, 1e-12);
  EXPECT_THROW(require_quality(quality, mesh.options, "test.prm"), InputError);
}

TEST(MeshQuality_behaviour, slopes_too_steep_for_a_mesh_are_refused) {
  HexMeshQuality quality;
  quality.smallest_scaled_jacobian = {0.9, 0.2};
  EXPECT_THROW(require_quality(quality, meshing::ContactMeshOptions{}, "test.prm"), InputError);
  quality.smallest_scaled_jacobian = {0.9, 0.21};
  EXPECT_NO_THROW(require_quality(quality, meshing::ContactMeshOptions{}, "test.prm"));
}

TEST(BodyVolume_analytic, of_hemisphere_and_cube_is_approached_with_the_square_of_the_cell_width) {
  Meshed mesh(sphere_on_silicon("smooth", "smooth", 80e-9, 400e-9));
  const auto& sizes = mesh.options.sizes;
  const double hemisphere = 2.0 / 3 * M_PI * std::pow(sizes.radius, 3),
               cube = std::pow(2 * sizes.block_half_width, 3);
  std::vector<double> errors;
  for (int refinement = 0; refinement < 3; ++refinement) {
    if (refinement > 0) mesh.forest->refine_global(1);
    const MeshLevel level(*mesh.forest, Control::force);
    const auto positions = level.node_positions(mesh.geometry);
    const auto particle = boundary_surface(level, positions, meshing::Body::particle);
    const auto block = boundary_surface(level, positions, meshing::Body::substrate);
    if (refinement == 0) {
      EXPECT_EQ(meshing::check_surface(particle).defects(), "");
      EXPECT_EQ(meshing::check_surface(block).defects(), "");
    }
    EXPECT_NEAR(meshing::volume(block) / cube, 1, 1e-12);
    errors.push_back(1 - meshing::volume(particle) / hemisphere);
  }
  for (int refinement = 1; refinement < 3; ++refinement)
    EXPECT_NEAR(errors[refinement] / errors[refinement - 1], 0.25, 0.05);
  EXPECT_LT(errors.back(), 0.01);
}

/// Heights between two facets of a mesh of this spacing and the surface they stand for, at most, for h(x, y).
double largest_sagitta(const meshing::HeightFunction& h, double spacing, double region) {
  double largest = 0;
  const int n = static_cast<int>(region / spacing);
  for (int j = -n; j <= n; ++j)
    for (int i = -n; i <= n; ++i) {
      const double x = i * spacing, y = j * spacing, s = spacing;
      const double bend_x = h(x + s, y) - 2 * h(x, y) + h(x - s, y),
                   bend_y = h(x, y + s) - 2 * h(x, y) + h(x, y - s);
      const double twist = h(x + s, y + s) - h(x + s, y) - h(x, y + s) + h(x, y);
      largest = std::max(largest, (std::abs(bend_x) + std::abs(bend_y)) / 8 + std::abs(twist) / 4);
    }
  return largest;
}

double largest_difference_from_vertical_gaps(const ContactSystem& system) {
  const meshing::SurfaceQuery lower(
      boundary_surface(system.level(), system.positions(), meshing::Body::substrate)),
      upper(boundary_surface(system.level(), system.positions(), meshing::Body::particle));
  std::vector<std::array<double, 2>> places;
  for (const auto& row : system.rows()) {
    const auto& p = system.interface_points()[row.node];
    places.push_back({p[0], p[1]});
  }
  const auto gaps = meshing::vertical_gaps(lower, upper, places);
  double largest = 0;
  for (std::size_t r = 0; r < gaps.size(); ++r) {
    EXPECT_TRUE(std::isfinite(gaps[r])) << "row " << r;
    largest = std::max(largest, std::abs(gaps[r] - system.initial_gaps()[r]));
  }
  return largest;
}

TEST(InitialGaps_other_code, of_matching_meshes_equal_CGALs_vertical_gaps) {
  const auto setup = set_up(sphere_on_silicon(generated(1.5, 80, 1), generated(0.7, 80, 2), 10e-9, 300e-9));
  EXPECT_LT(largest_difference_from_vertical_gaps(ContactSystem(MPI_COMM_WORLD, setup.system)),
            1e-6 * setup.rms_particle);
}

TEST(InitialGaps_other_code, of_shifted_meshes_agree_with_CGALs_vertical_gaps_within_the_facets_sagitta) {
  auto setup = set_up(sphere_on_silicon(generated(1.5, 80, 1), generated(0.7, 80, 2), 10e-9, 300e-9));
  auto& mesh = setup.system.mesh;
  mesh.sizes.offset_substrate_x = 0.37 * mesh.sizes.spacing_substrate;
  mesh.sizes.offset_substrate_y = 0.21 * mesh.sizes.spacing_substrate;
  const double difference =
      largest_difference_from_vertical_gaps(ContactSystem(MPI_COMM_WORLD, setup.system));
  const double sagitta =
      largest_sagitta(mesh.substrate_height, mesh.sizes.spacing_substrate, mesh.sizes.region_substrate);
  EXPECT_GT(difference, 0);
  EXPECT_LT(difference, sagitta);
}

TEST(MeshQuality_behaviour, bad_cells_of_a_rough_body_are_blamed_on_what_makes_them) {
  HexMeshQuality quality;
  quality.smallest_scaled_jacobian[1] = 0.1;
  quality.roughness[1].sq_topography = quality.roughness[1].sq_nodes = 1e-9;
  quality.roughness[1].rms_slope = 0.1;
  const auto message = [&] {
    return test::message_of<InputError>([&] { require_quality(quality, {}, "test.prm"); });
  };
  quality.without_roughness[1] = 0.1;
  EXPECT_NE(message().find("the transition from fine cells at the contact to the body's border"),
            std::string::npos)
      << message();
  EXPECT_EQ(message().find("slopes"), std::string::npos) << message();
  quality.without_roughness[1] = 0.5;
  EXPECT_NE(message().find("slopes are too steep"), std::string::npos) << message();
}

}  // namespace
}  // namespace asperity::fem
