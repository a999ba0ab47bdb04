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
  const auto file =
      folder.write(name + ".prm", test::smooth_case() +
                                      "subsection Substrate\n  set Topography = generated(rms=1.5 nm, "
                                      "hurst=0.8, rolloff=208 nm, cutoff=83 nm, "
                                      "seed=2)\nend\nsubsection Interface\n  set Friction coefficient = "
                                      "0.1\nend\nsubsection Mesh\n  set Interface "
                                      "spacing = 20.8 nm\n  set Layers = 2\nend\nsubsection Experiment\n  "
                                      "set Normal load = 300 uN\n  set Load "
                                      "steps = 4\n  set Unload = false\n" +
                                      experiment + "end\nsubsection Output\n  set Fields = false\nend\n");
  const auto output = folder.path / name;
  const test::Outcome outcome = test::call("solve " + file.string() + " --output " + output.string());
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  if (outcome.status != 0) return 0;
  return nlohmann::json::parse(read_file(output / "result.json"))["effective"]["normal_stiffness"]["value"];
}

/// On the large mesh of a long path, ties that were too stiff left the linear solver without an answer: 293
/// kN/m in place of 34.
TEST(MeasuredStiffnessNightly_analytic, of_a_case_that_rolls_far_is_that_of_one_that_is_pressed) {
  const test::TemporaryFolder folder;
  const double pressed = normal_stiffness(folder, "pressed", "  set Type = normal\n"),
               rolled = normal_stiffness(
                   folder, "rolled",
                   "  set Type = rolling\n  set Distance = 1.9 um\n  set Motion steps = 4\n  set "
                   "Reverse = false\n");
  EXPECT_TRUE(
      (test::Verified{"Stated errors", "normal stiffness of a case that rolls far beside one that is pressed",
                      "the same contact"}
           .within(rolled, pressed, 0.01)));
}

}  // namespace
}  // namespace asperity
