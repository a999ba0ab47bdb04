// The pressure that half-spaces find beside a solved case: written with its fields and drawn in its report.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

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
  CaseInput input = test::sphere_on_silicon("smooth", test::generated(1, 200, 3), 50e-9, 0);
  input.experiment.load_steps = 1;
  input.experiment.unload = false;
  const test::TemporaryFolder folder;
  const std::filesystem::path output = folder.path / "solved";
  test::solve_experiment(input, output);
  constexpr double half_width = 400e-9;
  constexpr int pixels = 400;
  const auto force = [&](const std::filesystem::path& file) {
    const report::Map map = report::interface_map(file, "pressure", half_width, pixels);
    double sum = 0;
    for (const double pressure : map.values)
      if (std::isfinite(pressure)) sum += pressure;
    return sum * std::pow(2 * half_width / pixels, 2);
  };
  EXPECT_NEAR(force(output / half_space_map), 1e-4, 1e-6);
  EXPECT_NEAR(force(report::field_files(output / "interface.pvd").rbegin()->second.front()), 1e-4, 2e-6);
  write_report(output);
  EXPECT_NE(read_file(output / "report.html").find("The same by half-spaces"), std::string::npos);
}

}  // namespace
}  // namespace asperity
