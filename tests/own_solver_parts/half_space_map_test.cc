// The pressure that half-spaces find beside a solved case: written with its fields and drawn in its report.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

#include "core/atomic_file.h"
#include "report/fields/field_files.h"
#include "report/report.h"
#include "results/solved_case.h"
#include "tests/fem/support/solved_experiment.h"
#include "tests/fem/support/sphere_on_silicon.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

TEST(HalfSpaceMap_analytic, bears_the_load_as_the_elements_do_and_stands_beside_them_in_the_report) {
  CaseInput input = test::sphere_on_silicon("smooth", test::generated(1, 200, 3), 30e-9, 0);
  input.experiment.load_steps = 1;
  input.experiment.unload = false;
  const test::TemporaryFolder folder;
  const std::filesystem::path output = folder.path / "solved";
  test::solve_experiment(input, output);
  constexpr double half_width = 400e-9;
  constexpr int pixels = 400;
  const auto pressures = [&](const std::filesystem::path& file) {
    auto values = report::interface_map(file, "pressure", half_width, pixels).values;
    for (double& pressure : values) pressure = std::isfinite(pressure) ? pressure : 0;
    return values;
  };
  const auto elements = pressures(report::field_files(output / "interface.pvd").rbegin()->second.front()),
             half_spaces = pressures(output / half_space_map);
  const auto product = [](const std::vector<double>& one, const std::vector<double>& other) {
    return std::inner_product(one.begin(), one.end(), other.begin(), 0.0);
  };
  const std::vector<double> pixel_areas(elements.size(), std::pow(2 * half_width / pixels, 2));
  EXPECT_NEAR(product(half_spaces, pixel_areas), 1e-4, 1e-6);
  EXPECT_NEAR(product(elements, pixel_areas), 1e-4, 2e-6);
  // The same spots in the same places; x and y, or left and right, exchanged, they are others.
  const auto alike = [&](const std::vector<double>& other) {
    return product(elements, other) / std::sqrt(product(elements, elements) * product(other, other));
  };
  std::vector<double> exchanged, mirrored(half_spaces.rbegin(), half_spaces.rend());
  for (int iy = 0; iy < pixels; ++iy)
    for (int ix = 0; ix < pixels; ++ix)
      exchanged.push_back(half_spaces[static_cast<std::size_t>(ix) * pixels + iy]);
  EXPECT_GT(alike(half_spaces), 0.98);
  EXPECT_LT(alike(exchanged), 0.95);
  EXPECT_LT(alike(mirrored), 0.95);
  write_report(output);
  EXPECT_NE(read_file(output / "report.html").find("The same by half-spaces"), std::string::npos);
}

}  // namespace
}  // namespace asperity
