#include "dem_compare/laws/adhesion_hysteresis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/error.h"
#include "dem_compare/laws/jkr.h"
#include "dem_compare/laws/maugis_dugdale.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

constexpr double modulus = 50e9, particle = 8.5e-6, work = 0.2, nm = 1e-9;

/// States at approaches that were reached one after the other.
std::vector<NormalState> led(const AdhesionHysteresisLaw& law, const std::vector<double>& approaches) {
  std::vector<NormalState> states;
  NormalState state;
  for (const double approach : approaches) states.push_back(state = law.advance(state, approach));
  return states;
}

/// From one approach to another in so many steps, without the first.
void go(std::vector<double>& path, double to, int steps) {
  const double from = path.empty() ? 0 : path.back();
  for (int i = 1; i <= steps; ++i) path.push_back(from + (to - from) * i / steps);
}

/// Maugis' own equations, solved contact by contact (maugis_dugdale.cc).
TEST(AdhesionHysteresisLaw_other_code, of_works_alike_is_maugis_law_there_and_back) {
  for (const double range : {0.5 * nm, 2 * nm, 8 * nm}) {
    const AdhesionHysteresisLaw law{modulus, particle, work, 1, range};
    const MaugisDugdale maugis{modulus, particle, work, work / range};
    EXPECT_NEAR(law.lambda(), maugis.lambda(), 1e-12 * maugis.lambda());
    EXPECT_NEAR(law.pull_off_force(), maugis.pull_off_force(), 1e-5 * maugis.pull_off_force());
    std::vector<double> path;
    go(path, 20 * nm, 40);
    go(path, -1.5 * nm, 60);
    const auto states = led(law, path);
    NormalState known;
    for (std::size_t i = 0; i < path.size(); ++i) {
      known = maugis.advance(known, path[i]);
      if (!known.touching) break;
      EXPECT_NEAR(states[i].force, known.force, 1e-5 * maugis.pull_off_force()) << path[i] << " " << range;
      EXPECT_NEAR(states[i].contact_radius, known.contact_radius, 1e-3 * nm) << path[i];
      EXPECT_NEAR(states[i].stiffness, known.stiffness, 2e-3 * modulus * known.contact_radius) << path[i];
    }
    for (const double force : {-0.9 * maugis.pull_off_force(), 0.0, 1e-4})
      EXPECT_NEAR(law.approach(force), maugis.approach(force), 1e-4 * nm) << force;
  }
}

/// A pinned contact is a flat punch: Johnson 1985, eq. (3.36).
TEST(AdhesionHysteresisLaw_analytic, of_a_short_range_unloads_as_a_flat_punch_and_pulls_off_by_jkr) {
  const AdhesionHysteresisLaw law{modulus, particle, work, 0.25, 0.005 * nm};
  const Jkr closing{modulus, particle, 0.25 * work}, opening{modulus, particle, work};
  std::vector<double> path;
  go(path, 20 * nm, 20);
  const NormalState pressed = led(law, path).back();
  EXPECT_NEAR(pressed.force / closing.advance(NormalState{}, 20 * nm).force, 1, 2e-3);
  go(path, 19.9 * nm, 1);
  const NormalState back = led(law, path).back();
  EXPECT_EQ(back.joined_radius, pressed.joined_radius);
  EXPECT_NEAR((pressed.force - back.force) / (0.1 * nm) / (2 * modulus * pressed.contact_radius), 1, 2e-3);
  EXPECT_NEAR(back.stiffness / (2 * modulus * pressed.contact_radius), 1, 2e-3);
  EXPECT_NEAR(law.pull_off_force() / (1.5 * M_PI * work * particle), 1, 1e-4);
}

/// What a closed cycle loses, whatever the range.
TEST(AdhesionHysteresisLaw_analytic, a_cycle_loses_the_difference_of_works_on_the_area_that_the_edge_sweeps) {
  constexpr double ratio = 0.4;
  for (const double range : {0.3 * nm, 3 * nm}) {
    const AdhesionHysteresisLaw law{modulus, particle, work, ratio, range};
    std::vector<double> path;
    go(path, 20 * nm, 40);
    const std::size_t begin = path.size() - 1;
    go(path, 1 * nm, 1500);
    const std::size_t farthest = path.size() - 1;
    go(path, 20 * nm, 1500);
    const auto states = led(law, path);
    double lost = 0;
    for (std::size_t i = begin + 1; i < states.size(); ++i)
      lost += 0.5 * (states[i].force + states[i - 1].force) * (path[i] - path[i - 1]);
    const double most = states[begin].joined_radius, least = states[farthest].joined_radius;
    EXPECT_LT(least, 0.9 * most) << "it peels";
    EXPECT_NEAR(states.back().joined_radius, most, 1e-3 * nm);
    EXPECT_NEAR(lost / ((1 - ratio) * work * M_PI * (most * most - least * least)), 1, 2e-3) << range;
  }
}

TEST(AdhesionHysteresisLaw_behaviour, one_long_step_is_as_many_short_ones_and_it_parts_for_good) {
  const AdhesionHysteresisLaw law{modulus, particle, work, 0.5, 2 * nm};
  for (const double to : {18 * nm, 8 * nm, 0.5 * nm}) {
    std::vector<double> path;
    go(path, 20 * nm, 20);
    const NormalState pressed = led(law, path).back();
    go(path, to, 200);
    const NormalState slowly = led(law, path).back(), at_once = law.advance(pressed, to);
    EXPECT_NEAR(at_once.force, slowly.force, 1e-4 * law.pull_off_force()) << to;
    EXPECT_NEAR(at_once.joined_radius, slowly.joined_radius, 1e-2 * nm) << to;
  }
  std::vector<double> path;
  go(path, 20 * nm, 20);
  go(path, -30 * nm, 100);
  go(path, -0.1 * nm, 10);
  const NormalState parted = led(law, path).back();
  EXPECT_FALSE(parted.touching);
  EXPECT_EQ(parted.force, 0);
  EXPECT_TRUE(law.advance(parted, 0.1 * nm).touching);
}

/// Of a hundredth of a nanometre it let go as soon as it was drawn back.
TEST(AdhesionHysteresisLaw_behaviour, of_any_range_it_holds_down_to_no_approach) {
  for (const double range : {0.0, 1e-4 * nm, 0.01 * nm, 1 * nm, 100 * nm})
    for (const double ratio : {1e-3, 0.5, 1.0}) {
      const AdhesionHysteresisLaw law{modulus, particle, 5, ratio, range};
      std::vector<double> path;
      go(path, 20 * nm, 5);
      const double pressed = led(law, path).back().force;
      go(path, 0.1 * nm, 30);
      for (const NormalState& state : led(law, path)) {
        EXPECT_TRUE(state.touching) << state.approach << " " << range << " " << ratio;
        EXPECT_TRUE(std::isfinite(state.stiffness)) << state.approach;
        EXPECT_LE(state.force, pressed);
      }
    }
}

TEST(AdhesionHysteresisLaw_behaviour, refuses_what_no_first_loading_carries) {
  const AdhesionHysteresisLaw law{modulus, particle, work, 0.5, 2 * nm};
  EXPECT_NE(
      test::message_of<InputError>([&] { law.approach(-0.9 * law.pull_off_force()); }).find("cannot carry -"),
      std::string::npos);
  EXPECT_NE(test::message_of<InputError>([] {
              make_law<NormalMode>("adhesion_hysteresis", {{"reduced_modulus", modulus},
                                                           {"radius", particle},
                                                           {"work_of_separation", work},
                                                           {"closing_ratio", 1.2},
                                                           {"range", 2 * nm}});
            }).find("closing_ratio of the law 'adhesion_hysteresis' is 1.2"),
            std::string::npos);
}

}  // namespace
}  // namespace asperity
