// Attraction of a short range acts in a zone at the edge of the contact: meshes that resolve it, and what is
// said of those that do not. Judged by half-spaces and by the limit of Johnson, Kendall & Roberts (1971).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.h"
#include "core/hertz.h"
#include "dem_compare/laws/jkr.h"
#include "fem/case/case_setup.h"
#include "fem/case/derived_spacing.h"
#include "fem/output/discretisation_error.h"
#include "half_space/case_contact.h"
#include "tests/fem/support/solved_experiment.h"
#include "tests/fem/support/sphere_on_silicon.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;

/// A small sphere, Dugdale's attraction, pressed under control by displacement and drawn off: lambda 1.3.
CaseInput short_attraction(double spacing) {
  CaseInput input = test::sphere_on_silicon("smooth", "smooth", spacing, 0);
  input.radius = 1e-6;
  input.interface.work_of_adhesion = input.interface.work_of_separation = 0.168;
  input.interface.adhesion_law = "dugdale", input.interface.parameters["Adhesion range"] = 0.18e-9;
  input.experiment.control = ExperimentInput::Control::displacement;
  input.experiment.normal_approach = 0.8e-9;
  input.experiment.load_steps = 4, input.experiment.unload_steps = 30, input.experiment.retract = 2e-9;
  input.mesh.layers = 2;
  input.output.fields = false;
  return input;
}

/// E* w / s^2 = E* h0^2 / w, times pi / 4.
double zone_of(const CaseInput& input) {
  const double range = input.interface.parameters.at("Adhesion range");
  return M_PI / 4 * hertz_of(input).reduced_modulus * range * range / input.interface.work_of_adhesion;
}

TEST(AttractionZone_analytic, derived_meshes_have_three_cells_over_it_and_reach_to_JKRs_radius) {
  for (const bool by_force : {true, false}) {
    CaseInput input = short_attraction(0);
    if (by_force) input.experiment.control = ExperimentInput::Control::force;
    input.experiment.normal_load = 4e-6;
    const fem::CaseSetup setup = fem::set_up_sizes(input);
    EXPECT_NEAR(setup.attraction.zone, zone_of(input), 1e-3 * zone_of(input));
    EXPECT_NEAR(setup.attraction.length, 0.18e-9, 1e-15);
    EXPECT_NEAR(setup.system.mesh.sizes.spacing_particle,
                std::min(zone_of(input) / 3, setup.hertz_radius / 12), 1e-3 * zone_of(input));
    const Jkr jkr{setup.reduced_modulus, input.radius, input.interface.work_of_adhesion};
    const double a =
        by_force ? jkr.radius_at_force(input.experiment.normal_load) : jkr.radius_at_approach(0.8e-9);
    EXPECT_GT(setup.system.mesh.sizes.region_particle, a);
    EXPECT_LT(setup.system.mesh.sizes.region_particle, 1.5 * a);
    EXPECT_TRUE(fem::resolution_texts(setup).empty());
  }
}

TEST(AttractionZone_behaviour, is_no_matter_of_attraction_that_reaches_far_or_of_none) {
  CaseInput input = short_attraction(0);
  input.interface.parameters["Adhesion range"] = 5e-9;
  const double far = fem::set_up_sizes(input).system.mesh.sizes.spacing_particle;
  input.interface.work_of_adhesion = input.interface.work_of_separation = 0;
  const fem::CaseSetup none = fem::set_up_sizes(input);
  EXPECT_DOUBLE_EQ(far, none.system.mesh.sizes.spacing_particle);
  EXPECT_FALSE(none.attraction.acts());
  EXPECT_TRUE(std::isinf(none.attraction.zone));
}

TEST(AttractionZone_behaviour, that_no_workstation_resolves_is_refused_and_own_meshes_are_told) {
  CaseInput input = short_attraction(0);
  input.interface.parameters["Adhesion range"] = 0.02e-9;
  try {
    fem::set_up_sizes(input);
    FAIL();
  } catch (const InputError& e) {
    const std::string text = e.what();
    EXPECT_NE(text.find("zone of 98"), std::string::npos) << text;
    EXPECT_NE(text.find("times the length with the same work of adhesion"), std::string::npos) << text;
  }
  input.mesh.interface_spacing = 4e-9;
  const std::string text = fem::resolution_texts(fem::set_up_sizes(input)).at(0);
  EXPECT_NE(text.find("0.025 cells over the zone of 98.9 pm"), std::string::npos) << text;
  EXPECT_NE(text.find("pull-off force will be too large"), std::string::npos) << text;
}

TEST(AttractionZone_behaviour, the_length_that_a_refusal_names_is_one_that_is_not_refused) {
  CaseInput input = short_attraction(0);
  const double given = 0.02e-9;
  input.interface.parameters["Adhesion range"] = given;
  std::string text;
  try {
    fem::set_up_sizes(input);
  } catch (const InputError& e) {
    text = e.what();
  }
  const std::string before = "let it fall over ";
  const double times = std::stod(text.substr(text.find(before) + before.size()));
  EXPECT_GT(times, 1);
  input.interface.parameters["Adhesion range"] = 1.05 * times * given;  // said in two digits
  EXPECT_NO_THROW(fem::set_up_sizes(input));
}

/// What result.json would state without half-spaces.
double stated_without_half_spaces(const test::SolvedExperiment& solved, const fem::CaseSetup& setup) {
  const auto force = solved.history.numbers("normal_force [N]"),
             area = solved.history.numbers("contact_area [m^2]");
  const std::size_t least = std::min_element(force.begin(), force.end()) - force.begin();
  HistoryRow row;
  row.contact_area = area[least];
  row.contact_perimeter = 2 * std::sqrt(M_PI * area[least]);
  return fem::DiscretisationError(row, {setup.system.mesh.sizes.spacing_particle, setup.reduced_modulus,
                                        std::numeric_limits<double>::infinity(), setup.attraction})
      .pull_off();
}

TEST(AttractionZone_other_code, stated_errors_hold_on_meshes_that_do_not_resolve_it) {
  for (const double spacing : {0.0, 5e-9, 8e-9}) {
    const test::TemporaryFolder folder;
    const CaseInput input = short_attraction(spacing);
    const auto solved = test::solve_experiment(input, folder.path);
    const auto& pulled = solved.result["effective"]["pull_off_force"];
    const double force = pulled["value"], half_spaces = solved.result["half_space"]["pull_off_force"],
                 off = force / half_spaces - 1, share = 1 - half_spaces / force,
                 stated = stated_without_half_spaces(solved, fem::set_up_sizes(input));
    const double zones = solved.result["mesh"]["interface_spacing"].get<double>() / zone_of(input);
    std::printf("cells of %.2f zones: pull-off %.4g uN for %.4g, %+.1f %%, stated %.1f %% of it\n", zones,
                1e6 * force, 1e6 * half_spaces, 100 * off, 100 * stated);
    if (spacing == 0) {
      EXPECT_TRUE((test::Verified{"Adhesion", "pull-off on the derived mesh, attraction of a short range",
                                  "half-spaces"})
                      .within(1 + off, 1, 0.05));
    }
    const auto& area = solved.result["effective"]["contact_area"];
    const double area_off =
        solved.result["half_space"]["contact_area"].get<double>() - area["value"].get<double>();
    EXPECT_LT(std::abs(area_off), 2 * area["sd"].get<double>()) << spacing;
    EXPECT_LT(std::abs(share), 2 * stated) << spacing;
    EXPECT_GT(std::abs(share), spacing > 0 ? 0.2 * stated : 0) << spacing;
    EXPECT_NEAR(pulled["sd"].get<double>() / force, std::min(stated, std::hypot(0.02, share)), 0.02)
        << spacing;
  }
}

TEST(AttractionZone_other_code, half_spaces_state_the_stiffness_that_finite_elements_measure) {
  const test::TemporaryFolder folder;
  CaseInput input = short_attraction(0);
  input.experiment.unload = false;
  const auto result = test::solve_experiment(input, folder.path).result;
  const double stiffness = result["effective"]["normal_stiffness"]["value"];
  // A flat punch of the contact's radius (Sneddon 1965).
  const double punch =
      2 * hertz_of(input).reduced_modulus * result["effective"]["contact_radius"]["value"].get<double>();
  const auto verified = [](const std::string& what) {
    return test::Verified{"Half-space", "attraction of a short range, the edge held: " + what,
                          "finite elements of the same case"};
  };
  EXPECT_TRUE(verified("stiffness").within(result["half_space"]["normal_stiffness"], stiffness, 0.05));
  EXPECT_NEAR(stiffness, punch, 0.03 * punch);
  for (const char* pressure : {"mean_pressure", "max_pressure"})
    EXPECT_TRUE(verified(pressure).within(result["half_space"][pressure],
                                          result["effective"][pressure]["value"], 0.05));
}

}  // namespace
