#include "report/motion/motion_figures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "results/history.h"

namespace asperity {
namespace {

/// A sphere of 8.5 um slid with friction 0.3 under 100 uN, or spun; a history of three steps.
SolvedCase moved(const std::string& type) {
  SolvedCase solved;
  solved.entries = CaseEntries({{"Particle/Radius", "8.5 um"},
                                {"Particle/Young modulus", "71 GPa"},
                                {"Particle/Poisson ratio", "0.17"},
                                {"Substrate/Young modulus", "71 GPa"},
                                {"Substrate/Poisson ratio", "0.17"},
                                {"Interface/Friction coefficient", "0.3"},
                                {"Experiment/Type", type}});
  auto& h = solved.history;
  for (const auto& column : history_columns()) (h.*column.values).assign(3, 0.0);
  h.normal_force = {100e-6, 100e-6, 100e-6};
  if (type == "sliding") h.lateral_displacement = {0, 50e-9, 0}, h.lateral_force = {0, 30e-6, -30e-6};
  if (type == "torsion") h.torsion_angle = {0, 0.1, 0}, h.torsion_moment = {0, 4.5e-12, -4.5e-12};
  return solved;
}

TEST(MotionFigures_analytic, show_mindlins_loop_between_plus_and_minus_mu_P) {
  const auto chart = report::friction_loop_chart(moved("sliding"));
  ASSERT_EQ(chart.series.size(), 2u);
  EXPECT_NEAR(chart.series[0].x[1], 50, 1e-9);
  EXPECT_NEAR(chart.series[0].y[2], -30, 1e-9);
  const auto& law = chart.series[1];
  EXPECT_NEAR(*std::max_element(law.y.begin(), law.y.end()), 30, 1e-9);
  EXPECT_NEAR(law.y.back(), -30, 1e-9);
  EXPECT_NEAR(law.x.back(), 0, 1e-9);
  EXPECT_NE(report::motion_figure(moved("sliding")).find("Lateral force along the path"), std::string::npos);
}

TEST(MotionFigures_analytic, show_lubkins_loop_between_plus_and_minus_full_slip) {
  const auto chart = report::torsion_chart(moved("torsion"));
  ASSERT_EQ(chart.series.size(), 2u);
  const double full = 3 * M_PI / 16 * 30e-6 * 0.25928e-6 / 1e-12;  // 3 pi mu P a / 16 in pN m
  EXPECT_NEAR(chart.series[1].y[200], full, 2e-3 * full);
  EXPECT_NEAR(chart.series[1].y.back(), -full, 5e-3 * full);
  EXPECT_NE(report::motion_figure(moved("torsion")).find("Moment along the path"), std::string::npos);
}

TEST(MotionFigures_behaviour, show_forces_and_moments_of_a_program_over_its_steps) {
  SolvedCase solved = moved("program");
  solved.history.lateral_force = {0, 30e-6, 0}, solved.history.lateral_force_across = {0, 10e-6, 30e-6};
  const auto forces = report::program_forces_chart(solved);
  ASSERT_EQ(forces.series.size(), 3u);
  for (const double y : forces.series[0].y) EXPECT_NEAR(y, 100, 1e-9);
  EXPECT_NEAR(forces.series[1].y[1], 30, 1e-9);
  EXPECT_NEAR(forces.series[2].y[2], 30, 1e-9);
  EXPECT_EQ(forces.series[2].x, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(report::program_moments_chart(solved).series.size(), 2u);
  EXPECT_NE(report::motion_figure(solved).find("Program of motions"), std::string::npos);
  solved.history.lateral_force_across.clear();
  EXPECT_EQ(report::program_forces_chart(solved).series.size(), 2u) << "a history of an earlier version";
}

TEST(MotionFigures_behaviour, say_nothing_of_a_contact_that_was_only_pressed) {
  EXPECT_EQ(report::motion_figure(moved("normal")), "");
}

}  // namespace
}  // namespace asperity
