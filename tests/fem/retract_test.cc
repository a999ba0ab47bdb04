// A sphere that is pressed under displacement control and drawn back beyond first touch, with the exponential
// attraction of the shipped studies, in Derjaguin's limit: soft attraction of a long range between stiff
// bodies.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/atomic_file.h"
#include "core/csv.h"
#include "fem/solve_case.h"
#include "tests/fem/support/sphere_on_silicon.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;

CaseInput drawn_back(double opening_work) {
  CaseInput input = test::sphere_on_silicon("smooth", "smooth", 40e-9, 0);
  input.interface.work_of_adhesion = 0.02, input.interface.work_of_separation = opening_work;
  input.interface.adhesion_law = "exponential", input.interface.parameters["Adhesion range"] = 5e-9;
  input.experiment.control = ExperimentInput::Control::displacement;
  input.experiment.normal_approach = 4e-9;
  input.experiment.load_steps = 8, input.experiment.unload_steps = 16, input.experiment.retract = 8e-9;
  input.output.fields = false;
  return input;
}

CsvTable run(const CaseInput& input, const std::filesystem::path& folder) {
  SolveOptions options;
  options.output = folder;
  solve_case(input, options);
  return read_csv(folder / "history.csv");
}

/// Derjaguin (1934): spheres at distance d attract by 2 pi R times the work that is left at d.
TEST(Retract_analytic, a_sphere_apart_attracts_by_the_work_of_adhesion_that_is_left_and_no_work_is_lost) {
  const test::TemporaryFolder folder;
  const CaseInput input = drawn_back(0.02);
  const auto history = run(input, folder.path);
  const auto force = history.numbers("normal_force [N]"),
             approach = history.numbers("normal_displacement [m]"),
             area = history.numbers("contact_area [m^2]"), energy = history.numbers("energy_error"),
             work = history.numbers("work [J]");
  const double unit = 2 * M_PI * input.radius * input.interface.work_of_adhesion;
  int apart = 0;
  test::Largest attraction, open;
  for (std::size_t k = 0; k < force.size(); ++k) {
    open.count(energy[k]);
    if (area[k] > 0 || approach[k] > -0.2e-9) continue;
    const double expected = -unit * std::exp(approach[k] / input.interface.parameters.at("Adhesion range"));
    attraction.count(force[k] / expected - 1);
    ++apart;
  }
  const auto verified = [](const std::string& what, const char* source) {
    return test::Verified{"Adhesion", "pressed and drawn back, lambda 0.02: " + what, source};
  };
  EXPECT_TRUE(verified("force apart, at each step", "Derjaguin (1934)").within(1 + attraction, 1, 0.03));
  EXPECT_TRUE(verified("energy left open", "balance").below(100 * open, 1, "%"));
  EXPECT_GE(apart, 8);
  const double strongest = *std::min_element(force.begin(), force.end());
  std::printf(
      "strongest attraction %.4f of 2 pi w R, farthest %.4f of Derjaguin's, work open at most %.2g\n",
      -strongest / unit,
      -force.back() / unit / std::exp(approach.back() / input.interface.parameters.at("Adhesion range")),
      *std::max_element(energy.begin(), energy.end()));
  // DMT (1975): pulled off at 2 pi w R, where the spheres part; the last steps stand on either side of that.
  EXPECT_LT(-strongest, unit);
}

/// Work of adhesion on separation that is larger is lost over the area that was in contact, once it has
/// opened.
TEST(Retract_analytic, bonds_that_open_by_more_work_than_they_gave_lose_the_difference) {
  const test::TemporaryFolder folder;
  const auto history = run(drawn_back(0.04), folder.path);
  const auto energy = history.numbers("energy_error"), loss = history.numbers("adhesion_loss [J]"),
             area = history.numbers("contact_area [m^2]");
  test::Largest open;
  for (const double e : energy) open.count(e);
  const double largest = *std::max_element(area.begin(), area.end());
  std::printf("lost %.4f of the area times the difference, open at most %.2g\n",
              loss.back() / (0.02 * largest), *std::max_element(energy.begin(), energy.end()));
  const auto verified = [](const std::string& what, const char* source) {
    return test::Verified{"Adhesion", "drawn back with twice the opening work: " + what, source};
  };
  EXPECT_TRUE(verified("what bonds lose", "largest contact area times the difference")
                  .within(loss.back(), 0.02 * largest, 0.1));
  EXPECT_TRUE(verified("energy left open", "balance").below(100 * open, 1, "%"));
}

TEST(Retract_behaviour, what_attracts_on_separation_alone_attracts_where_it_has_touched_and_not_before) {
  const test::TemporaryFolder folder;
  CaseInput input = drawn_back(0.02);
  input.interface.work_of_adhesion = 0;
  const auto force = run(input, folder.path).numbers("normal_force [N]");
  const double unit = 2 * M_PI * input.radius * input.interface.work_of_separation;
  const auto peak = std::max_element(force.begin(), force.end());
  EXPECT_GE(*std::min_element(force.begin(), peak), 0);
  const double pulled = -*std::min_element(peak, force.end());
  // Less than the whole sphere would attract with (Derjaguin 1934).
  EXPECT_GT(pulled, 0.1 * unit);
  EXPECT_LT(pulled, unit);
}

}  // namespace
