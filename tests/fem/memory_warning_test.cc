// A mesh that the machine's memory does not hold.
#include <gtest/gtest.h>

#include "core/error.h"
#include "fem/case/solve_cost.h"
#include "tests/fem/support/sphere_on_silicon.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

TEST(MemoryWarning_behaviour, refuses_what_is_far_too_large_and_says_what_is_too_large) {
  const CaseInput input = test::sphere_on_silicon("smooth", "smooth", 10e-9, 0);
  const fem::CaseSetup setup = fem::set_up_sizes(input);
  const double unknowns = 1e6, needed = fem::estimated_memory(unknowns);
  EXPECT_EQ(fem::memory_warning(input, setup, unknowns, 1.01 * needed), "");
  const std::string text = fem::memory_warning(input, setup, unknowns, 0.8 * needed);
  EXPECT_NE(text.find("0.88 GiB of memory, and 0.71 GiB are free"), std::string::npos) << text;
  EXPECT_NE(text.find("Mesh/Interface spacing = 13 nm"), std::string::npos) << text;
  const std::string message =
      test::message_of<InputError>([&] { fem::memory_warning(input, setup, unknowns, needed / 4); });
  // Half as many nodes along each side, and some room.
  EXPECT_NE(message.find("test.prm: some 1 million unknowns need"), std::string::npos) << message;
  EXPECT_NE(message.find("Mesh/Interface spacing = 23 nm"), std::string::npos) << message;
}

}  // namespace
}  // namespace asperity
