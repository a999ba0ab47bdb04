#include "core/motion.h"

#include <gtest/gtest.h>

#include <set>

namespace asperity {
namespace {

TEST(Motion_behaviour, each_has_a_name_of_its_own_and_is_found_by_it) {
  std::set<std::string> names;
  for (const Motion motion :
       {Motion::normal, Motion::sliding, Motion::rolling, Motion::torsion, Motion::rail, Motion::program}) {
    EXPECT_TRUE(names.insert(name_of(motion)).second);
    EXPECT_EQ(motion_named(name_of(motion)), motion);
  }
  EXPECT_FALSE(motion_named("slidng"));
  EXPECT_FALSE(motion_named(""));
}

}  // namespace
}  // namespace asperity
