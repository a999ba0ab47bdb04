// Steady rolling as histories tell it.
#include "fem/output/steady_motion.h"

#include <gtest/gtest.h>

namespace {

using namespace asperity::fem;

constexpr double radius = 1e-5, contact_radius = 1e-7, resistance = 3e-13;  // [m], [m], [N m]

/// Steps of a tenth of the contact radius; six of them are rolled before anything is dissipated, as after each turn.
std::vector<StepRecord> rolled(int out, int back) {
  std::vector<StepRecord> records(1);
  records.front().pressure_radius = contact_radius;
  const double step = 0.1 * contact_radius / radius;
  for (const auto& [count, direction] : {std::pair{out, 1}, std::pair{back, -1}})
    for (int i = 1; i <= count; ++i) {
      StepRecord next = records.back();
      next.rolling_angle += direction * step;
      next.rolling_moment = i > 6 ? direction * resistance : 0;
      if (i > 6) next.dissipated_energy += resistance * step;
      records.push_back(next);
    }
  return records;
}

TEST(SteadyRolling_analytic, counts_after_a_contact_radius_on_either_way) {
  for (const int back : {0, 5, 40}) {
    EXPECT_NEAR(*rolling_dissipation(rolled(50, back), radius), resistance, 1e-9 * resistance) << back;
    const auto steady = steady_rolling(rolled(50, back), radius);
    ASSERT_TRUE(steady);
    EXPECT_NEAR(steady->mean, resistance, 1e-9 * resistance);
    EXPECT_NEAR(steady->way, (41 + (back == 40 ? 31 : 0)) * 0.1 * contact_radius / radius, 1e-9);
  }
}

TEST(SteadyRolling_analytic, of_a_way_shorter_than_that_is_told_by_energy_alone) {
  EXPECT_NEAR(*rolling_dissipation(rolled(8, 0), radius), 0.25 * resistance, 1e-9 * resistance);
  EXPECT_FALSE(steady_rolling(rolled(8, 0), radius));
  EXPECT_FALSE(rolling_dissipation(rolled(0, 0), radius));
}

}  // namespace
