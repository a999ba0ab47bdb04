// The normal stiffness that a case states does not depend on what the case will do after it is pressed.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/atomic_file.h"
#include "tests/app/called_program.h"
#include "tests/app/smooth_case.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/verification.h"

namespace asperity {
namespace {

double normal_stiffness(const test::TemporaryFolder& folder, const std::string& name,
                        const std::string& experiment) {
  const auto file = folder.write(name + ".prm", test::smooth_case());
  const auto output = folder.path / name;
  const test::Outcome outcome = test::call(
      "solve " + file.string() + " --output " + output.string() +
      " --set 'Interface/Friction coefficient=0.1' --set 'Mesh/Interface spacing=20.8 nm' --set Mesh/Layers=2"
      " --set Output/Fields=false --set 'Experiment/Normal load=300 uN' --set 'Experiment/Load steps=4'"
      " --set Experiment/Unload=false" +
      experiment);
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  if (outcome.status != 0) return 0;
  return nlohmann::json::parse(read_file(output / "result.json"))["effective"]["normal_stiffness"]["value"];
}

/// On the large mesh of a long path, ties that were too stiff left the linear solver without an answer: 1284
/// kN/m in place of 34.5.
TEST(MeasuredStiffnessNightly_analytic, of_a_case_that_rolls_far_is_that_of_one_that_is_pressed) {
  const test::TemporaryFolder folder;
  const double pressed = normal_stiffness(folder, "pressed", " --set Experiment/Type=normal"),
               rolled = normal_stiffness(folder, "rolled",
                                         " --set Experiment/Type=rolling --set 'Experiment/Distance=1.9 um'"
                                         " --set 'Experiment/Motion steps=4' --set Experiment/Reverse=false");
  EXPECT_TRUE(
      (test::Verified{"Stated errors", "normal stiffness of a case that rolls far beside one that is pressed",
                      "the same contact"}
           .within(rolled, pressed, 0.01)));
}

}  // namespace
}  // namespace asperity
