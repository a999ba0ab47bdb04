#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/csv.h"
#include "core/shear_moduli.h"
#include "dem_compare/laws/adhesive_rolling.h"
#include "dem_compare/laws/creep_force.h"
#include "dem_compare/laws/hysteresis_rolling.h"
#include "dem_compare/laws/plastic_rolling.h"
#include "dem_compare/laws/sliding_with_spin.h"
#include "dem_compare/laws/viscous.h"
#include "tests/support/shared_files.h"

namespace asperity {
namespace {

constexpr double pi = M_PI;
constexpr double radius = 8.5e-6;
const double modulus = reduced_modulus({71e9, 0.17}, {179e9, 0.25});

TEST(HysteresisRolling_other_code, moment_agrees_with_the_reference) {
  const auto path = asperity::test::reference_table("05_rolling_table_hysteresis.csv");
  const CsvTable table = read_csv(path);
  const auto load = table.numbers("P_uN"), a = table.numbers("a_nm"),
             moment = table.numbers("M_roll_over_alpha_Nm"),
             kendall = table.numbers("Kendall_F_for_dw=1mJ/m2_nN");
  ASSERT_GT(load.size(), 10u);
  const HysteresisRolling whole{1};
  for (std::size_t i = 0; i < load.size(); ++i) {
    EXPECT_NEAR(whole.moment(load[i] * 1e-6, a[i] * 1e-9) / moment[i], 1, 1e-7);
    EXPECT_NEAR(2 * a[i] * 1e-9 * 1e-3 / (kendall[i] * 1e-9), 1, 1e-7);
  }
}

TEST(PlasticRolling_other_code, force_of_the_first_pass_agrees_with_the_reference) {
  const PlasticRolling law{9e9, radius};
  EXPECT_NEAR(law.rolling_force(1e-4) / 0.4199414515e-6, 1, 1e-9);
  EXPECT_NEAR(law.rolling_force(1e-3) / 13.27971471e-6, 1, 1e-9);
}

TEST(AdhesiveRolling_other_code, moment_and_hysteresis_force_agree_with_the_reference) {
  const auto path = asperity::test::reference_table("05_rolling_table_adhesive.csv");
  const CsvTable table = read_csv(path);
  const auto pull_off = table.numbers("pulloff_uN"), load = table.numbers("P_uN"),
             xi = table.numbers("xi_nm"), moment = table.numbers("M_DominikTielens_Nm"),
             force = table.numbers("F_Kendall_2a*0.1w_nN");
  ASSERT_GT(load.size(), 10u);
  for (std::size_t i = 0; i < load.size(); ++i) {
    const double w = pull_off[i] * 1e-6 / (1.5 * pi * radius);
    const AdhesiveRolling law{{modulus, radius, w}, xi[i] * 1e-9, 0.1 * w};
    EXPECT_NEAR(law.pinning_moment(load[i] * 1e-6) / moment[i], 1, 1e-7);
    EXPECT_NEAR(law.hysteresis_force(load[i] * 1e-6) / (force[i] * 1e-9), 1, 1e-7);
  }
}

TEST(CreepForce_other_code,
     original_and_Kalkers_cubic_law_agree_with_the_reference_and_with_the_boundary_elements) {
  const auto path = asperity::test::reference_table("05_rolling_table_creep_force.csv");
  const CsvTable table = read_csv(path);
  const auto nu = table.numbers("nu"), creep = table.numbers("G*a^2*xi/(mu*P)"),
             linear = table.numbers("Kalker_linear"), original = table.numbers("Vermeulen-Johnson_1964"),
             exact = table.numbers("own_BEM_extrapolated"),
             kalker = table.numbers("cubic_law_with_Kalker_C(Shen-Hedrick-Elkins)");
  ASSERT_GT(nu.size(), 10u);
  for (std::size_t i = 0; i < nu.size(); ++i) {
    const bool along = table.rows[i][table.column("creep")] == "longitudinal";
    CreepForce law{
        1, 1,
        along ? CreepForce::vermeulen_johnson_along(nu[i]) : CreepForce::vermeulen_johnson_across(nu[i])};
    EXPECT_NEAR(law.force(creep[i], 1, 1) / original[i], 1, 1e-4);  // five digits in the table
    law.creep_coefficient = linear[i] / creep[i];
    EXPECT_NEAR(law.force(creep[i], 1, 1) / kalker[i], 1, 1e-4);
    EXPECT_NEAR(law.force(creep[i], 1, 1) / exact[i], 1, 0.03);  // what the law claims of itself
  }
}

TEST(SlidingWithSpin_other_code, force_and_moment_agree_with_the_reference) {
  const auto path = asperity::test::reference_table("04_torsion_table_slide_spin.csv");
  const CsvTable table = read_csv(path);
  const auto eps = table.numbers("eps=v/(omega*a)"), force = table.numbers("F/(muP)_Hertz"),
             moment = table.numbers("T/(muPa)_Hertz");
  ASSERT_GT(eps.size(), 10u);
  const SlidingWithSpin law{1};
  for (std::size_t i = 0; i < eps.size(); ++i) {
    const auto limits = law.resistance(1, 1, eps[i]);
    EXPECT_NEAR(limits.force / force[i], 1, 2e-6);  // seven digits, also of eps
    EXPECT_NEAR(limits.moment / moment[i], 1, 2e-6);
  }
}

TEST(SlidingWithSpin_analytic, its_ends_are_Coulomb_and_full_slip_torsion) {
  const SlidingWithSpin law{0.3};
  const auto sliding = law.resistance(2, 5, std::numeric_limits<double>::infinity()),
             spinning = law.resistance(2, 5, 0);
  EXPECT_EQ(sliding.force, 0.3 * 2);
  EXPECT_EQ(sliding.moment, 0);
  EXPECT_EQ(spinning.force, 0);
  EXPECT_NEAR(spinning.moment, 3 * pi / 16 * 0.3 * 2 * 5, 1e-14);
  EXPECT_NEAR(law.resistance(2, 5, 5e4).force / sliding.force, 1, 1e-8);
  EXPECT_NEAR(law.resistance(2, 5, 5e-6).moment / spinning.moment, 1, 1e-8);
}

TEST(SlidingWithSpin_analytic, a_little_sliding_or_spin_meets_the_first_terms_of_the_series) {
  const SlidingWithSpin law{0.3};
  // F = mu v/(2 omega) int p/r dA = 3 pi/8 mu P eps; M = mu omega/(2 v) int p r^2 dA = mu P a/(5 eps).
  const auto slow = law.resistance(2, 5, 5e-5), fast = law.resistance(2, 5, 5e3);
  EXPECT_NEAR(slow.force / (0.3 * 2 * 3 * pi / 8 * 1e-5), 1, 1e-4);
  EXPECT_NEAR(fast.moment / (0.3 * 2 * 5 / 5e3), 1, 1e-5);
}

TEST(SlidingWithSpin_analytic, nothing_jumps_where_the_centre_of_rotation_passes_the_edge) {
  const SlidingWithSpin law{1};
  const auto inside = law.resistance(1, 1, 1 - 1e-7), at = law.resistance(1, 1, 1),
             outside = law.resistance(1, 1, 1 + 1e-7);
  for (const auto& side : {inside, outside}) {
    EXPECT_NEAR(side.force, at.force, 1e-6);
    EXPECT_NEAR(side.moment, at.moment, 1e-6);
  }
  EXPECT_LT(inside.force, outside.force);
  EXPECT_GT(inside.moment, outside.moment);
}

TEST(CreepForce_analytic, begins_with_its_linear_law_and_ends_in_full_slip) {
  const CreepForce law{2, 0.3, 4};  // y = 4 G a^2 xi/(mu P)
  const double creep_of_y = 0.3 * 5 / (4 * 2 * 0.49);
  EXPECT_NEAR(law.force(1e-9 * creep_of_y, 5, 0.7) / (1e-9 * 0.3 * 5), 1, 1e-6);
  EXPECT_NEAR(law.force(1.5 * creep_of_y, 5, 0.7) / (0.3 * 5), 1 - 0.125, 1e-14);
  EXPECT_NEAR(law.force(3 * creep_of_y, 5, 0.7) / (0.3 * 5), 1, 1e-14);
  EXPECT_NEAR(law.force(30 * creep_of_y, 5, 0.7) / (0.3 * 5), 1, 1e-14);
  EXPECT_EQ(law.force(0, 5, 0.7), 0);
  EXPECT_DOUBLE_EQ(CreepForce::vermeulen_johnson_along(0), 4);
  EXPECT_DOUBLE_EQ(CreepForce::vermeulen_johnson_along(0.5), 6.4);
  EXPECT_DOUBLE_EQ(CreepForce::vermeulen_johnson_across(0), 4);
  EXPECT_DOUBLE_EQ(CreepForce::vermeulen_johnson_across(0.5), 16 / 3.5);
}

TEST(RollingSources_analytic, have_the_values_of_their_formulas) {
  EXPECT_DOUBLE_EQ(HysteresisRolling{0.4}.moment(5, 0.7), 3.0 / 16 * 0.4 * 5 * 0.7);
  const PlasticRolling ploughing{2 / pi, 3};
  EXPECT_NEAR(ploughing.contact_radius(4), 2, 1e-14);  // P = H pi a^2/2
  EXPECT_NEAR(ploughing.rolling_force(4), 2.0 / 3 * 2 / pi * 8 / 3, 1e-14);
  const Jkr jkr{1, 1, 0.1};
  const AdhesiveRolling adhesive{jkr, 0.01, 0.02};
  EXPECT_NEAR(adhesive.pinning_moment(0) / (4 * 1.5 * pi * 0.1 * 0.01), 1, 1e-14);
  EXPECT_NEAR(adhesive.hysteresis_force(0) / (2 * std::cbrt(4.5 * pi * 0.1) * 0.02), 1,
              1e-12);  // a0^3 = 9 pi w R^2/(2 E*)
  EXPECT_DOUBLE_EQ(ViscousDamping{0.5}.factor(4, 9), 3);
}

TEST(RollingSources_analytic, limit_the_rolling_of_a_contact_by_their_moment) {
  const NormalState normal{0, 5, 0.7, 1, true};
  const RotationalStiffness stiff{RotationalStiffness::Kind::constant, 1e9};
  const AdhesiveRolling adhesive{{1, 1, 0.1}, 0.01, 0.02, stiff};
  const double lever = 3;
  const auto moment = [&](const RollingLaw& law) {
    return law->advance({}, normal, lever, Eigen::Vector3d::UnitY()).resistance.y();
  };
  const HysteresisRolling hysteresis{0.4, stiff};
  EXPECT_DOUBLE_EQ(moment(hysteresis), 3.0 / 16 * 0.4 * 5 * 0.7);
  const PlasticRolling ploughing{2 / pi, 3, stiff};
  EXPECT_DOUBLE_EQ(moment(ploughing), ploughing.rolling_force(5) * lever);
  EXPECT_DOUBLE_EQ(moment(adhesive), adhesive.pinning_moment(5) + lever * adhesive.hysteresis_force(5));
}

}  // namespace
}  // namespace asperity
