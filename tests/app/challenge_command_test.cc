// asperity challenge --case as a person calls it.
#include <gtest/gtest.h>

#include "tests/app/called_program.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

/// Half-spaces on one realisation of a spectrum, recorded at 0.5 % noise, against finite elements on another.
/// A case that was believed to have the recorded surface explained such recordings by an offset or a radius.
TEST(ChallengeCommand_other_code, rough_half_spaces_on_another_realisation_are_no_mismatch) {
  const test::TemporaryFolder folder;
  const auto outcome = test::call("challenge --case --seed 75000 --only 008-null-normal-roughness --output " +
                                  (folder.path / "challenge").string());
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("nulls kept clean | 100.0 % (1 of 1)"), std::string::npos) << outcome.output;
}

}  // namespace
}  // namespace asperity
