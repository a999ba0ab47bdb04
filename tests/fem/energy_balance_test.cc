#include "fem/experiments/energy_balance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace asperity::fem;

/// Elastic spheres pressed together in steps along Hertz' law F = c delta^(3/2), which stores 2/5 F delta.
std::vector<HistoryRow> pressed_along_hertz(int steps) {
  constexpr double largest = 10e-9, c = 2e8;
  std::vector<HistoryRow> records(steps);
  for (int k = 0; k < steps; ++k) {
    HistoryRow& r = records[k];
    r.driven_displacement = largest * (k + 1) / steps;
    r.normal_force = c * std::pow(r.driven_displacement, 1.5);
    r.elastic_energy = 0.4 * r.normal_force * r.driven_displacement;
  }
  return records;
}

TEST(EnergyBalance_analytic, is_closed_along_Hertz_and_shows_what_is_missing) {
  auto records = pressed_along_hertz(5);
  balance_energy(records, false, 1e-6);
  const double stored = records.back().elastic_energy;
  EXPECT_NEAR(records.back().work, stored, 1e-6 * stored);
  for (const auto& r : records) EXPECT_NEAR(r.energy_error, 0, 1e-6);
  records.back().elastic_energy *= 0.9;
  balance_energy(records, false, 1e-6);
  EXPECT_NEAR(records.back().energy_error, 0.1, 1e-6);
}

TEST(EnergyBalance_analytic, counts_friction_along_both_ways_and_in_spin) {
  auto records = pressed_along_hertz(4);
  HistoryRow r = records.back();
  constexpr double force = 3e-5, across = 1e-5, moment = 2e-12;
  for (int k = 1; k <= 3; ++k) {
    r.lateral_force = force, r.lateral_force_across = across, r.torsion_moment = moment;
    r.shift = k * 5e-9, r.shift_across = k * 2e-9, r.torsion_angle = k * 1e-3;
    if (k > 1)
      r.friction_work += force * 5e-9 + across * 2e-9 + moment * 1e-3;
    else
      r.friction_work +=
          0.5 * (force * 5e-9 + across * 2e-9 + moment * 1e-3);  // the forces rise along the first step
    records.push_back(r);
  }
  balance_energy(records, false, 1e-6);
  for (const auto& at : records) EXPECT_NEAR(at.energy_error, 0, 1e-6);
}

/// A lateral force at the contact does no work on a particle whose lowest point stands still, whatever axis
/// it rolls about.
TEST(EnergyBalance_analytic, rolling_without_slip_takes_no_work_from_a_lateral_force) {
  constexpr double radius = 8e-6, force = 3e-5, angle = 0.01, heading = 0.7;
  auto records = pressed_along_hertz(4);
  const double work = [&] {
    auto copy = records;
    balance_energy(copy, false, radius);
    return copy.back().work;
  }();
  HistoryRow r = records.back();
  r.torsion_angle = heading;
  r.lateral_force = force * std::cos(heading), r.lateral_force_across = force * std::sin(heading);
  records.push_back(r);
  r.rolling_angle = angle;
  r.shift = radius * angle * std::cos(heading), r.shift_across = radius * angle * std::sin(heading);
  records.push_back(r);
  balance_energy(records, false, radius);
  EXPECT_NEAR(records.back().work, work, 1e-9 * work);

  // A moment about the contact does: by the angle, about the axis as it stands.
  records[records.size() - 2].rolling_moment = records.back().rolling_moment = 4e-12;
  balance_energy(records, false, radius);
  EXPECT_NEAR(records.back().work - work, 4e-12 * angle, 1e-9 * work);
}

TEST(EnergyBalance_analytic, of_attraction_is_not_taken_for_the_load_s) {
  // A constant attraction, there before first touch: it stores -A delta and adds to the pressure that the
  // bodies feel.
  constexpr double attraction = 5e-5;
  auto records = pressed_along_hertz(6);
  for (auto& r : records) {
    r.attraction = attraction;
    r.normal_force -= attraction;
    r.adhesion_energy = -attraction * r.driven_displacement;
  }
  balance_energy(records, true, 1e-6);
  for (const auto& r : records) EXPECT_NEAR(r.energy_error, 0, 1e-6);
}

}  // namespace
