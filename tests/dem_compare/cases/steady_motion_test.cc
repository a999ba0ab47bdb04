#include "dem_compare/cases/moving_case.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/steady_motion.h"
#include "dem_compare/laws/lubkin_torsion.h"
#include "dem_compare/laws/mindlin_deresiewicz.h"

namespace asperity {
namespace {

/// There and back through a contact with partial slip, steps growing from each turn.
struct Loop {
  std::vector<double> position, resistance, load;
};

/// `virgin`: resistance of the virgin curve at a way; branches after Masing.
template <class Virgin>
Loop loop(const Virgin& virgin, double first_step, double way, double growth = 1.3) {
  Loop result;
  const auto add = [&](double x, double y) {
    result.position.push_back(x), result.resistance.push_back(y), result.load.push_back(1e-4);
  };
  add(0, 0);
  std::vector<double> ways;
  double x = 0;
  for (double step = first_step; x < way; step = std::min(step * growth, way / 40))
    ways.push_back(x = std::min(x + step, way));
  for (const double w : ways) add(w, virgin(w));
  const double turn = virgin(way);
  for (const double w : ways) add(way - w, turn - 2 * virgin(w / 2));
  return result;
}

/// Of a history that tells neither energies nor what sticks.
MovingCase steady(const Loop& data) {
  EnergyHistory history;
  history.position = data.position, history.resistance = data.resistance, history.normal_force = data.load;
  history.contact_radius = history.contact_area = std::vector<double>(data.position.size(), 1e-7);
  SolvedCase solved;
  solved.folder = "made";
  return moving_case(solved, history, {});
}

/// Mindlin & Deresiewicz: Q = mu P (1 - (1 - x/x_slip)^(3/2)), initial slope 3 mu P/(2 x_slip).
struct Sliding {
  double limit = 3e-5, stiffness = 17200;
  double slip_way() const { return 1.5 * limit / stiffness; }
  double operator()(double x) const {
    return x >= slip_way() ? limit : limit * (1 - std::pow(1 - x / slip_way(), 1.5));
  }
};

TEST(SteadyMotion_analytic, of_sliding_with_partial_slip_gives_the_limit_and_the_stiffness_without_slip) {
  const Sliding law;
  const Loop data = loop(law, law.slip_way() / 10, 60e-9);
  const MovingCase moving = steady(data);
  ASSERT_TRUE(moving.reached());
  EXPECT_NEAR(moving.resistance().value / law.limit, 1, 1e-6);
  EXPECT_LT(moving.first.fluctuation, 1e-6 * law.limit);
  EXPECT_NEAR(moving.load, 1e-4, 1e-15);
  const ReversalStiffness reversal =
      reversal_stiffness(data.position, data.resistance, moving.resistance().value, sliding_partial_slip);
  EXPECT_NEAR(reversal.value / law.stiffness, 1, 1e-6);
}

TEST(SteadyMotion_analytic, of_torsion_with_partial_slip_gives_full_slip_and_the_stiffness_without_slip) {
  const LubkinTorsion law{15e9, 0.3, 1e-4, 0.26e-6};
  const Loop data = loop([&](double angle) { return law.moment(angle); }, 1e-3, 0.08);
  const MovingCase moving = steady(data);
  ASSERT_TRUE(moving.reached());
  EXPECT_NEAR(moving.resistance().value / law.full_slip_moment(), 1,
              2e-3);  // full slip takes an infinite angle
  const ReversalStiffness reversal =
      reversal_stiffness(data.position, data.resistance, moving.resistance().value, torsion_partial_slip);
  EXPECT_NEAR(reversal.value / no_slip_torsion_stiffness(15e9, 0.26e-6), 1, 2e-3);
}

TEST(SteadyMotion_behaviour, that_never_slips_fully_has_no_steady_resistance) {
  const Sliding law;
  const Loop data = loop(law, law.slip_way() / 20, 0.5 * law.slip_way(), 1);
  EXPECT_FALSE(steady(data).reached());
  EXPECT_TRUE(
      std::isnan(reversal_stiffness(data.position, data.resistance, law.limit, sliding_partial_slip).value));
}

TEST(SteadyMotion_behaviour, legs_are_parted_at_reversals_and_rest_belongs_to_none) {
  const auto legs = motion_legs({0, 1e-12, -1e-12, 1, 2, 3, 2.5, 2.5, 1, 1.5});
  ASSERT_EQ(legs.size(), 3u);
  EXPECT_EQ(legs[0].first, 2u);
  EXPECT_EQ(legs[0].last, 5u);
  EXPECT_EQ(legs[0].direction, 1);
  EXPECT_EQ(legs[1].first, 5u);
  EXPECT_EQ(legs[1].last, 8u);
  EXPECT_EQ(legs[1].direction, -1);
  EXPECT_EQ(legs[2].last, 9u);
}

/// With little friction a contact slips radially as it is pressed (Spence 1975): no node sticks when its
/// motion begins, and the resistance still has to rise.
TEST(SteadyMotion_analytic, of_a_contact_that_never_sticks_begins_where_its_resistance_has_risen) {
  const Sliding law;
  MotionRows rows;
  constexpr double steps = 8;
  for (int i = 0; i <= 40; ++i) {
    rows.position.push_back(law.slip_way() * i / steps);
    rows.resistance.push_back(law(rows.position.back()));
    rows.sticking.push_back(0.002);
  }
  for (const double sign : {1.0, -1.0}) {
    for (double& force : rows.resistance) force *= sign;
    const SteadyRows steady = steady_rows_of_first_leg(rows);
    ASSERT_TRUE(steady.reached());
    EXPECT_GE(std::abs(rows.resistance[steady.first]), 0.985 * law.limit);
    EXPECT_LE(static_cast<double>(steady.first), steps);
    EXPECT_EQ(steady.last, 40u);
  }
  // One step beyond full slip: steady from there, whatever the hills do.
  for (std::size_t i = 1; i < rows.resistance.size(); ++i) {
    rows.position[i] = law.slip_way() * static_cast<double>(i + 2);
    rows.resistance[i] = law.limit * (1 - 0.1 * std::sin(0.7 * static_cast<double>(i)));
  }
  EXPECT_EQ(steady_rows_of_first_leg(rows).first, 1u);  // 0.936, 0.901: falls from the first row on
}

TEST(SteadyMotion_analytic, that_counts_resistance_with_the_other_sign_has_the_same_mean) {
  const Sliding law;
  Loop data = loop(law, law.slip_way() / 10, 60e-9);
  const double mean = steady(data).resistance().value;
  for (double& value : data.resistance) value = -value;
  EXPECT_DOUBLE_EQ(steady(data).resistance().value, mean);
}

TEST(SteadyMotion_behaviour, that_still_rises_is_said_to_change) {
  const Sliding law;
  const Loop data =
      loop([&](double x) { return law(x) * (1 + 0.1 * x / 60e-9); }, law.slip_way() / 10, 60e-9);
  Loop forward;
  for (std::size_t i = 0; i <= data.position.size() / 2; ++i)
    forward.position.push_back(data.position[i]), forward.resistance.push_back(data.resistance[i]),
        forward.load.push_back(1e-4);
  const SteadyPath way = steady(forward).first;
  EXPECT_TRUE(way.still_changes());
  EXPECT_NEAR(way.drift, 0.05, 0.01);
}

}  // namespace
}  // namespace asperity
