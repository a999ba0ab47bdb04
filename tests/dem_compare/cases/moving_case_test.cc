// Histories made from known powers: the resistance must come back within what it says of its own error.
#include "dem_compare/cases/moving_case.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/dem_compare/resistance/moving_folder.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using test::MovingFolder;
using test::TemporaryFolder;

MovingCase solved(const TemporaryFolder& root, const MovingFolder& made) {
  const SolvedCase read = read_solved_case(test::write_moving(root.path / "case", made));
  return moving_case(read, *mode_of(read));
}

TEST(MovingCase_analytic, powers_of_each_mechanism_come_back_without_hardening_and_hills) {
  const TemporaryFolder root;
  for (const char* type : {"sliding", "rolling", "torsion"}) {
    MovingFolder made;
    made.experiment = type;
    made.friction = 3e-6, made.plastic = 2e-6, made.adhesion = 1e-6, made.hills = 20;
    const MovingCase moving = solved(root, made);
    ASSERT_TRUE(moving.first.reached()) << type;
    EXPECT_NEAR(moving.first.dissipated.friction.value / made.friction, 1, 1e-6) << type;
    EXPECT_NEAR(moving.first.dissipated.plastic.value / made.plastic, 1, 1e-6) << type;
    EXPECT_NEAR(moving.first.dissipated.adhesion.value / made.adhesion, 1, 1e-6) << type;
    EXPECT_NEAR(moving.first.dissipated.total.value / 6e-6, 1, 1e-6) << type;
    EXPECT_LT(std::abs(moving.first.unbalanced), 1e-4 * 6e-6) << type;
    EXPECT_FALSE(moving.back.reached()) << type;
    // The force of the same way is mostly hills, waves of 20 times the resistance.
    EXPECT_NEAR(moving.first.fluctuation / (20 * 6e-6 * std::sqrt(0.5)), 1, 0.05) << type;
    EXPECT_GT(moving.first.force.sd, 100 * moving.first.dissipated.total.sd) << type;
  }
}

TEST(MovingCase_behaviour, of_rolling_back_for_less_than_two_contact_radii_is_not_called_steady) {
  const TemporaryFolder root;
  MovingFolder made;
  made.experiment = "rolling", made.adhesion = 1e-13, made.reverse = true;
  EXPECT_TRUE(solved(root, made).back.reached());
  made.way_back_in_radii = 1.7;
  const MovingCase brief = solved(root, made);
  EXPECT_TRUE(brief.first.reached());
  EXPECT_FALSE(brief.back.reached());
}

TEST(MovingCase_analytic, stated_uncertainty_holds_the_truth_19_times_in_20) {
  const TemporaryFolder root;
  constexpr int repetitions = 120;
  int resistance = 0, plastic = 0;
  for (int i = 0; i < repetitions; ++i) {
    MovingFolder made;
    made.friction = 3e-6, made.plastic = 2e-6, made.hills = 2, made.noise = 0.3,
    made.random = 100 + static_cast<unsigned>(i);
    const MovingCase moving = solved(root, made);
    resistance += std::abs(moving.first.resistance().value - 5e-6) < 2 * moving.first.resistance().sd;
    plastic +=
        std::abs(moving.first.dissipated.plastic.value - 2e-6) < 2 * moving.first.dissipated.plastic.sd;
  }
  // 120 draws of a share of 0.954 scatter by 0.019.
  constexpr double share = 0.954, three_sigma = 0.057;
  EXPECT_NEAR(resistance / double(repetitions), share, three_sigma);
  EXPECT_NEAR(plastic / double(repetitions), share, three_sigma);
}

TEST(MovingCase_analytic, an_open_balance_counts_as_a_standard_deviation) {
  const TemporaryFolder root;
  MovingFolder made;
  made.unbalanced = 1e-6;
  const MovingCase moving = solved(root, made);
  EXPECT_NEAR(moving.first.unbalanced / 1e-6, 1, 1e-6);
  EXPECT_NEAR(moving.first.resistance().sd / 1e-6, 1, 1e-6);
}

TEST(MovingCase_analytic, the_way_back_over_the_own_track_is_told_apart) {
  const TemporaryFolder root;
  MovingFolder made;
  made.friction = 1e-6, made.plastic = 2e-6, made.reverse = true, made.back = 0.25;
  const MovingCase moving = solved(root, made);
  EXPECT_NEAR(moving.first.dissipated.total.value / 3e-6, 1, 1e-6);
  ASSERT_TRUE(moving.back.reached());
  EXPECT_NEAR(moving.back.dissipated.total.value / 1.5e-6, 1, 1e-6);
}

TEST(MovingCase_analytic, rolling_is_steady_after_two_contact_radii_and_cut_into_stretches_of_one) {
  const TemporaryFolder root;
  MovingFolder made;
  made.experiment = "rolling";
  made.path_in_radii = 8;
  const MovingCase moving = solved(root, made);
  EXPECT_NEAR(moving.path_in_radii, 6.1, 0.06);  // two steps of a twentieth are the onset
  EXPECT_EQ(moving.first.blocks, 6);
}

TEST(MovingCase_analytic, without_energies_the_mean_force_stands_in) {
  const TemporaryFolder root;
  MovingFolder made;
  made.with_energies = false;
  const MovingCase moving = solved(root, made);
  ASSERT_TRUE(moving.first.reached());
  EXPECT_FALSE(std::isfinite(moving.first.dissipated.total.value));
  EXPECT_NEAR(moving.first.resistance().value / made.friction, 1, 0.01);
}

TEST(MovingCase_analytic, a_way_that_ends_at_the_onset_gives_no_resistance) {
  const TemporaryFolder root;
  MovingFolder made;
  made.path_in_radii = 0.05;
  EXPECT_FALSE(solved(root, made).first.reached());
}

}  // namespace
}  // namespace asperity
