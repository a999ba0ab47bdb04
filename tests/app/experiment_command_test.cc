// asperity experiment, laws and law-curve as a person calls them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "core/csv.h"
#include "dem_compare/laws/jkr.h"
#include "dem_compare/laws/law_registry.h"
#include "tests/app/called_program.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::call;
using test::Outcome;
using test::TemporaryFolder;

const std::string silicon_contact = std::string(ASPERITY_SOURCE_DIR) + "/runs/paper/parameters_silicon.json";

/// The law as it is written with what no record of a contact holds.
std::string written(const LawDescription& law) {
  static const std::map<std::string, std::string> values{
      {"work_of_adhesion", "50 mJ/m^2"}, {"work_of_separation", "50 mJ/m^2"},
      {"closing_ratio", "0.5"},          {"range", "1 nm"},
      {"cohesive_stress", "500 MPa"},    {"spring_stiffness", "20 kN/m"},
      {"loss_factor", "0.01"},           {"hardness", "9 GPa"},
      {"shear_modulus", "30 GPa"},       {"creep_coefficient", "4.5"},
      {"torsion_modulus", "21 GPa"},     {"yield_pressure", "9 GPa"},
      {"loading_stiffness", "20 kN/m"},  {"unloading_stiffness", "40 kN/m"}};
  std::string text = law.name;
  for (const auto& parameter : law.parameters) {
    const auto value = values.find(parameter.name);
    if (value != values.end())
      text += ", " + parameter.name + " = " + value->second;
    else if (law.mode == ViscousMode::name)
      text += ", " + parameter.name + " = 1";
  }
  return text;
}

TEST(ExperimentCommand_behaviour, every_law_is_reached_by_its_name) {
  const std::string program = "experiment " + silicon_contact + " --type rolling --json";
  for (const LawDescription& law : reduced_laws()) {
    const Outcome curve =
        call("law-curve " + silicon_contact + " --reach 1e-9 --points 3 --law '" + written(law) + "'");
    EXPECT_EQ(curve.status, 0) << law.name << ": " << curve.output;
    EXPECT_EQ(std::count(curve.output.begin(), curve.output.end(), '\n'), 5) << curve.output;
    const Outcome experiment = call(program + " --law '" + written(law) + "'");
    EXPECT_EQ(experiment.status, law.mode == SteadySlipMode::name ? 2 : 0)
        << law.name << ": " << experiment.output;
  }
}

TEST(ExperimentCommand_analytic, a_law_that_is_named_leads_the_contact) {
  const auto plateau = [](const std::string& law) {
    const Outcome outcome =
        call("experiment " + silicon_contact + " --type glued --load '100 uN' --json --law '" + law + "'");
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    return nlohmann::json::parse(outcome.output)["plateau"]["value"].get<double>();
  };
  EXPECT_NEAR(plateau("mindlin_deresiewicz, coefficient = 0.4, adhesion_force = 20 uN") / (0.4 * 120e-6), 1,
              1e-6);
  EXPECT_NEAR(
      plateau("linear_sliding, coefficient = 0.5, adhesion_force = 0, spring_stiffness = 2 kN/m") / 50e-6, 1,
      1e-6);
}

TEST(ExperimentCommand_analytic, a_curve_is_that_of_the_law) {
  const TemporaryFolder folder;
  const auto file = folder.path / "jkr.csv";
  const Outcome outcome = call("law-curve " + silicon_contact +
                               " --law 'jkr, work_of_adhesion = 50 mJ/m^2, radius = 5 um, "
                               "reduced_modulus = 60 GPa' --reach 5e-9 --points 10 --output " +
                               file.string());
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  const CsvTable table = read_csv(file);
  const auto approach = table.numbers("approach [m]"), force = table.numbers("force [N]");
  const Jkr jkr{60e9, 5e-6, 0.05};
  ASSERT_EQ(approach.size(), 11u);
  for (std::size_t i = 0; i < approach.size(); ++i)
    EXPECT_NEAR(jkr.approach(force[i]), approach[i], 1e-7 * approach.back());
}

TEST(ExperimentCommand_behaviour, two_laws_of_one_mode_and_unknown_laws_are_refused) {
  const std::string program = "experiment " + silicon_contact + " --type glued";
  const Outcome twice =
      call(program + " --law 'jkr, work_of_adhesion = 0.05' --law 'dmt, work_of_adhesion = 0.05'");
  EXPECT_EQ(twice.status, 2);
  EXPECT_EQ(twice.output, "asperity: 'jkr' and 'dmt' are both laws of normal; give one\n");
  EXPECT_EQ(call(program + " --law jkrr").output, "asperity: no reduced law 'jkrr'; did you mean 'jkr'?\n");
  EXPECT_EQ(
      call(program + " --law jkr").output,
      "asperity: the law 'jkr' needs 'work_of_adhesion' [J/m^2], w of both surfaces together; give it as in "
      "'jkr, work_of_adhesion = ...'\n");
}

}  // namespace
}  // namespace asperity
