// What result.json says of the doubt in a single case.
#include "fem/output/result_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace asperity::fem {
namespace {

/// Two steps: the largest load, and what stays after it.
nlohmann::json effective_of(double spacing, double contact_radius) {
  CaseSetup setup;
  setup.system.mesh.sizes.spacing_particle = spacing;
  StepRecord peak, last;
  peak.normal_force = 300e-6;
  peak.contact_radius = contact_radius;
  peak.contact_area = M_PI * contact_radius * contact_radius;
  peak.mean_pressure = peak.normal_force / peak.contact_area;
  peak.work = peak.elastic_energy = 1e-12;
  last.normal_force = 1e-6;
  ResultSummary summary;
  summary.stiffness_at_peak = 3e4;
  return nlohmann::json::parse(result_json({}, setup, {peak, last}, summary))["effective"];
}

}  // namespace

TEST(ResultFile_analytic, the_doubt_of_a_case_is_half_a_spacing_either_way_in_the_contact_radius) {
  // Anywhere within half a spacing with equal probability: a standard deviation of h/sqrt(12).
  constexpr double spacing = 12e-9, radius = 0.33e-6;
  const double sd = spacing / std::sqrt(12.0);
  const auto effective = effective_of(spacing, radius);
  const auto relative = [&](const char* name) {
    return effective[name]["sd"].get<double>() / effective[name]["value"].get<double>();
  };
  EXPECT_NEAR(effective["contact_radius"]["sd"].get<double>(), sd, 1e-15);
  // k = 2 E* a; area and mean pressure go with a^2 and 1/a^2.
  EXPECT_NEAR(relative("normal_stiffness"), sd / radius, 1e-12);
  EXPECT_NEAR(relative("contact_area"), 2 * sd / radius, 1e-12);
  EXPECT_NEAR(relative("mean_pressure"), 2 * sd / radius, 1e-12);
}

TEST(ResultFile, the_doubt_shrinks_with_the_spacing_and_is_none_where_it_is_not_known) {
  const auto coarse = effective_of(24e-9, 0.33e-6), fine = effective_of(12e-9, 0.33e-6);
  EXPECT_NEAR(coarse["normal_stiffness"]["sd"].get<double>() / fine["normal_stiffness"]["sd"].get<double>(), 2, 1e-12);
  EXPECT_TRUE(fine["max_pressure"]["sd"].is_null());
}

}  // namespace asperity::fem
