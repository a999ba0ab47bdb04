// No number of the solver knows how large a metre or a pascal is: with all lengths L times as large and all
// moduli, strengths and pressures E times, forces are L^2 E times as large and every ratio stays (dimensional
// analysis: Buckingham 1914). What does not scale, a tolerance or a default in absolute units, shows here.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "app/case_file.h"
#include "core/atomic_file.h"
#include "tests/fem/support/solved_experiment.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;

/// A rough contact of two materials that yields, rubs and adheres, pressed and then moved as `motion` says.
std::string case_text(const std::string& motion, double L, double E) {
  const auto quantity = [](double value, const char* unit) {
    std::ostringstream text;
    text.precision(12);
    text << value << " " << unit;
    return text.str();
  };
  const auto length = [&](double nm) { return quantity(nm * L, "nm"); };
  const auto stress = [&](double GPa) { return quantity(GPa * E, "GPa"); };
  return "subsection Experiment\n set Normal load = " + quantity(95 * L * L * E, "uN") +
         "\n set Load steps = 3\n" + motion + "\n set Distance = " + length(150) +
         "\n set Motion steps = 3\nend\nsubsection Interface\n set Friction coefficient = 0.3\n set Work of "
         "adhesion = " +
         quantity(100 * L * E, "mJ/m^2") +
         "\n set Adhesion law = exponential\n set Adhesion range = " + length(20) +
         "\nend\nsubsection Particle\n set Radius = " + length(8500) +
         "\n set Young modulus = " + stress(71) +
         "\n set Poisson ratio = 0.17\n set Yield stress = " + stress(1.5) +
         "\nend\nsubsection Substrate\n set Young modulus = " + stress(179) +
         "\n set Poisson ratio = 0.25\n set Topography = generated(rms=" + length(1.2) +
         ", hurst=0.8, rolloff=" + length(400) + ", cutoff=" + length(280) +
         ", seed=3)\nend\nsubsection Mesh\n set Interface spacing = " + length(70) +
         "\n set Layers = 2\nend\nsubsection Output\n set Fields = false\nend\n";
}

nlohmann::json effective_of(const std::string& motion, double L, double E) {
  const test::TemporaryFolder folder;
  write_file_atomically(folder.path / "case.prm", case_text(motion, L, E));
  return test::solve_experiment(read_case(folder.path / "case.prm"), folder.path / "solved")
      .result["effective"];
}

/// Powers of length and stress in a unit.
const std::map<std::string, std::pair<int, int>> powers{
    {"", {0, 0}},    {"m", {1, 0}},   {"m^2", {2, 0}},     {"m^3", {3, 0}}, {"Pa", {0, 1}},
    {"N/m", {1, 1}}, {"N m", {3, 1}}, {"N m/rad", {3, 1}}, {"N", {2, 1}},   {"J", {3, 1}}};

using Scales = std::vector<std::pair<double, double>>;

void expect_similar(const std::string& name, const std::string& motion, const Scales& scales) {
  const nlohmann::json here = effective_of(motion, 1, 1);
  ASSERT_GT(here.size(), 15U);
  test::Largest off;
  for (const auto& [L, E] : scales) {
    const nlohmann::json there = effective_of(motion, L, E);
    ASSERT_EQ(here.size(), there.size());
    for (const auto& [key, number] : here.items()) {
      const auto [length, stress] = powers.at(number["unit"]);
      const double scale = std::pow(L, length) * std::pow(E, stress), value = number["value"];
      // A ratio of what round-off leaves says nothing: beside its uncertainty it has to be the same.
      const double sd = number["sd"].is_null() ? 0.0 : double(number["sd"]);
      off.count((double(there[key]["value"]) / scale - value) / std::max({std::abs(value), sd, 1e-300}));
      if (sd > 0) off.count(double(there[key]["sd"]) / scale / sd - 1);
    }
  }
  EXPECT_TRUE((test::Verified{
      "Experiment",
      "rough, yielding, adhesive, " + name + ": values and errors in other lengths and stresses",
      "dimensional analysis"}
                   .below(100 * off, 0.1, "%")));
}

TEST(Similar_analytic, a_contact_of_decimetres_and_of_polymers_has_the_same_ratios) {
  expect_similar("rolling", " set Type = rolling\n set Unload = false\n set Reverse = false", {{1e5, 1e-3}});
}

TEST(SimilarNightly_analytic, a_contact_has_the_same_ratios_in_other_lengths_and_stresses) {
  const Scales scales{{1e5, 1}, {0.1, 1e-3}};
  expect_similar("pressed", " set Type = normal\n set Unload steps = 3", scales);
  expect_similar("spinning", " set Type = torsion\n set Unload = false\n set Reverse = false", scales);
}

}  // namespace
