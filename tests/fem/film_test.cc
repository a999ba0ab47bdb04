// Bodies with films: finite elements against half-spaces in which the film is exact, wave by wave (another
// formulation, half_space/compliance.h), and which of the cells are of what.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/hertz.h"
#include "fem/case/case_setup.h"
#include "fem/levels/cell_materials.h"
#include "half_space/contact_shape.h"
#include "half_space/normal_contact.h"
#include "meshing/contact_mesh.h"
#include "tests/fem/support/smooth_contact.h"
#include "tests/support/verification.h"

namespace asperity {
namespace {

using fem::CellMaterials;
using fem::Film;
using fem::J2Material;
using test::ContactStep;
using test::SmoothContact;
using test::SmoothContactOptions;
using test::Verified;

constexpr double film_test_radius = 8.5e-6, film_test_force = 100e-6;
const ElasticBody sphere_body{71e9, 0.17}, plane_body{179e9, 0.25};

J2Material elastic_material(const ElasticBody& body) {
  return J2Material::elastic(body.youngs_modulus, body.poisson_ratio);
}

struct HalfSpaceContact {
  double approach, radius, peak_pressure;
};

/// The sphere on the plane, with a film on one of them.
HalfSpaceContact by_half_spaces(const half_space::FilmOnBody& film) {
  constexpr int n = 256;
  const half_space::Grid grid = half_space::square_grid(500e-9, n);
  half_space::Field gap(grid.cells());
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const double r2 = grid.x(i) * grid.x(i) + grid.y(j) * grid.y(j), R = film_test_radius;
      gap[static_cast<std::size_t>(j) * n + i] = r2 / (R + std::sqrt(R * R - r2));
    }
  const half_space::NormalContact contact(grid, half_space::Boundary::free,
                                          reduced_modulus(sphere_body, plane_body), gap, {film});
  const auto solution = contact.at_force(film_test_force);
  const auto shape =
      half_space::contact_shape(grid, solution.pressure, std::numeric_limits<double>::infinity());
  return {solution.approach, std::sqrt(shape.area / M_PI),
          *std::max_element(solution.pressure.begin(), solution.pressure.end())};
}

SmoothContactOptions filmed(const ElasticBody& film, int on, double thickness, double radius,
                            double spacing) {
  SmoothContactOptions o;
  o.particle = elastic_material(sphere_body);
  o.substrate = elastic_material(plane_body);
  o.films[on] = Film{elastic_material(film), thickness};
  o.largest_radius = radius;
  o.spacing = spacing;
  return o;
}

struct FilmedCase {
  const char* name;
  ElasticBody film;
  int on;
  double thickness;
};

TEST(Film_other_code, of_another_stiffness_is_that_of_layered_half_spaces) {
  const std::vector<FilmedCase> cases{{"10 GPa, 60 nm on the substrate", {10e9, 0.3}, 1, 60e-9},
                                      {"3 GPa, 0.45, 20 nm on the substrate", {3e9, 0.45}, 1, 20e-9},
                                      {"400 GPa, 50 nm on the particle", {400e9, 0.2}, 0, 50e-9}};
  for (const FilmedCase& c : cases) {
    const HalfSpaceContact exact =
        by_half_spaces({c.film, c.on == 0 ? sphere_body : plane_body, c.thickness});
    const double spacing = std::min(exact.radius / 14, c.thickness / 4);
    SmoothContact contact(filmed(c.film, c.on, c.thickness, exact.radius, spacing));
    const ContactStep step = contact.load(film_test_force);
    ASSERT_TRUE(step.converged) << c.name;
    ASSERT_FALSE(step.reaches_rim) << c.name;
    std::printf("%-36s approach %.3f nm (%+.2f %%) radius %.1f nm (%+.2f %%) pressure %.0f MPa (%+.2f %%)\n",
                c.name, step.approach * 1e9, 100 * (step.approach / exact.approach - 1),
                step.contact_radius * 1e9, 100 * (step.contact_radius / exact.radius - 1),
                step.peak_pressure * 1e-6, 100 * (step.peak_pressure / exact.peak_pressure - 1));
    const std::string of = c.name, source = "half-spaces with films (Nogi & Kato 1997)";
    EXPECT_TRUE(
        (Verified{"Films", "approach, film of " + of, source}.within(step.approach, exact.approach, 0.01)));
    EXPECT_TRUE((Verified{"Films", "contact radius, film of " + of, source}.within(step.contact_radius,
                                                                                   exact.radius, 0.015)));
    EXPECT_TRUE((Verified{"Films", "largest pressure, film of " + of, source}.within(
        step.peak_pressure, exact.peak_pressure, 0.03)));
  }
}

TEST(Film_other_code, thinner_than_a_cell_gives_way_as_much_as_it_does) {
  const ElasticBody polymer{5e9, 0.3};
  constexpr double thickness = 8e-9;
  const HalfSpaceContact exact = by_half_spaces({polymer, plane_body, thickness});
  SmoothContact contact(filmed(polymer, 1, thickness, exact.radius, exact.radius / 14));
  SmoothContact bare([&] {
    auto o = filmed(polymer, 1, thickness, exact.radius, exact.radius / 14);
    o.films = {};
    return o;
  }());
  const ContactStep step = contact.load(film_test_force), without = bare.load(film_test_force);
  ASSERT_TRUE(step.converged);
  const double added = step.approach - without.approach;
  EXPECT_TRUE((Verified{"Films", "what a film of half a cell adds to the approach, 5 GPa, 8 nm",
                        "half-spaces with films (Nogi & Kato 1997)"}
                   .within(added, exact.approach - without.approach, 0.05)));
}

/// For which a mesh is made: of a soft and a stiff film, under a load and at the approach that it makes.
TEST(Film_other_code, contact_radius_of_a_case_is_that_of_layered_half_spaces) {
  for (const ElasticBody& film : {ElasticBody{3e9, 0.45}, ElasticBody{400e9, 0.2}}) {
    const HalfSpaceContact exact = by_half_spaces({film, plane_body, 40e-9});
    CaseInput input;
    input.radius = film_test_radius;
    input.particle.youngs_modulus = sphere_body.youngs_modulus;
    input.particle.poisson_ratio = sphere_body.poisson_ratio;
    input.substrate.youngs_modulus = plane_body.youngs_modulus;
    input.substrate.poisson_ratio = plane_body.poisson_ratio;
    input.substrate.film.thickness = 40e-9;
    input.substrate.film.youngs_modulus = film.youngs_modulus;
    input.substrate.film.poisson_ratio = film.poisson_ratio;
    input.experiment.control = ExperimentInput::Control::force;
    input.experiment.normal_load = film_test_force;
    const double under_load = fem::set_up_sizes(input).filmed_radius;
    input.experiment.control = ExperimentInput::Control::displacement;
    input.experiment.normal_approach = exact.approach;
    const double at_approach = fem::set_up_sizes(input).filmed_radius;
    EXPECT_NEAR(under_load / exact.radius, 1, 0.01) << film.youngs_modulus;
    EXPECT_NEAR(at_approach / exact.radius, 1, 0.01) << film.youngs_modulus;
  }
}

TEST(Film_analytic, of_the_body_s_own_material_changes_nothing) {
  SmoothContact with(filmed(plane_body, 1, 60e-9, 230e-9, 20e-9));
  auto o = filmed(plane_body, 1, 60e-9, 230e-9, 20e-9);
  o.films = {};
  SmoothContact without(o);
  const ContactStep one = with.load(film_test_force), other = without.load(film_test_force);
  EXPECT_NEAR(one.approach / other.approach, 1, 1e-6);
  EXPECT_NEAR(one.peak_pressure / other.peak_pressure, 1, 1e-5);
}

TEST(Film_behaviour, that_yields_does_so_alone_and_gives_way_more) {
  auto o = filmed({10e9, 0.3}, 1, 60e-9, 300e-9, 20e-9);
  SmoothContact elastic(o);
  o.films[1].material.yield_stress = 0.15e9;
  SmoothContact yielding(o);
  const ContactStep one = elastic.load(film_test_force), other = yielding.load(film_test_force);
  ASSERT_TRUE(other.converged);
  EXPECT_EQ(one.plastic_strain, 0);
  EXPECT_GT(other.plastic_strain, 1e-3);
  EXPECT_GT(other.approach, 1.01 * one.approach);
}

TEST(Film_analytic, cells_lie_in_it_with_their_share_of_its_depth) {
  meshing::ContactMeshOptions options;
  options.sizes.radius = film_test_radius;
  options.sizes.block_half_width = 6e-6;
  options.sizes.spacing_particle = options.sizes.spacing_substrate = 20e-9;
  options.sizes.region_particle = options.sizes.region_substrate = 300e-9;
  const meshing::RoughGeometry geometry(options);
  const double size = std::ldexp(1.0, -geometry.map().finest_level(meshing::Body::substrate));
  const meshing::LogicalBox top{meshing::block, {0.5, 0.5, 1 - size}, size},
      below{meshing::block, {0.5, 0.5, 1 - 2 * size}, size}, aside{meshing::side_first, {0, 0, 0}, size};
  const double depth = geometry.map().depth(meshing::block, {0.5, 0.5, 1 - size});
  EXPECT_NEAR(depth, 20e-9, 1e-9);
  EXPECT_DOUBLE_EQ(geometry.film_share(top, 2 * depth), 1);
  EXPECT_NEAR(geometry.film_share(top, 0.25 * depth), 0.25, 1e-12);
  EXPECT_DOUBLE_EQ(geometry.film_share(below, 0.25 * depth), 0);
  EXPECT_DOUBLE_EQ(geometry.film_share(aside, 1), 0);
}

TEST(Film_analytic, a_cell_of_both_is_a_laminate) {
  const J2Material body = elastic_material(plane_body);
  Film film{elastic_material({10e9, 0.3}), 50e-9};
  film.material.yield_stress = 1e9;
  const CellMaterials materials({body, body}, {Film{}, film});
  EXPECT_EQ(materials.number(0, 1), 0);
  EXPECT_EQ(materials.number(1, 0), 1);
  EXPECT_TRUE(materials.can_yield());
  const auto oedometric = [](const J2Material& m) { return m.bulk_modulus + 4.0 / 3 * m.shear_modulus; };
  const J2Material &whole = materials[materials.number(1, 1)], &part = materials[materials.number(1, 0.3)];
  EXPECT_DOUBLE_EQ(whole.shear_modulus, film.material.shear_modulus);
  EXPECT_DOUBLE_EQ(whole.yield_stress, 1e9);
  EXPECT_TRUE(std::isinf(part.yield_stress));
  EXPECT_NEAR(1 / part.shear_modulus, 0.3 / film.material.shear_modulus + 0.7 / body.shear_modulus, 1e-18);
  EXPECT_NEAR(1 / oedometric(part), 0.3 / oedometric(film.material) + 0.7 / oedometric(body), 1e-18);
}

}  // namespace
}  // namespace asperity
