// A page of a case that moved leads with friction, moment and mechanisms.
#include "report/motion/motion_lead.h"

#include <gtest/gtest.h>

#include "tests/dem_compare/resistance/moving_folder.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

namespace asperity {
namespace {

TEST(MotionLead_analytic, of_sliding_gives_the_friction_coefficient_and_what_takes_it) {
  const test::TemporaryFolder root;
  test::MovingFolder made;
  made.friction = 12e-6, made.plastic = 6e-6, made.adhesion = 2e-6;  // at 100 uN
  const auto lead = report::motion_lead(read_solved_case(test::write_moving(root.path / "case", made)));
  ASSERT_TRUE(lead);
  EXPECT_TRUE(test::has(lead->headline, "Sliding under 100 µN takes 20")) << lead->headline;
  EXPECT_TRUE(test::has(lead->headline, "0.2")) << lead->headline;
  EXPECT_TRUE(test::has(lead->headline, "slip dissipates 60")) << lead->headline;
  EXPECT_TRUE(test::has(lead->headline, "yielding 30")) << lead->headline;
  EXPECT_TRUE(test::has(lead->headline, "form and break 10")) << lead->headline;
  ASSERT_GE(lead->tiles.size(), 5u);
  EXPECT_EQ(lead->tiles[0].label, "effective friction coefficient");
}

TEST(MotionLead_analytic, of_rolling_gives_the_moment) {
  const test::TemporaryFolder root;
  test::MovingFolder made;
  made.experiment = "rolling";
  made.friction = 0, made.plastic = 1e-13, made.adhesion = 3e-13, made.hills = 5;
  const auto lead = report::motion_lead(read_solved_case(test::write_moving(root.path / "case", made)));
  ASSERT_TRUE(lead);
  EXPECT_TRUE(test::has(lead->headline, "Rolling under 100 µN takes 0.4")) << lead->headline;
  EXPECT_TRUE(test::has(lead->headline, "pN m")) << lead->headline;
  EXPECT_TRUE(test::has(lead->headline, "yielding 25")) << lead->headline;
}

TEST(MotionLead_behaviour, of_bodies_that_relax_and_do_not_yield_says_so) {
  const test::TemporaryFolder root;
  test::MovingFolder made;
  made.experiment = "rolling";
  made.friction = 0, made.plastic = 1e-13, made.adhesion = 3e-13, made.hills = 5;
  SolvedCase solved = read_solved_case(test::write_moving(root.path / "case", made));
  auto entries = solved.entries.all();
  entries["Particle/Yield stress"] = entries["Substrate/Yield stress"] = "inf";
  entries["Particle/Relaxing share"] = "0.5";
  solved.entries = CaseEntries(entries);
  const auto lead = report::motion_lead(solved);
  ASSERT_TRUE(lead);
  EXPECT_TRUE(test::has(lead->headline, "relaxation 25")) << lead->headline;
}

TEST(MotionLead_behaviour, of_a_way_too_short_says_so_and_of_pressing_alone_is_none) {
  const test::TemporaryFolder root;
  test::MovingFolder made;
  made.path_in_radii = 0.05;
  const auto lead = report::motion_lead(read_solved_case(test::write_moving(root.path / "short", made)));
  ASSERT_TRUE(lead);
  EXPECT_TRUE(test::has(lead->headline, "Experiment/Distance must be more")) << lead->headline;
  made.experiment = "normal";
  EXPECT_FALSE(report::motion_lead(read_solved_case(test::write_moving(root.path / "normal", made))));
}

}  // namespace
}  // namespace asperity
