// One entry Topography is one surface: whatever the case's load, motion, way and mesh.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "app/case_file.h"
#include "app/study.h"
#include "fem/case/case_setup.h"

namespace {

using namespace asperity;

/// The cases of a study that name a topography, by the size of the region that they mesh.
using CasesOfSurface = std::map<std::string, std::multimap<double, std::pair<CaseInput, int>>>;

CasesOfSurface rough_cases(const std::filesystem::path& file) {
  CasesOfSurface found;
  for (const auto& item : read_study(file).cases) {
    if (item.realisation > 1) continue;
    const CaseInput input = fem::with_derived_path_length(case_from_settings(item.settings, file));
    const double region =
        std::cbrt(input.experiment.normal_load) + input.experiment.distance;  // grows with what is meshed
    for (int body = 0; body < 2; ++body) {
      const TopographySpec& entry = (body == 0 ? input.particle : input.substrate).topography;
      if (!entry.is_smooth()) found[entry.text()].insert({region, {input, body}});
    }
  }
  return found;
}

double height(const fem::CaseSetup& setup, int body, double x, double y) {
  const auto& mesh = setup.system.mesh;
  return body == 0 ? mesh.particle_height(x, y) : mesh.substrate_height(x, y);
}

class ShippedStudy : public testing::TestWithParam<std::string> {};

TEST_P(ShippedStudy, has_the_same_heights_wherever_it_has_the_same_entry_analytic) {
  const auto surfaces =
      rough_cases(std::filesystem::path(ASPERITY_SOURCE_DIR) / "runs" / "paper" / GetParam());
  ASSERT_FALSE(surfaces.empty());
  for (const auto& [entry, cases] : surfaces) {
    const auto& [smallest, body] = cases.begin()->second;
    const auto& [largest, other_body] = cases.rbegin()->second;
    const fem::CaseSetup one = fem::set_up(smallest), other = fem::set_up(largest);
    const double half =
        0.5 * std::min(one.system.mesh.sizes.region_particle, other.system.mesh.sizes.region_particle);
    double product = 0, square = 0, other_square = 0;
    for (int i = -10; i <= 10; ++i)
      for (int j = -10; j <= 10; ++j) {
        const double h = height(one, body, i * half / 10, j * half / 10),
                     g = height(other, other_body, i * half / 10, j * half / 10);
        product += h * g, square += h * h, other_square += g * g;
      }
    EXPECT_NEAR(product / std::sqrt(square * other_square), 1, 1e-12) << entry;
    EXPECT_NEAR(square / other_square, 1, 1e-12) << entry;
  }
}

INSTANTIATE_TEST_SUITE_P(Runs, ShippedStudy,
                         testing::Values("surfaces.prm", "motions.prm", "rails.prm", "rolling_loads.prm"),
                         [](const auto& info) { return info.param.substr(0, info.param.find('.')); });

}  // namespace
