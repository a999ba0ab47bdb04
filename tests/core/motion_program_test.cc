// Programs of motion as they are written in case files.
#include "core/motion_program.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace {

using namespace asperity;

TEST(MotionProgram_behaviour, parts_follow_each_other_and_motions_of_a_part_go_together) {
  const auto parts = parse_motion_program("slide 200 nm and spin 20 mrad; press 50 uN in 3 steps; roll -30 mrad in 1 step; slide across 1e-7 ;");
  ASSERT_EQ(parts.size(), 4u);
  EXPECT_DOUBLE_EQ(parts[0].slide, 200e-9);
  EXPECT_DOUBLE_EQ(parts[0].spin, 20e-3);
  EXPECT_EQ(parts[0].steps, 0);
  EXPECT_FALSE(parts[0].load);
  EXPECT_DOUBLE_EQ(*parts[1].load, 50e-6);
  EXPECT_EQ(parts[1].steps, 3);
  EXPECT_DOUBLE_EQ(parts[2].roll, -30e-3);
  EXPECT_EQ(parts[2].steps, 1);
  EXPECT_DOUBLE_EQ(parts[3].slide_across, 1e-7);
  EXPECT_TRUE(parse_motion_program("  ").empty());
}

TEST(MotionProgram_behaviour, a_length_that_is_pressed_is_an_approach_and_one_that_is_rolled_an_arc) {
  const auto parts = parse_motion_program("press 5 nm; roll 100 nm; indenter 400 nm; roll 1 mrad and slide 1 nm");
  EXPECT_DOUBLE_EQ(*parts[0].approach, 5e-9);
  EXPECT_FALSE(parts[0].load);
  EXPECT_DOUBLE_EQ(parts[1].rolled_arc, 100e-9);
  // A particle between two planes goes half as far as the one that moves.
  EXPECT_DOUBLE_EQ(parts[2].rolled_arc, 200e-9);
  EXPECT_TRUE(parts[2].rolls_freely());
  EXPECT_TRUE(parts[3].rolls());
  EXPECT_FALSE(parts[3].rolls_freely());
}

TEST(MotionProgram_behaviour, says_what_is_not_a_motion) {
  const auto message = [](const std::string& text) {
    try {
      parse_motion_program(text);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(message("slide 5 nm; rol 3 mrad").find("'rol 3 mrad' is not a motion; did you mean 'roll'?"), std::string::npos) << message("slide 5 nm; rol 3 mrad");
  EXPECT_NE(message("roll 3 N").find("neither in rad nor in m"), std::string::npos) << message("roll 3 N");
  EXPECT_NE(message("slide").find("is not a motion"), std::string::npos);
  EXPECT_NE(message("slide 3 mrad").find("3 mrad"), std::string::npos);
  EXPECT_NE(message("slide 3 nm in 0 steps").find("between 1 and 100000 steps"), std::string::npos);
  EXPECT_NE(message("slide 3 nm in 100001 steps").find("between 1 and 100000 steps"), std::string::npos);
  EXPECT_EQ(message("slide 3 nm in 100000 steps"), "");
}

}  // namespace
