// The time that a diagnosis gives one solution of a case.
#include "app/finite_element_model.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(FiniteElementModel_behaviour, a_solution_may_take_half_of_the_time_left_and_a_quarter_of_all) {
  constexpr double minutes = 60, all = 30 * minutes;
  EXPECT_DOUBLE_EQ(longest_solution(all, 0), 15 * minutes);
  EXPECT_DOUBLE_EQ(longest_solution(all, 10 * minutes), 10 * minutes);
  EXPECT_DOUBLE_EQ(longest_solution(all, 20 * minutes), 7.5 * minutes);
  // What is over ends all of them, whatever one may take.
  EXPECT_DOUBLE_EQ(longest_solution(all, 40 * minutes), 7.5 * minutes);
}

}  // namespace
}  // namespace asperity
