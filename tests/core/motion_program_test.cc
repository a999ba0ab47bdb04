// Programs of motion as they are written in case files.
#include "core/motion_program.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace {

using namespace asperity;

TEST(MotionProgram_behaviour, parts_follow_each_other_and_motions_of_a_part_go_together) {
  const auto parts = parse_motion_program(
      "slide 200 nm and spin 20 mrad; press 50 uN in 3 steps; roll -30 mrad in 1 step; slide across 1e-7 ;");
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
  const auto parts =
      parse_motion_program("press 5 nm; roll 100 nm; indenter 400 nm; roll 1 mrad and slide 1 nm");
  EXPECT_DOUBLE_EQ(*parts[0].approach, 5e-9);
  EXPECT_FALSE(parts[0].load);
  EXPECT_DOUBLE_EQ(parts[1].rolled_arc, 100e-9);
  // A particle between two planes goes half as far as the one that moves.
  EXPECT_DOUBLE_EQ(parts[2].rolled_arc, 200e-9);
  EXPECT_TRUE(parts[2].rolls_freely());
  EXPECT_TRUE(parts[3].rolls());
  EXPECT_FALSE(parts[3].rolls_freely());
}

TEST(MotionProgram_behaviour, parts_have_speeds_and_times) {
  const auto parts =
      parse_motion_program("slide 200 nm at 1 um/s in 4 steps; hold 3 ms; roll 1 mrad at 2 nm/s");
  EXPECT_DOUBLE_EQ(parts[0].speed, 1e-6);
  EXPECT_EQ(parts[0].steps, 4);
  EXPECT_DOUBLE_EQ(parts[1].duration, 3e-3);
  EXPECT_DOUBLE_EQ(parts[2].speed, 2e-9);
  EXPECT_DOUBLE_EQ(parts[2].roll, 1e-3);
  for (const char* wrong : {"slide 2 nm at 0 m/s", "hold 0 s", "hold -1 s", "slide 2 nm at 3 nm"})
    EXPECT_THROW(parse_motion_program(wrong), InputError) << wrong;
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
  EXPECT_NE(message("slide 5 nm; rol 3 mrad").find("'rol 3 mrad' is not a motion; did you mean 'roll'?"),
            std::string::npos)
      << message("slide 5 nm; rol 3 mrad");
  EXPECT_NE(message("roll 3 N").find("neither in rad nor in m"), std::string::npos) << message("roll 3 N");
  EXPECT_NE(message("slide").find("is not a motion"), std::string::npos);
  EXPECT_NE(message("slide 3 mrad").find("3 mrad"), std::string::npos);
  EXPECT_NE(message("slide 3 nm in 0 steps").find("between 1 and 100000 steps"), std::string::npos);
  EXPECT_NE(message("slide 3 nm in 100001 steps").find("between 1 and 100000 steps"), std::string::npos);
  EXPECT_EQ(message("slide 3 nm in 100000 steps"), "");
}

ExperimentInput experiment_with(const std::string& program) {
  ExperimentInput experiment;
  experiment.type = Motion::program;
  experiment.program = program;
  experiment.normal_load = 100e-6;
  experiment.normal_approach = 5e-9;
  return experiment;
}

TEST(MotionProgram_behaviour, presses_at_most_as_far_as_the_particle_was_pressed_first) {
  EXPECT_EQ(objection_to_program(experiment_with("press 100 uN; slide 5 nm; press 1 nN")), "");
  const std::string more = objection_to_program(experiment_with("slide 5 nm; press 101 uN"));
  EXPECT_EQ(more.rfind("Experiment/Program presses to 101 uN; give more than 0 and at most the 100 uN", 0),
            0u)
      << more;
  EXPECT_NE(objection_to_program(experiment_with("press 0 N")), "");
  EXPECT_NE(objection_to_program(experiment_with("press -3 uN")), "");
  ExperimentInput displaced = experiment_with("press 5 nm; slide 5 nm");
  displaced.control = ExperimentInput::Control::displacement;
  EXPECT_EQ(objection_to_program(displaced), "");
  displaced.program = "press 6 nm";
  EXPECT_EQ(objection_to_program(displaced).rfind(
                "Experiment/Program presses to 6 nm; give more than 0 and at most the 5 nm", 0),
            0u);
}

TEST(MotionProgram_behaviour, presses_to_what_is_controlled) {
  ExperimentInput experiment = experiment_with("press 3 nm");
  EXPECT_NE(objection_to_program(experiment).find("presses to an approach, but Control is force"),
            std::string::npos);
  experiment.control = ExperimentInput::Control::displacement;
  experiment.program = "press 3 uN";
  EXPECT_NE(objection_to_program(experiment).find("presses to a load, but Control is displacement"),
            std::string::npos);
}

TEST(MotionProgram_behaviour, belongs_to_its_type_of_experiment_and_is_moved_through_once) {
  ExperimentInput experiment = experiment_with("slide 5 nm");
  EXPECT_EQ(objection_to_program(experiment), "");
  experiment.cycles = 2;
  EXPECT_NE(objection_to_program(experiment).find("moved through once"), std::string::npos);
  experiment.type = Motion::sliding;
  EXPECT_NE(objection_to_program(experiment).find("set Type = program"), std::string::npos);
  experiment.program = "";
  EXPECT_EQ(objection_to_program(experiment), "");
  experiment.type = Motion::program;
  EXPECT_NE(objection_to_program(experiment).find("needs Experiment/Program"), std::string::npos);
}

TEST(MotionProgram_analytic, motions_named_twice_in_a_part_add_up) {
  const auto parts = parse_motion_program(
      "slide 3 nm and slide 4 nm and indenter 10 nm and roll 2 nm and spin 1 mrad and spin -3 mrad");
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_DOUBLE_EQ(parts[0].slide, 7e-9);
  EXPECT_EQ(parts[0].slide_across, 0);
  EXPECT_DOUBLE_EQ(parts[0].rolled_arc, 7e-9);
  EXPECT_DOUBLE_EQ(parts[0].spin, -2e-3);
  EXPECT_EQ(parts[0].roll, 0);
}

TEST(MotionProgram_behaviour, of_more_than_10000_characters_is_refused) {
  const std::string part = "slide 1 nm;";
  std::string text;
  while (text.size() + part.size() <= 10000) text += part;
  EXPECT_EQ(parse_motion_program(text).size(), text.size() / part.size());
  EXPECT_THROW(parse_motion_program(text + part), InputError);
}

}  // namespace
