// What result.json says of the doubt in a single case.
#include "fem/output/result_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/atomic_file.h"
#include "tests/support/shared_files.h"

namespace asperity::fem {
namespace {

constexpr double load = 300e-6, work_of_adhesion = 0.05;

/// A circular contact of this radius at the largest load, moved in torsion at a moment that does not
/// fluctuate, then drawn off.
nlohmann::json effective_of(double spacing, double contact_radius, double left_at_pull_off = 1) {
  CaseSetup setup;
  setup.system.mesh.sizes.spacing_particle = spacing;
  setup.reduced_modulus = 53e9;
  CaseInput input;
  input.interface.work_of_adhesion = work_of_adhesion;
  input.particle.topography = input.substrate.topography = "smooth";
  HistoryRow peak;
  peak.normal_force = load;
  peak.contact_radius = peak.pressure_radius = contact_radius;
  peak.contact_area = M_PI * contact_radius * contact_radius;
  peak.contact_perimeter = 2 * M_PI * contact_radius;
  peak.mean_pressure = load / peak.contact_area;
  peak.max_pressure = 1.5 * peak.mean_pressure;
  peak.normal_displacement = 13e-9, peak.mean_plane_approach = 11e-9;
  peak.work = peak.elastic_energy = 1e-12;
  peak.spots = 3;
  std::vector<HistoryRow> records{peak};
  for (int k = 1; k < 5; ++k) {
    records.push_back(peak), records.back().torsion_angle = 1e-3 * k, records.back().torsion_moment = 2e-12;
    records.back().normal_force = load * (1 + 1e-7 * k);  // as the solver leaves it
    records.back().spots = 3 + k;
  }
  records.push_back(records.back());
  records.back().normal_force = -1e-6;
  records.back().contact_area *= left_at_pull_off * left_at_pull_off;
  records.back().contact_perimeter *= left_at_pull_off;
  ResultSummary summary;
  summary.stiffness.normal = 3e4;
  summary.stiffness.torsion = 1e-8;
  return nlohmann::json::parse(result_json(input, setup, records, summary))["effective"];
}

double relative(const nlohmann::json& quantity) {
  return quantity["sd"].get<double>() / std::abs(quantity["value"].get<double>());
}

}  // namespace

TEST(ResultFile_analytic, every_effective_value_states_what_the_mesh_leaves_in_doubt) {
  const auto effective = effective_of(12e-9, 0.33e-6);
  for (const char* name : {"normal_stiffness", "torsion_stiffness", "torsion_moment", "pull_off_force",
                           "contact_radius", "contact_area", "mean_pressure", "max_pressure", "approach",
                           "first_touch", "plastic_volume", "dissipated_energy"})
    ASSERT_TRUE(effective.contains(name)) << name;
  for (const auto& [name, quantity] : effective.items()) {
    ASSERT_TRUE(quantity["sd"].is_number()) << name;
    if (quantity["value"].get<double>() == 0) continue;
    EXPECT_GT(relative(quantity), 1e-4) << name;  // a moment that does not fluctuate had 8e-20 N m
    EXPECT_LT(relative(quantity), 1) << name;
  }
}

TEST(ResultFile_analytic, numbers_of_the_contact_are_of_the_step_that_reaches_the_load_and_not_of_one_moved) {
  EXPECT_EQ(effective_of(12e-9, 0.33e-6)["spots"]["value"], 3);
}

/// Of a circle of radius a, kappa = 2 h/a (discretisation_error.h).
TEST(ResultFile_behaviour, the_error_of_pull_off_is_that_of_the_contact_which_is_left_then) {
  const auto whole = effective_of(12e-9, 0.33e-6);
  constexpr double left = 0.125, kappa = 2 * 12e-9 / (left * 0.33e-6);
  const auto pulled = effective_of(12e-9, 0.33e-6, left);
  EXPECT_EQ(pulled["contact_area"], whole["contact_area"]);
  EXPECT_NEAR(relative(pulled["pull_off_force"]), std::hypot(0.02, kappa * std::hypot(0.05, 0.05 * kappa)),
              1e-12);
  EXPECT_GT(relative(pulled["pull_off_force"]), 1.5 * relative(whole["pull_off_force"]));
}

TEST(ResultFile_behaviour, names_are_those_of_the_manual) {
  const std::string manual =
      read_file(test::reference_folder().parent_path().parent_path().parent_path() / "docs" / "result.md");
  const auto effective = effective_of(12e-9, 0.33e-6);
  for (const auto& [name, quantity] : effective.items())
    EXPECT_NE(manual.find("`" + name + "`"), std::string::npos) << name;
}

TEST(ResultFile_analytic, area_and_its_radius_and_mean_pressure_share_one_doubt) {
  const auto effective = effective_of(12e-9, 0.33e-6);
  EXPECT_NEAR(effective["contact_radius"]["value"].get<double>(), 0.33e-6, 1e-15);
  EXPECT_NEAR(relative(effective["contact_area"]) / relative(effective["contact_radius"]), 2, 1e-9);
  EXPECT_NEAR(relative(effective["contact_area"]) / relative(effective["mean_pressure"]), 1, 1e-9);
  EXPECT_NEAR(effective["approach"]["value"].get<double>(), 11e-9, 1e-15);
  EXPECT_NEAR(effective["first_touch"]["value"].get<double>(), -2e-9, 1e-15);
}

TEST(ResultFile_behaviour, the_doubt_shrinks_with_the_spacing) {
  const auto coarse = effective_of(24e-9, 0.33e-6), fine = effective_of(12e-9, 0.33e-6);
  for (const char* name : {"normal_stiffness", "contact_area", "max_pressure", "approach"})
    EXPECT_GT(relative(coarse[name]), 1.9 * relative(fine[name])) << name;
}

}  // namespace asperity::fem
