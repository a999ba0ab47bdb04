#include <gtest/gtest.h>

#include <cmath>

#include "core/csv.h"
#include "core/error.h"
#include "core/hertz.h"
#include "core/shear_moduli.h"
#include "dem_compare/laws/lubkin_torsion.h"
#include "dem_compare/laws/rolling_resistance.h"
#include "dem_compare/laws/torsion_resistance.h"
#include "tests/support/shared_files.h"
#include "tests/support/verification.h"

namespace asperity {
namespace {

constexpr double pi = M_PI;
constexpr double table_digits = 1e-7;  // eight significant digits, the leading one may be 1
const LubkinTorsion unit{1, 1, 1, 1};  // Gt = mu = P = a = 1: the tables' normalisation

test::Verified torsion_law(const std::string& what, const std::string& source) {
  return {"Reduced laws", what, source};
}

TEST(Lubkin_other_code, angle_and_moment_by_the_stick_radius_agree_with_the_reference) {
  const auto path = asperity::test::reference_table("04_torsion_table_lubkin.csv");
  const CsvTable table = read_csv(path);
  const auto c = table.numbers("c_over_a"), angle = table.numbers("theta*Gt*a^2/(mu*P)"),
             moment = table.numbers("M/(mu*P*a)");
  ASSERT_GE(c.size(), 10u);
  test::Largest error;
  for (std::size_t i = 0; i < c.size(); ++i) {
    error.count(unit.angle_at(c[i]) / angle[i] - 1);
    error.count(unit.moment_at(c[i]) / moment[i] - 1);
    error.count(unit.moment(angle[i]) / moment[i] - 1);
  }
  EXPECT_TRUE(
      torsion_law("Lubkin: angles and moments", "table, Lubkin (1951) solved").below(error, table_digits));
}

TEST(Lubkin_other_code, angle_at_a_moment_residual_twist_and_loop_energy_agree_with_the_reference) {
  const auto path = asperity::test::reference_table("04_torsion_table_theta_of_M.csv");
  const CsvTable virgin = read_csv(path);
  const auto m = virgin.numbers("M/(mu*P*a)"), theta = virgin.numbers("theta*Gt*a^2/(mu*P)");
  for (std::size_t i = 0; i < m.size(); ++i) EXPECT_NEAR(unit.angle(m[i]) / theta[i], 1, table_digits);

  const auto cycle_path = asperity::test::reference_table("04_torsion_table_cycle.csv");
  const CsvTable cycle = read_csv(cycle_path);
  const auto top = cycle.numbers("M*/(mu*P*a)"),
             residual = cycle.numbers("residual_theta*Gt*a^2/(mu*P)_at_M=0"),
             energy = cycle.numbers("loop_energy*Gt*a/(mu*P)^2");
  ASSERT_GE(top.size(), 5u);
  for (std::size_t i = 0; i < top.size(); ++i) {
    const double angle = unit.angle(top[i]);
    EXPECT_NEAR(unit.angle_after_reversal(0, top[i], angle) / residual[i], 1, 1e-6);
    const auto width = [&](double moment) {  // unloading minus reloading branch
      return unit.angle_after_reversal(moment, top[i], angle) +
             unit.angle_after_reversal(-moment, top[i], angle);
    };
    double sum = 0;
    constexpr int panels = 200;
    for (int k = 0; k < panels; ++k) {
      const double low = -top[i] + 2 * top[i] * k / panels, step = 2 * top[i] / panels;
      sum += step / 6 * (width(low) + 4 * width(low + step / 2) + width(low + step));
    }
    EXPECT_NEAR(sum / energy[i], 1, 1e-4);
  }
}

TEST(Lubkin_analytic, initial_stiffness_is_that_of_Reissner_and_Sagoci) {
  EXPECT_TRUE(torsion_law("Lubkin: stiffness without slip", "16/3, Reissner & Sagoci (1944)")
                  .below(1e-6 / unit.angle(1e-6) - 16.0 / 3, 1e-5, "G a^3"));
}

TEST(Lubkin_analytic, full_slip_moment_is_3_pi_over_16_mu_P_a) {
  EXPECT_NEAR(unit.moment(3) / (3 * pi / 16), 1, 1e-5);
  EXPECT_NEAR(unit.moment_at(1e-9) / (3 * pi / 16), 1, 1e-12);
  EXPECT_THROW(unit.angle(3 * pi / 16), InputError);
}

TEST(Lubkin_analytic, moment_inverts_angle_and_both_are_odd) {
  for (const double m : {0.001, 0.1, 0.4, 0.58}) {
    EXPECT_NEAR(unit.moment(unit.angle(m)) / m, 1, 1e-10);
    EXPECT_EQ(unit.angle(-m), -unit.angle(m));
  }
}

TEST(Lubkin_analytic, unloading_after_Masing_reaches_the_mirrored_state) {
  const double m = 0.4, angle = unit.angle(m);
  EXPECT_NEAR(unit.angle_after_reversal(-m, m, angle), -angle, 1e-12);
  EXPECT_NEAR(unit.moment_after_reversal(-angle, angle, m), -m, 1e-10);
}

TEST(Lubkin_analytic, a_moment_beyond_full_slip_has_no_angle_in_either_direction) {
  const double full = 3 * pi / 16;
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_THROW(unit.angle(sign * full), InputError);
    EXPECT_THROW(unit.angle(sign * 1.5 * full), InputError);
    EXPECT_EQ(unit.angle(sign * 0.999 * full) > 0, sign > 0);
    EXPECT_NEAR(unit.moment(sign * 1e6), sign * full, 1e-14);  // the stick zone is smaller than any number
    EXPECT_NEAR(unit.moment(sign * 0.3), sign * unit.moment(0.3), 1e-15);
  }
  EXPECT_EQ(unit.angle(0), 0);
  EXPECT_EQ(unit.moment(0), 0);
}

/// dM/d theta is the stiffness of a disc of the radius that sticks: with x = c/a, dM = (4/pi) mu P a x^3 dI
/// and d theta = 3 mu P/(4 pi Gt a^2) dI.
TEST(Lubkin_analytic, stiffness_is_that_of_the_disc_that_sticks) {
  for (const double x : {0.05, 0.3, 0.7, 0.99}) {
    const double h = 1e-4 * std::min(x, 1 - x);
    const double slope =
        (unit.moment_at(x + h) - unit.moment_at(x - h)) / (unit.angle_at(x + h) - unit.angle_at(x - h));
    EXPECT_NEAR(slope / (16.0 / 3 * x * x * x), 1, 1e-6) << x;
  }
}

TEST(Lubkin_analytic, angle_and_moment_scale_with_load_radius_modulus_and_friction) {
  const LubkinTorsion other{2, 0.3, 5, 0.7};
  const double angles = 0.3 * 5 / (2 * 0.7 * 0.7), moments = 0.3 * 5 * 0.7;
  EXPECT_NEAR(other.angle_at(0.4) / unit.angle_at(0.4), angles, 1e-12);
  EXPECT_NEAR(other.moment_at(0.4) / unit.moment_at(0.4), moments, 1e-12);
  EXPECT_NEAR(other.angle(0.4 * moments) / unit.angle(0.4), angles, 1e-10);
  EXPECT_NEAR(other.moment(-0.4 * angles) / unit.moment(-0.4), moments, 1e-10);
  EXPECT_NEAR(other.full_slip_moment() / unit.full_slip_moment(), moments, 1e-12);
}

TEST(Torsion_other_code, stiffness_and_full_slip_moment_agree_with_the_reference_for_all_pairs_and_loads) {
  const auto path = asperity::test::reference_table("04_torsion_table_loads.csv");
  const CsvTable table = read_csv(path);
  const auto load = table.numbers("P_uN"), mu = table.numbers("mu"), k = table.numbers("ktors_Nm_per_rad"),
             full = table.numbers("M_full_slip_Nm"), half = table.numbers("theta_at_half_M_full_rad");
  const ElasticBody sphere{71e9, 0.17}, silicon{179e9, 0.25};
  int compared = 0;
  test::Largest error;
  for (std::size_t i = 0; i < load.size(); ++i) {
    if (table.rows[i][0] != "borosilicate/Si") continue;
    const double gt = torsion_modulus(sphere, silicon);
    const double a = Hertz{reduced_modulus(sphere, silicon), 8.5e-6}.contact_radius(load[i] * 1e-6);
    error.count(no_slip_torsion_stiffness(gt, a) / k[i] - 1);
    error.count(full_slip_torsion_moment(mu[i], load[i] * 1e-6, a) / full[i] - 1);
    const LubkinTorsion lubkin{gt, mu[i], load[i] * 1e-6, a};
    error.count(lubkin.angle(lubkin.full_slip_moment() / 2) / half[i] - 1);
    ++compared;
  }
  EXPECT_TRUE(
      torsion_law("torsion of borosilicate on silicon: stiffness, full slip, angle at half of it", "table")
          .below(error, table_digits));
  EXPECT_GE(compared, 5);
}

const NormalState normal{6.1864e-9, 1e-4, 0.22931e-6, 2e4, true};
constexpr double lever = 8.5e-6;

TEST(Torsion_analytic, the_papers_stiffness_is_a_thousand_times_the_physical_one) {
  const RotationalStiffness paper{RotationalStiffness::Kind::tangential_spring, 11.7989e9},
      exact{RotationalStiffness::Kind::no_slip_torsion, 21.311e9};
  EXPECT_NEAR(paper.at(normal, lever, lever), 1.56e-6, 0.005e-6);
  EXPECT_NEAR(paper.at(normal, lever, lever) / exact.at(normal, lever, lever), 1141, 1);
}

TEST(Torsion_analytic, moment_rises_with_K_and_stops_at_mu_lambda_times_load_and_offset) {
  for (const LengthScale scale : {LengthScale::particle_radius, LengthScale::contact_radius}) {
    const double lambda = scale == LengthScale::particle_radius ? lever : normal.contact_radius;
    const TorsionLaw torsion =
        TorsionResistance{0.0056, 50e-6, scale, {RotationalStiffness::Kind::constant, 1e-9}};
    TorsionHistory history = torsion->advance({}, normal, lever, -1e-6);
    EXPECT_NEAR(history.resistance / -1e-15, 1, 1e-14);
    history = torsion->advance(history, normal, lever, -1);
    EXPECT_TRUE(history.yields);
    EXPECT_NEAR(history.resistance / (-0.0056 * lambda * 150e-6), 1, 1e-14);
  }
}

TEST(Rolling_analytic, moment_follows_the_direction_of_rolling_up_to_its_limit) {
  const RollingResistance rolling{7.9e-4,
                                  571.4e-6,
                                  LengthScale::particle_radius,
                                  {RotationalStiffness::Kind::tangential_spring, 11.7989e9}};
  const Eigen::Vector3d axis = Eigen::Vector3d(3, 4, 0) / 5;
  const RollingHistory history = RollingLaw(rolling)->advance({}, normal, lever, 0.1 * axis);
  EXPECT_LT((history.resistance - 7.9e-4 * lever * 671.4e-6 * axis).norm(),
            1e-14 * history.resistance.norm());
}

TEST(Rolling_analytic, without_a_positive_limit_there_is_no_resistance) {
  const RollingResistance rolling{
      7.9e-4, -2e-4, LengthScale::particle_radius, {RotationalStiffness::Kind::constant, 1e-9}};
  EXPECT_EQ(RollingLaw(rolling)->advance({}, normal, lever, Eigen::Vector3d::UnitX()).resistance.norm(), 0);
}

TEST(Rolling_analytic, stiffness_of_each_kind_follows_from_its_value) {
  const auto at = [](RotationalStiffness::Kind kind) {
    return RotationalStiffness{kind, 3}.at({0, 1, 2, 0, true}, 5, 7);
  };
  EXPECT_EQ(at(RotationalStiffness::Kind::constant), 3);
  EXPECT_EQ(at(RotationalStiffness::Kind::with_radius), 3 * 2);
  EXPECT_EQ(at(RotationalStiffness::Kind::tangential_spring), 8 * 3 * 2 * 5 * 7);
  EXPECT_EQ(at(RotationalStiffness::Kind::no_slip_torsion), 16.0 / 3 * 3 * 8);
}

TEST(Rolling_analytic, limit_takes_the_radius_of_the_particle_or_of_the_contact) {
  const NormalState contact{0, 4, 2, 0, true};
  RollingResistance rolling{0.5, 2, LengthScale::particle_radius, {}};
  EXPECT_EQ(rolling.limit(contact, 10), 0.5 * 10 * (4 + 2));
  rolling.length = LengthScale::contact_radius;
  EXPECT_EQ(rolling.limit(contact, 10), 0.5 * 2 * (4 + 2));
  TorsionResistance torsion{0.5, 2, LengthScale::contact_radius, {}};
  EXPECT_EQ(torsion.limit(contact, 10), 0.5 * 2 * (4 + 2));
  torsion.adhesion_force = -5;
  EXPECT_EQ(torsion.limit(contact, 10), 0);
}

TEST(Rolling_behaviour, a_contact_that_opened_forgets_its_moment) {
  const RotationalStiffness spring{RotationalStiffness::Kind::constant, 1e-9};
  const RollingResistance rolling{0.1, 0, LengthScale::particle_radius, spring};
  const TorsionResistance torsion{0.1, 0, LengthScale::particle_radius, spring};
  const NormalState open{};
  const auto rolled = RollingLaw(rolling)->advance({}, normal, lever, 1e-3 * Eigen::Vector3d::UnitY());
  const auto twisted = TorsionLaw(torsion)->advance({}, normal, lever, 1e-3);
  EXPECT_GT(rolled.resistance.norm(), 0);
  EXPECT_EQ(RollingLaw(rolling)->advance(rolled, open, lever, Eigen::Vector3d::UnitY()).resistance.norm(), 0);
  EXPECT_GT(twisted.resistance, 0);
  EXPECT_EQ(TorsionLaw(torsion)->advance(twisted, open, lever, 1).resistance, 0);
}

TEST(SpringSlider_analytic, force_is_rescaled_where_the_spring_softens_and_kept_where_it_stiffens) {
  using Slider = SpringSlider<double>;
  const Slider before{6, 3, true};
  EXPECT_EQ(Slider::advance(before, 2, 0, 100, ChangingLoad::rescale_on_unloading).resistance, 4);
  EXPECT_EQ(Slider::advance(before, 6, 0, 100, ChangingLoad::rescale_on_unloading).resistance, 6);
  EXPECT_EQ(Slider::advance(before, 2, 0, 100, ChangingLoad::plain).resistance, 6);
  EXPECT_EQ(Slider::advance(before, 2, -0.5, 100, ChangingLoad::rescale_on_unloading).resistance, 3);
  EXPECT_FALSE(Slider::advance(before, 2, 0, 100, ChangingLoad::plain).yields);
}

TEST(SpringSlider_analytic, force_stops_at_its_limit_in_the_direction_it_has) {
  using Slider = SpringSlider<double>;
  const Slider held = Slider::advance({}, 2, -3, 5, ChangingLoad::plain);
  EXPECT_EQ(held.resistance, -5);
  EXPECT_TRUE(held.yields);
  EXPECT_EQ(held.stiffness, 2);
  EXPECT_FALSE(Slider::advance({}, 2, -2.5, 5, ChangingLoad::plain).yields);  // it just bears that
  EXPECT_EQ(Slider::advance({}, 2, 1, 0, ChangingLoad::plain).resistance, 0);
  EXPECT_EQ(Slider::advance({}, 2, 1, -1, ChangingLoad::plain).resistance, 0);
}

/// Moments of a contact with partial slip that is twisted from angle to angle.
std::vector<double> moments_at(const std::vector<double>& angles) {
  const PartialSlipTorsion law{unit.torsion_modulus, unit.coefficient};
  const NormalState closed{1, unit.normal_force, unit.contact_radius, 1, true};
  TorsionHistory history;
  std::vector<double> moments;
  double at = 0;
  for (const double angle : angles) {
    history = law.advance(history, closed, 1, angle - at);
    moments.push_back(history.resistance);
    at = angle;
  }
  return moments;
}

TEST(Lubkin_analytic, in_a_contact_every_branch_follows_Masings_rule_and_closed_loops_are_forgotten) {
  const auto with_loop = moments_at({0.3, 0.8, 0.2, 0.5, -0.8, -1.2});
  EXPECT_NEAR(with_loop[1], unit.moment(0.8), 1e-12);
  EXPECT_NEAR(with_loop[2], unit.moment_after_reversal(0.2, 0.8, unit.moment(0.8)), 1e-12);
  EXPECT_NEAR(with_loop[3], with_loop[2] + 2 * unit.moment(0.3 / 2), 1e-12);
  EXPECT_NEAR(with_loop[4], -unit.moment(0.8),
              1e-12);  // the way back meets the virgin curve at the first turn's opposite
  EXPECT_NEAR(with_loop[5], -unit.moment(1.2), 1e-12);  // and goes on along it
  EXPECT_NEAR(moments_at({0.8, 0.2, 0.5, 0.1}).back(), moments_at({0.8, 0.1}).back(), 1e-12);
  EXPECT_NEAR(moments_at({0.8, 0.2, 0.5, 1.0}).back(), unit.moment(1.0), 1e-12);
}

TEST(Lubkin_analytic, a_contact_that_opens_forgets_its_twist) {
  const PartialSlipTorsion law{1, 1};
  const TorsionHistory twisted = law.advance({}, {1, 1, 1, 1, true}, 1, 0.5);
  EXPECT_GT(twisted.resistance, 0);
  EXPECT_EQ(law.advance(twisted, {}, 1, 0.5).resistance, 0);
  EXPECT_NEAR(law.limit({1, 2, 3, 1, true}, 1), 3 * pi / 16 * 2 * 3, 1e-14);
}

}  // namespace
}  // namespace asperity
