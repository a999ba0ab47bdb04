// Surfaces that half-spaces alone have solved, beside solved cases.
#include "dem_compare/cases/half_space_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using nlohmann::json;
using test::TemporaryFolder;

/// Surfaces that half-spaces add to the pressed cases of a set.
std::vector<CaseNumber> surfaces_beside(const ParameterSet& set, const char* name) {
  std::vector<SolvedNumber> numbers;
  for (const SolvedCase& solved : set.cases) {
    const EffectiveNumber number = solved.effective(name);
    if (number.value > 0)
      numbers.push_back({&solved, solved.history.normal_force.back(), number.value, number.sd});
  }
  return by_half_spaces(numbers, name);
}

/// Two of five surfaces of each of two loads are solved; finite elements are 1.1 and 1.2 of half-spaces.
class HalfSpaceSurfaces_analytic : public testing::Test {
 protected:
  HalfSpaceSurfaces_analytic() {
    json cases = json::array();
    for (const double load : {1e-5, 2e-5})
      for (int r = 1; r <= 5; ++r) {
        const std::string name = (load < 1.5e-5 ? "10_uN-r" : "20_uN-r") + std::to_string(r);
        const double stiffness = value(load, r);
        cases.push_back({{"name", name},
                         {"values", {{"Normal load", load < 1.5e-5 ? "10 uN" : "20 uN"}}},
                         {"realisation", r},
                         {"inputs_sha256", "inputs of " + name},
                         {"half_spaces",
                          {{"normal_stiffness", {{"value", stiffness}, {"unit", "N/m"}}},
                           {"normal_force", {{"value", load}, {"unit", "N"}}},
                           {"approach", {{"value", approach(load, r)}, {"unit", "m"}}}}}});
        if (r <= 2) add_solved(name, load, (r == 1 ? 1.1 : 1.2) * stiffness);
      }
    file =
        folder.write("study/previews.json", json{{"format", "asperity-previews/1"}, {"cases", cases}}.dump());
  }
  static double value(double load, int r) { return load * 1e8 * (1 + 0.1 * r); }
  static double modulus(int r) { return 5e10 * (1 + 0.02 * r * r); }
  /// Hertz' law of a radius of 8.5 um, from where the roughness is pressed flat.
  static double approach(double load, int r) {
    return 1e-9 * r + std::cbrt(9 * load * load / (16 * 8.5e-6 * modulus(r) * modulus(r)));
  }

  void add_solved(const std::string& name, double load, double stiffness) {
    SolvedCase solved;
    solved.folder = folder.path / "study" / name;
    solved.history.normal_force = {0.5 * load, load};
    CaseResult result;
    result.experiment = "normal";
    result.effective = {{"normal_stiffness", {stiffness, 0.01 * stiffness, "N/m"}}};
    result.document["inputs_sha256"] = "inputs of " + name;
    result.interface_spacing = 1e-8;
    solved.result = result;
    set.cases.push_back(solved);
  }

  TemporaryFolder folder;
  std::filesystem::path file;
  ParameterSet set;
};

TEST_F(HalfSpaceSurfaces_analytic, stand_for_the_unsolved_times_the_ratio_of_the_solved) {
  const auto numbers = surfaces_beside(set, "normal_stiffness");
  ASSERT_EQ(numbers.size(), 6u);
  for (const auto& number : numbers) {
    const int r = std::stoi(number.realisation.substr(number.realisation.find(' ')));
    EXPECT_GE(r, 3);
    const double h1 = value(number.load, 1), h2 = value(number.load, 2),
                 ratio = (1.1 * h1 + 1.2 * h2) / (h1 + h2), mean = 0.5 * (1.1 * h1 + 1.2 * h2);
    EXPECT_NEAR(number.value / (ratio * value(number.load, r)), 1, 1e-12);
    // As much below for the other; of two surfaces Student's 13.968 for 95.45 % in place of 2.
    const double left = 13.968 / 2 * std::abs(1.1 * h1 - ratio * h1) / mean;
    EXPECT_NEAR(number.sd / number.value, std::hypot(0.01, left), 1e-4 * left);
    EXPECT_NEAR(number.shared_sd / number.value, left, 1e-4 * left);
    EXPECT_TRUE(number.by_half_spaces);
    EXPECT_EQ(number.spacing, 1e-8);
  }
  EXPECT_TRUE(surfaces_beside(set, "torsion_stiffness").empty());
}

/// Finite elements have 1.05 times the modulus of half-spaces; how far each surface's roughness gives way
/// first drops out.
TEST_F(HalfSpaceSurfaces_analytic,
       tell_the_modulus_by_their_approaches_at_the_smallest_and_the_largest_load) {
  std::vector<SolvedNumber> fitted;
  for (const int r : {1, 2}) {
    const SolvedCase& solved = set.cases[static_cast<std::size_t>(1 + r)];  // at 20 uN
    fitted.push_back({&solved, 2e-5, 1.05 * modulus(r), 0});
  }
  const auto numbers = by_half_spaces(fitted, modulus_by_half_spaces);
  ASSERT_EQ(numbers.size(), 3u);
  for (const auto& number : numbers) {
    const int r = std::stoi(number.realisation.substr(number.realisation.find(' ')));
    EXPECT_NEAR(number.value / (1.05 * modulus(r)), 1, 1e-9);
    EXPECT_NEAR(number.shared_sd / number.value, 0, 1e-9);
    EXPECT_EQ(number.load, 2e-5);
  }
  // At the smallest load nothing is told.
  EXPECT_TRUE(
      by_half_spaces({{&set.cases[0], 1e-5, 1, 0}, {&set.cases[1], 1e-5, 1, 0}}, modulus_by_half_spaces)
          .empty());
}

TEST_F(HalfSpaceSurfaces_analytic, take_two_solved_surfaces_and_previews_of_the_same_inputs) {
  ParameterSet one = set;
  one.cases.erase(one.cases.begin() + 1);
  EXPECT_EQ(surfaces_beside(one, "normal_stiffness").size(), 3u);  // of the other load alone
  set.cases.front().result->document["inputs_sha256"] = "others";
  EXPECT_THROW(surfaces_beside(set, "normal_stiffness"), InputError);
  for (const char* damaged :
       {"{\"format\": \"asperity-previews/1\"}", "[1, 2]", "{\"format\": 3, \"cases\": []}",
        "{\"format\": \"asperity-previews/1\", \"cases\": [7]}",
        "{\"format\": \"asperity-previews/1\", \"cases\": [{\"name\": 4}]}", "{\"format\": "}) {
    folder.write("study/previews.json", damaged);
    EXPECT_THROW(surfaces_beside(set, "normal_stiffness"), InputError) << damaged;
  }
  std::filesystem::remove(file);
  EXPECT_TRUE(surfaces_beside(set, "normal_stiffness").empty());
}

}  // namespace
}  // namespace asperity
