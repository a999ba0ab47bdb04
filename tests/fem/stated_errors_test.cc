// Do the standard deviations that result.json states hold? Rough elastic contacts by finite elements against
// boundary elements of the same surfaces at a fraction of the spacing (half_space/), which know nothing of
// meshes, mortars or multipliers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "fem/case/case_setup.h"
#include "half_space/case_contact.h"
#include "tests/fem/support/solved_experiment.h"
#include "tests/fem/support/sphere_on_silicon.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;
using namespace asperity::test;

/// A rough silicon under the paper's smooth sphere, both elastic.
struct RoughCase {
  double rms, rolloff, cutoff;  ///< [nm]
  int seed;
  double load, spacing;  ///< [uN], [nm]
};

CaseInput input_of(const RoughCase& c) {
  char text[200] = "smooth";
  if (c.rms > 0)
    std::snprintf(text, sizeof text, "generated(rms=%g nm, hurst=0.8, rolloff=%g nm, cutoff=%g nm, seed=%d)",
                  c.rms, c.rolloff, c.cutoff, c.seed);
  CaseInput input = sphere_on_silicon("smooth", text, c.spacing * 1e-9, 0);
  input.experiment.normal_load = c.load * 1e-6;
  input.experiment.unload = false;
  input.experiment.load_steps = 2;
  input.mesh.layers = 3;
  input.solver.threads = 1;
  input.output.fields = false;
  return input;
}

/// Values of `effective` of the same contact by boundary elements in cells of `spacing` [nm] or a little
/// less.
std::map<std::string, double> references_of(const RoughCase& c, double spacing) {
  const CaseInput input = input_of(c);
  const double half = fem::set_up_sizes(input).system.mesh.sizes.region_particle, force = c.load * 1e-6;
  const half_space::Grid grid =
      half_space::square_grid(half, 2 * static_cast<int>(std::ceil(half / (spacing * 1e-9))));
  const half_space::Field gap = half_space::gap_of_case(input, grid);
  const double first_touch = *std::min_element(gap.begin(), gap.end());
  const half_space::NormalContact contact(grid, half_space::Boundary::free, hertz_of(input).reduced_modulus,
                                          gap);
  const auto found = contact.at_force(force);
  const auto shape =
      half_space::contact_shape(grid, found.pressure, half_space::NormalContactOptions().hardness);
  return {{"contact_area", shape.area},           {"contact_radius", std::sqrt(shape.area / M_PI)},
          {"mean_pressure", shape.mean_pressure}, {"max_pressure", shape.largest_pressure},
          {"approach", found.approach},           {"approach_from_first_touch", found.approach - first_touch},
          {"first_touch", first_touch},           {"load_centre_x", shape.centre_x},
          {"load_centre_y", shape.centre_y},      {"normal_stiffness", contact.stiffness(found)}};
}

/// Errors of one case over their stated standard deviations, by quantity.
std::map<std::string, double> errors_over_sd(const RoughCase& c, double reference_spacing) {
  const TemporaryFolder folder;
  const auto effective = solve_experiment(input_of(c), folder.path).result["effective"];
  std::map<std::string, double> errors;
  std::printf("rms %.1f roll-off %.0f cut-off %.0f seed %d load %.0f spacing %.0f:", c.rms, c.rolloff,
              c.cutoff, c.seed, c.load, c.spacing);
  for (const auto& [name, reference] : references_of(c, reference_spacing)) {
    const double value = effective[name]["value"], sd = effective[name]["sd"];
    EXPECT_GT(sd, 0) << name;
    errors[name] = (value - reference) / sd;
    std::printf("  %s %.5g for %.5g (%+.1f sd)", name.c_str(), value, reference, errors[name]);
  }
  std::printf("\n"), std::fflush(stdout);
  return errors;
}

/// At least nine of ten errors of each quantity within two standard deviations, and these no wider than they
/// need be: their mean square is not below a twentieth.
void expect_coverage(const std::vector<RoughCase>& cases, double waves_per_reference_cell) {
  std::map<std::string, std::vector<double>> errors;
  for (const auto& c : cases)
    for (const auto& [name, error] : errors_over_sd(c, c.rms > 0 ? c.cutoff / waves_per_reference_cell : 4))
      errors[name].push_back(error);
  for (const auto& [name, values] : errors) {
    double within = 0, square = 0;
    for (const double e : values)
      within += std::abs(e) <= 2, square += e * e / static_cast<double>(values.size());
    std::printf("%-15s within two sd: %.0f of %zu, root mean square %.2f sd\n", name.c_str(), within,
                values.size(), std::sqrt(square));
    const std::string unit = "of " + std::to_string(values.size());
    const Verified verified{"Stated errors", name + ": contacts whose error is within two stated `sd`",
                            "boundary elements"};
    EXPECT_TRUE(verified.above(within, 0.9 * static_cast<double>(values.size()), unit));
    EXPECT_GT(square, 0.05) << name;
  }
}

TEST(HalfSpaceSurfaces_analytic, gap_of_a_case_is_that_between_the_surfaces_of_its_meshes) {
  CaseInput input = sphere_on_silicon(generated(0.7, 80, 1), generated(1.5, 80, 2), 20e-9, 0);
  const fem::CaseSetup setup = fem::set_up(input);
  const meshing::RoughGeometry geometry(setup.system.mesh);
  const half_space::Grid grid = half_space::square_grid(0.9 * setup.system.mesh.sizes.region_particle, 10);
  const half_space::Field gap = half_space::gap_of_case(input, grid);
  const auto logical = [&](int tree, double x, double y) {  // of a place on a body's surface, by bisection
    const auto coordinate = [&](int axis, double place) {
      double low = 0, high = 1;
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        meshing::Point3 p{0.5, 0.5, meshing::BodyMap::surface_coordinate(tree)};
        p[axis] = middle;
        (geometry.position(tree, p)[axis] < place ? low : high) = middle;
      }
      return 0.5 * (low + high);
    };
    return meshing::Point3{coordinate(0, x), coordinate(1, y), meshing::BodyMap::surface_coordinate(tree)};
  };
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const double x = grid.x(i), y = grid.y(j);
      const double upper = geometry.position(meshing::cap, logical(meshing::cap, x, y))[2],
                   lower = geometry.position(meshing::block, logical(meshing::block, x, y))[2];
      EXPECT_NEAR(gap[j * grid.nx + i], upper - lower, 1e-14) << x << " " << y;
    }
}

TEST(HalfSpaceCheck_other_code, finite_elements_and_half_spaces_agree_on_a_contact_of_two_rough_bodies) {
  const TemporaryFolder folder;
  CaseInput input = input_of({1.5, 300, 150, 2, 60, 25});
  input.particle.topography = "generated(rms=0.7 nm, hurst=0.8, rolloff=300 nm, cutoff=150 nm, seed=1)";
  const auto result = solve_experiment(input, folder.path).result;
  ASSERT_TRUE(result.contains("half_space"));
  const auto verified = [](const std::string& what) {
    return Verified{"Half-space",
                    "both bodies rough, six nodes over the shortest wave, two cells a node: " + what,
                    "finite elements of the same case"};
  };
  const auto both = [&](const char* name) {
    return std::pair<double, double>(result["half_space"][name], result["effective"][name]["value"]);
  };
  for (const auto& [name, what, asked] : {std::tuple{"contact_area", "contact area", 0.03},
                                          {"approach", "approach of the mean surfaces", 0.02},
                                          {"normal_stiffness", "stiffness", 0.02},
                                          {"lateral_stiffness", "lateral stiffness", 0.03},
                                          {"torsion_stiffness", "torsion stiffness", 0.05},
                                          {"max_pressure", "largest pressure", 0.1}}) {
    const auto [half_spaces, elements] = both(name);
    EXPECT_TRUE(verified(what).within(half_spaces, elements, asked));
  }
}

TEST(HalfSpaceCheck_other_code,
     finite_elements_and_half_spaces_agree_on_rough_bodies_that_attract_each_other) {
  const TemporaryFolder folder;
  CaseInput input = input_of({1.5, 500, 150, 2, 60, 25});
  input.experiment.control = ExperimentInput::Control::displacement;
  input.experiment.normal_load = 0;
  input.experiment.normal_approach = 2e-9;
  input.experiment.unload = true;
  input.experiment.unload_steps = 16;
  input.experiment.retract = 3e-9;
  input.interface.adhesion_law = "exponential";
  input.interface.work_of_adhesion = 0.1;
  input.interface.parameters["Adhesion range"] = 1e-9;
  const auto result = solve_experiment(input, folder.path).result;
  ASSERT_TRUE(result.contains("half_space"));
  const auto& half_spaces = result["half_space"];
  const auto& pull_off = result["effective"]["pull_off_force"];
  const auto verified = [](const std::string& what) {
    return Verified{"Half-space",
                    "rough bodies that attract each other, six nodes over the shortest wave: " + what,
                    "finite elements of the same case"};
  };
  const double tension = pull_off["value"], by_half_spaces = half_spaces["pull_off_force"];
  EXPECT_TRUE(verified("pull-off force").within(by_half_spaces, tension, 0.03));
  EXPECT_TRUE(verified("contact area under the largest force")
                  .within(half_spaces["contact_area"].get<double>(),
                          result["effective"]["contact_area"]["value"].get<double>(), 0.05));
  // What the mesh is off by is what both differ by, and 2 % of smooth contacts.
  EXPECT_NEAR(pull_off["sd"].get<double>() / tension, std::hypot(0.02, by_half_spaces / tension - 1), 1e-3);
}

TEST(StatedErrors_other_code, nine_of_ten_rough_elastic_contacts_are_within_two_sd) {
  expect_coverage({{0, 0, 0, 0, 100, 30},
                   {1.5, 300, 150, 1, 60, 37},
                   {0.7, 300, 150, 2, 60, 37},
                   {1.5, 200, 100, 3, 40, 25},
                   {2.7, 300, 150, 4, 60, 25}},
                  16);
}

TEST(StatedErrorsNightly_other_code, nine_of_ten_rough_elastic_contacts_are_within_two_sd) {
  std::vector<RoughCase> cases;
  for (const double spacing : {40.0, 20.0, 10.0}) cases.push_back({0, 0, 0, 0, 100, spacing});
  for (const int seed : {1, 2, 3})
    for (const double rms : {0.7, 1.5, 2.7})
      for (const double cells : {2.5, 4.0, 8.0}) cases.push_back({rms, 200, 80, seed, 100, 80 / cells});
  // With two cells facets miss a quarter of the slopes: such a case is refused.
  for (const double cells : {2.5, 4.0}) cases.push_back({1.5, 200, 40, 1, 50, 40 / cells});
  expect_coverage(cases, 24);
}

/// Energy that bonds take per angle, 2 w a R on the width of Hertz' contact where nothing attracts on
/// approach (Kendall 1975), on loads and spacings that the constant was not found from.
TEST(StatedErrorsNightly_analytic, bonds_that_break_as_a_sphere_rolls_are_within_two_sd) {
  constexpr double nm = 1e-9, uN = 1e-6, work = 0.05;
  struct Rolled {
    double load, spacing, range;
  };
  int within = 0;
  double largest = 0;
  const std::vector<Rolled> all{{40, 24, 0.5}, {70, 24, 0.5}, {170, 24, 0.5}, {110, 20, 0.4}, {220, 28, 0.6}};
  for (const Rolled& one : all) {
    const TemporaryFolder folder;
    CaseInput c = sphere_on_silicon("smooth", "smooth", one.spacing * nm, 0);
    c.experiment.type = Motion::rolling;
    c.experiment.normal_load = one.load * uN;
    c.experiment.load_steps = 4;
    c.experiment.unload = c.experiment.reverse = false;
    c.interface.parameters["Friction coefficient"] = 0.25;
    c.interface.parameters["Adhesion range"] = one.range * nm;
    c.interface.work_of_separation = work;
    const auto lost = solve_experiment(c, folder.path).result["effective"]["rolling_dissipation"];
    const double expected = 2 * work * hertz_of(c).contact_radius(c.experiment.normal_load) * c.radius,
                 apart = (lost["value"].get<double>() - expected) / lost["sd"].get<double>();
    std::printf("%g uN on %g nm: %+.1f %%, %+.2f sd\n", one.load, one.spacing,
                100 * (lost["value"].get<double>() / expected - 1), apart);
    within += std::abs(apart) < 2 ? 1 : 0;
    largest = std::max(largest, std::abs(apart));
  }
  EXPECT_GE(within + 1, static_cast<int>(all.size()));
  EXPECT_TRUE((Verified{"Stated errors", "rolling that breaks bonds, a/h 7 to 12: largest of five errors",
                        "2 w a R, Kendall (1975)"}
                   .below(largest, 2.5, "sd")));
}

}  // namespace
