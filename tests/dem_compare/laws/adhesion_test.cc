#include <gtest/gtest.h>

#include <cmath>

#include "core/csv.h"
#include "core/error.h"
#include "dem_compare/laws/dmt.h"
#include "dem_compare/laws/hertz_offset.h"
#include "dem_compare/laws/jkr.h"
#include "dem_compare/laws/linear_normal.h"
#include "dem_compare/laws/maugis_branch.h"
#include "dem_compare/laws/maugis_dugdale.h"
#include "tests/support/shared_files.h"
#include "tests/support/verification.h"

namespace asperity {
namespace {

constexpr double pi = M_PI;
constexpr double table_digits = 5e-7;  // seven significant digits: half a unit of the seventh, of 1
const ElasticBody borosilicate{71e9, 0.17}, silicon{179e9, 0.25};
constexpr double radius = 8.5e-6;
const double modulus = reduced_modulus(borosilicate, silicon);

Jkr jkr_with_pull_off(double force) { return {modulus, radius, force / (1.5 * pi * radius)}; }
Dmt dmt_with_pull_off(double force) { return {modulus, radius, force / (2 * pi * radius)}; }

test::Verified adhesion_law(const std::string& what, const std::string& source) {
  return {"Reduced laws", what, source};
}

TEST(Adhesion_other_code, radius_and_approach_agree_with_the_reference_for_all_loads) {
  const auto path = asperity::test::reference_table("06_adhesion_table_loads_BS_Si.csv");
  const CsvTable table = read_csv(path);
  const auto pull_off = table.numbers("pulloff_uN"), load = table.numbers("P_uN"),
             a_jkr = table.numbers("a_JKR_nm"), d_jkr = table.numbers("delta_JKR_nm"),
             a_dmt = table.numbers("a_DMT_nm"), d_dmt = table.numbers("delta_DMT_nm");
  ASSERT_GT(load.size(), 10u);
  test::Largest error;
  for (std::size_t i = 0; i < load.size(); ++i) {
    const Jkr jkr = jkr_with_pull_off(pull_off[i] * 1e-6);
    error.count(jkr.radius_at_force(load[i] * 1e-6) / (a_jkr[i] * 1e-9) - 1);
    error.count(jkr.approach(load[i] * 1e-6) / (d_jkr[i] * 1e-9) - 1);
    const Dmt dmt = dmt_with_pull_off(pull_off[i] * 1e-6);
    error.count(dmt.approach(load[i] * 1e-6) / (d_dmt[i] * 1e-9) - 1);
    error.count(dmt.advance({}, dmt.approach(load[i] * 1e-6)).contact_radius / (a_dmt[i] * 1e-9) - 1);
  }
  EXPECT_TRUE(adhesion_law("JKR and DMT: radius and approach", "table").below(error, table_digits));
}

TEST(Jkr_analytic, pull_off_is_three_halves_pi_w_R_under_a_dead_load_and_five_sixths_under_fixed_grips) {
  const Jkr jkr{modulus, radius, 0.08};
  const double unit = pi * 0.08 * radius;
  EXPECT_NEAR(jkr.force_at_radius(jkr.radius_at_force(-jkr.pull_off_force())) / unit, -1.5, 1e-12);
  EXPECT_NEAR(jkr.force_at_radius(jkr.smallest_radius()) / unit, -5.0 / 6, 1e-12);
}

TEST(Jkr_analytic, radii_at_pull_off_and_at_zero_load_are_those_of_Maugis) {
  const Jkr jkr{modulus, radius, 0.08};
  const double k = 4 * modulus / 3, length = std::cbrt(pi * 0.08 * radius * radius / k);
  EXPECT_NEAR(std::pow(jkr.radius_at_force(0) / length, 3), 6, 1e-11);
  EXPECT_NEAR(std::pow(jkr.radius_at_force(-jkr.pull_off_force()) / length, 3), 1.5, 1e-11);
  EXPECT_NEAR(std::pow(jkr.smallest_radius() / length, 3), 1.0 / 6, 1e-12);
}

TEST(Jkr_analytic, force_at_an_approach_inverts_the_approach_at_a_force) {
  const Jkr jkr{modulus, radius, 0.08};
  const NormalState touching{0, 0, 0, 0, true};
  for (const double force : {-0.99 * jkr.pull_off_force(), -1e-6, 0.0, 1e-6, 1e-4, 3e-3}) {
    const NormalState state = jkr.advance(touching, jkr.approach(force));
    EXPECT_NEAR(state.force, force, 1e-10 * std::max(std::abs(force), jkr.pull_off_force()));
  }
}

TEST(Jkr_analytic, stiffness_is_the_derivative_of_force) {
  const Jkr jkr{modulus, radius, 0.08};
  const NormalState touching{0, 0, 0, 0, true};
  for (const double approach : {-0.3e-9, 0.0, 1e-9, 10e-9}) {
    const double step = 1e-14;
    const double slope =
        (jkr.advance(touching, approach + step).force - jkr.advance(touching, approach - step).force) /
        (2 * step);
    EXPECT_NEAR(jkr.advance(touching, approach).stiffness / slope, 1, 1e-6);
  }
}

TEST(Jkr_analytic, contact_forms_at_zero_approach_and_breaks_at_a_negative_one) {
  const Jkr jkr{modulus, radius, 0.08};
  NormalState state = jkr.advance({}, 0.5 * jkr.smallest_approach());
  EXPECT_FALSE(state.touching);
  state = jkr.advance(state, 0);
  EXPECT_TRUE(state.touching);
  EXPECT_NEAR(state.force / (pi * 0.08 * radius), -4.0 / 3, 1e-12);
  state = jkr.advance(state, 0.5 * jkr.smallest_approach());
  EXPECT_TRUE(state.touching);
  state = jkr.advance(state, 1.0001 * jkr.smallest_approach());
  EXPECT_FALSE(state.touching);
  EXPECT_EQ(state.force, 0);
}

TEST(Jkr_analytic, without_adhesion_it_is_Hertz) {
  const Jkr jkr{modulus, radius, 0};
  const Hertz hertz{modulus, radius};
  const NormalState state = jkr.advance({}, 6e-9);
  EXPECT_NEAR(state.force / hertz.force(6e-9), 1, 1e-13);
  EXPECT_NEAR(state.stiffness / hertz.normal_stiffness(state.force), 1, 1e-13);
}

/// In Maugis' units: radius, force and approach of one, and the given lambda.
MaugisDugdale maugis_in_his_units(double lambda) {
  const double k = 1;
  return {0.75 * k, 1, 1 / pi, lambda / 2};
}

TEST(MaugisDugdale_other_code, pull_off_and_radii_agree_with_the_reference_from_DMTs_range_to_JKRs) {
  const auto path = asperity::test::reference_table("06_adhesion_table_maugis.csv");
  const CsvTable table = read_csv(path);
  const auto lambda = table.numbers("lambda"), pull_off = table.numbers("Ppulloff/(pi*w*R)"),
             a0 = table.numbers("a0_zero_load"), d0 = table.numbers("delta_zero_load");
  ASSERT_GE(lambda.size(), 10u);
  test::Largest error, radii;
  for (std::size_t i = 0; i < lambda.size(); ++i) {
    const MaugisDugdale law = maugis_in_his_units(lambda[i]);
    EXPECT_NEAR(law.lambda() / lambda[i], 1, 1e-14);
    error.count(-law.pull_off_force() / pull_off[i] - 1);
    error.count(law.approach(0) / d0[i] - 1);
    radii.count(law.advance({}, d0[i]).contact_radius / a0[i] - 1);
  }
  const std::string from = "table, Maugis (1992) solved";
  EXPECT_TRUE(adhesion_law("Maugis & Dugdale: pull-off, approach without load", from)
                  .below(error, 5e-6));  // six digits in the table
  EXPECT_TRUE(adhesion_law("Maugis & Dugdale: radius without load", from).below(radii, 1e-5));
}

TEST(MaugisDugdale_other_code, radius_and_approach_of_the_papers_sphere_agree_with_the_reference) {
  const auto path = asperity::test::reference_table("06_adhesion_table_loads_BS_Si.csv");
  const auto system_path = asperity::test::reference_table("06_adhesion_table_system.csv");
  const CsvTable table = read_csv(path), system = read_csv(system_path);
  const auto pull_off = table.numbers("pulloff_uN"), load = table.numbers("P_uN"),
             a = table.numbers("a_Maugis(z0=0.2nm)_nm"), delta = table.numbers("delta_Maugis_nm");
  const auto w = system.numbers("w_Maugis_selfconsistent_mJ/m2"), z0 = system.numbers("z0_nm"),
             system_pull_off = system.numbers("pulloff_uN"), lambda = system.numbers("lambda_Maugis");
  int compared = 0;
  test::Largest approaches, radii;
  for (std::size_t k = 0; k < w.size(); ++k) {
    if (system.rows[k][0] != "borosilicate/Si" || z0[k] != 0.2) continue;
    MaugisDugdale law{modulus, radius, w[k] * 1e-3, 1};
    law.cohesive_stress = lambda[k] / law.lambda();
    EXPECT_NEAR(law.pull_off_force() / (system_pull_off[k] * 1e-6), 1, 1e-5);  // six digits of w and lambda
    for (std::size_t i = 0; i < load.size(); ++i) {
      if (pull_off[i] != system_pull_off[k]) continue;
      approaches.count(law.approach(load[i] * 1e-6) / (delta[i] * 1e-9) - 1);
      radii.count(law.advance({}, delta[i] * 1e-9).contact_radius / (a[i] * 1e-9) - 1);
      ++compared;
    }
  }
  EXPECT_GE(compared, 15);
  EXPECT_TRUE(
      adhesion_law("Maugis & Dugdale, borosilicate on silicon: approach", "table").below(approaches, 2e-5));
  EXPECT_TRUE(adhesion_law("Maugis & Dugdale, borosilicate on silicon: radius", "table").below(radii, 1e-5));
}

TEST(MaugisDugdale_analytic, its_limits_are_JKR_and_DMT) {
  const MaugisDugdale sticky = maugis_in_his_units(100), stiff = maugis_in_his_units(1e-3);
  const NormalState touching{0, 0, 0, 0, true};
  EXPECT_NEAR(sticky.pull_off_force(), 1.5, 1e-3);
  EXPECT_NEAR(stiff.pull_off_force(), 2, 1e-2);
  const Jkr jkr{0.75, 1, 1 / pi};
  const Dmt dmt{0.75, 1, 1 / pi};
  for (const double force : {0.0, 2.0, 20.0}) {
    EXPECT_NEAR(sticky.advance(touching, sticky.approach(force)).contact_radius / jkr.radius_at_force(force),
                1, 1e-3);
    EXPECT_NEAR(stiff.advance(touching, stiff.approach(force)).contact_radius /
                    dmt.advance(touching, dmt.approach(force)).contact_radius,
                1, 1e-2);
  }
}

TEST(MaugisDugdale_analytic, stiffness_is_the_derivative_of_force) {
  const MaugisDugdale law{modulus, radius, 0.08, 4e8};
  const NormalState touching{0, 0, 0, 0, true};
  for (const double approach : {-0.2e-9, 0.0, 1e-9, 10e-9}) {
    const double step = 1e-14;
    const double slope =
        (law.advance(touching, approach + step).force - law.advance(touching, approach - step).force) /
        (2 * step);
    EXPECT_NEAR(law.advance(touching, approach).stiffness / slope, 1, 1e-6);
  }
}

TEST(MaugisDugdale_analytic, contact_breaks_at_a_negative_approach_and_carries_no_more_than_its_pull_off) {
  const MaugisDugdale law{modulus, radius, 0.08, 4e8};
  NormalState state = law.advance({}, 1e-9);
  double least = 0;
  for (double approach = 1e-9; state.touching; approach -= 1e-12) {
    state = law.advance(state, approach);
    least = std::min(least, state.force);
    ASSERT_GT(approach, -5e-9);
  }
  EXPECT_LT(state.approach, 0);
  EXPECT_NEAR(-least / law.pull_off_force(), 1, 1e-4);
  EXPECT_THROW(law.approach(-1.01 * law.pull_off_force()), InputError);
}

TEST(Dmt_analytic, pull_off_is_two_pi_w_R) {
  const Dmt dmt{modulus, radius, 0.06};
  EXPECT_NEAR(dmt.advance({}, 0).force / (2 * pi * 0.06 * radius), -1, 1e-13);
}

TEST(HertzOffset_analytic, attraction_shifts_the_force_and_keeps_the_radius) {
  const HertzOffset with{modulus, radius, 3.2e-6}, without{modulus, radius, 0};
  const NormalState adhesive = with.advance({}, 6e-9), plain = without.advance({}, 6e-9);
  EXPECT_NEAR(plain.force - adhesive.force, 3.2e-6, 1e-18);
  EXPECT_EQ(plain.contact_radius, adhesive.contact_radius);
  EXPECT_NEAR(with.advance({}, with.approach(1e-4)).force, 1e-4, 1e-16);
}

TEST(NormalLaw_analytic, any_law_inverts_its_force) {
  for (const NormalLaw& law :
       {NormalLaw(HertzOffset{modulus, radius, 3e-6}), NormalLaw(LinearNormal{2e4, radius, 3e-6}),
        NormalLaw(Dmt{modulus, radius, 0.06}), NormalLaw(Jkr{modulus, radius, 0.08}),
        NormalLaw(MaugisDugdale{modulus, radius, 0.08, 4e8})}) {
    EXPECT_NEAR(law->advance({}, law->approach(1e-4)).force, 1e-4, 1e-14);
    EXPECT_EQ(law->radius(), radius);
  }
}

/// u = (m^2 - 1)^(1/2) follows from radius and approach; then force and balance are checked against Maugis'
/// equations.
TEST(MaugisDugdale_analytic, states_fulfil_the_equations_of_Maugis) {
  const NormalState touching{0, 0, 0, 0, true};
  for (const double lambda : {0.01, 0.3, 1.0, 5.0, 50.0}) {
    const MaugisDugdale law = maugis_in_his_units(lambda);
    for (const double approach : {-0.1, 0.0, 0.5, 3.0, 40.0}) {
      const NormalState state = law.advance(touching, approach);
      if (!state.touching) continue;
      const double a = state.contact_radius, u = (a * a - approach) / (4.0 / 3 * lambda * a),
                   t = std::atan(u);
      const double m = std::sqrt(1 + u * u);
      const double balance =
          lambda * a * a / 2 * (u + (m * m - 2) * t) + 4 * lambda * lambda * a / 3 * (u * t - m + 1);
      EXPECT_NEAR(balance, 1, 2e-6) << lambda << " "
                                    << approach;  // u of sticky contacts is a small difference
      const double force = a * a * a - lambda * a * a * (u + m * m * t);
      EXPECT_NEAR(state.force, force, 1e-7 * (1 + std::abs(force))) << lambda << " " << approach;
    }
  }
}

TEST(MaugisDugdale_analytic, forces_radii_and_approaches_scale_with_his_units) {
  const MaugisDugdale law{modulus, radius, 0.08, 4e8};
  const MaugisDugdale his = maugis_in_his_units(law.lambda());
  const double k = 4 * modulus / 3, length = std::cbrt(pi * 0.08 * radius * radius / k),
               force = pi * 0.08 * radius;
  EXPECT_NEAR(law.lambda() / (2 * 4e8 * std::cbrt(radius / (pi * 0.08 * k * k))), 1, 1e-14);
  EXPECT_NEAR(law.pull_off_force() / (force * his.pull_off_force()), 1, 1e-12);
  EXPECT_NEAR(law.approach(3 * force) / (length * length / radius * his.approach(3)), 1, 1e-12);
  const NormalState state = law.advance({}, 2 * length * length / radius), unit = his.advance({}, 2);
  EXPECT_NEAR(state.contact_radius / (length * unit.contact_radius), 1, 1e-12);
  EXPECT_NEAR(state.force / (force * unit.force), 1, 1e-12);
  EXPECT_NEAR(state.stiffness / (force * radius / (length * length) * unit.stiffness), 1, 1e-12);
}

TEST(MaugisDugdale_behaviour, forms_at_first_touch_and_says_what_it_cannot_carry) {
  const MaugisDugdale law{modulus, radius, 0.08, 4e8};
  EXPECT_FALSE(law.advance({}, -1e-12).touching);
  EXPECT_EQ(law.advance({}, -1e-12).force, 0);
  const NormalState formed = law.advance({}, 0);
  EXPECT_TRUE(formed.touching);
  EXPECT_LT(formed.force, 0);
  EXPECT_TRUE(law.advance(formed, -1e-12).touching);
  EXPECT_NEAR(law.advance(formed, law.approach(-0.99 * law.pull_off_force())).force / law.pull_off_force(),
              -0.99, 1e-8);
  try {
    law.approach(-1e-3);
    FAIL() << "carried";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("cannot carry -1000 uN; its pull-off force is "),
              std::string::npos)
        << error.what();
  }
}

TEST(Dmt_analytic, is_Hertz_with_a_constant_attraction_while_it_touches) {
  const Dmt dmt{modulus, radius, 0.06};
  const double pull_off = 2 * pi * 0.06 * radius;
  const NormalState state = dmt.advance({}, 5e-9);
  EXPECT_NEAR(state.force, dmt.hertz().force(5e-9) - pull_off, 1e-18);
  EXPECT_NEAR(state.contact_radius / std::sqrt(radius * 5e-9), 1, 1e-14);
  EXPECT_NEAR(state.stiffness / (2 * modulus * state.contact_radius), 1, 1e-14);
  EXPECT_FALSE(dmt.advance(state, -1e-15).touching);
  EXPECT_EQ(dmt.advance(state, -1e-15).force, 0);
  EXPECT_NEAR(dmt.approach(-pull_off), 0, 1e-20);
}

TEST(HertzOffset_analytic, has_no_reach_out_of_contact) {
  const HertzOffset sticky{modulus, radius, 3e-6};
  for (const double approach : {0.0, -1e-9}) {
    EXPECT_FALSE(sticky.advance({}, approach).touching);
    EXPECT_EQ(sticky.advance({}, approach).force, 0);
  }
  const NormalState state = sticky.advance({}, 5e-9);
  EXPECT_NEAR(state.stiffness / (2 * modulus * state.contact_radius), 1, 1e-14);
}

TEST(LinearNormal_analytic, force_is_the_spring_less_the_attraction) {
  const LinearNormal linear{2e4, radius, 3e-6};
  const NormalState state = linear.advance({}, 5e-9);
  EXPECT_NEAR(state.force, 1e-4 - 3e-6, 1e-18);
  EXPECT_NEAR(state.contact_radius / std::sqrt(radius * 5e-9), 1, 1e-14);
  EXPECT_EQ(state.stiffness, 2e4);
  EXPECT_NEAR(linear.approach(1e-4 - 3e-6), 5e-9, 1e-22);
  EXPECT_EQ(linear.advance({}, 0).force, 0);
  EXPECT_FALSE(linear.advance({}, 0).touching);
}

TEST(Tabor_analytic, parameter_is_the_cube_root_of_its_powers) {
  EXPECT_NEAR(tabor_parameter(2, 3, 5, 7), std::cbrt(3 * 25.0 / (4 * 343)), 1e-14);
}

TEST(Tabor_other_code, parameter_agrees_with_the_reference) {
  const auto path = asperity::test::reference_table("06_adhesion_table_system.csv");
  const CsvTable table = read_csv(path);
  const auto z0 = table.numbers("z0_nm"), w = table.numbers("w_JKR_mJ/m2"),
             mu = table.numbers("Tabor_mu_JKR");
  for (std::size_t i = 0; i < z0.size(); ++i) {
    if (table.rows[i][0] != "borosilicate/Si") continue;
    EXPECT_NEAR(tabor_parameter(modulus, radius, w[i] * 1e-3, z0[i] * 1e-9) / mu[i], 1,
                1e-5);  // six digits in the table
  }
}

TEST(MaugisBranch_other_code, pulls_off_and_rests_where_the_reference_does) {
  const CsvTable table = read_csv(asperity::test::reference_table("06_adhesion_table_maugis.csv"));
  const auto lambda = table.numbers("lambda"), pull_off = table.numbers("Ppulloff/(pi*w*R)"),
             at_rest = table.numbers("delta_zero_load"), at_pull_off = table.numbers("delta_at_pulloff");
  ASSERT_GT(lambda.size(), 10u);
  constexpr double six_digits = 5e-6, at_minimum = 2e-4;  // where the force changes by its square alone
  for (std::size_t i = 0; i < lambda.size(); ++i) {
    const MaugisBranch branch(lambda[i]);
    EXPECT_NEAR(branch.pull_off(), -pull_off[i], 2 * six_digits) << lambda[i];
    EXPECT_NEAR(branch.approach(0), at_rest[i], 2 * six_digits) << lambda[i];
    EXPECT_NEAR(branch.force(at_rest[i]), 0, 4 * six_digits) << lambda[i];
    EXPECT_NEAR(branch.force(at_pull_off[i]), pull_off[i], at_minimum) << lambda[i];
    EXPECT_LE(branch.release(), at_pull_off[i] + at_minimum) << lambda[i];
  }
}

/// Under fixed displacement JKR's contact breaks at 5/9 of its pull-off force of 3/2 pi w R.
TEST(MaugisBranch_other_code, breaks_where_JKR_does_in_its_limit) {
  const MaugisBranch branch(50);
  const Jkr jkr{1, 1, 1};
  const double unit = std::cbrt(pi * pi / (16.0 / 9));  // of the approach, for E* = R = w = 1
  EXPECT_NEAR(branch.release() * unit / jkr.smallest_approach(), 1, 2e-3);
  EXPECT_NEAR(branch.force(branch.release()), -5.0 / 6, 0.01);
}

/// States at an approach are cubics between those of a table; under a force they solve Maugis' equations.
TEST(MaugisBranch_analytic, states_at_an_approach_are_those_under_its_force) {
  for (const double lambda : {0.01, 0.1, 0.5, 0.9, 0.938, 0.95, 1.0, 2.0, 5.0, 50.0}) {
    const MaugisBranch branch(lambda);
    for (int i = 0; i <= 600; ++i) {
      const double force = -branch.pull_off() + 1e-6 + std::pow(10.0, -4 + 0.01 * i),
                   approach = branch.approach(force);
      EXPECT_NEAR(branch.force(approach), force, 3e-9 * (1 + std::abs(force))) << lambda;
      const MaugisBranch::Contact at = branch.contact(approach), under = branch.contact_under(force);
      EXPECT_NEAR(at.radius, under.radius, 1e-6 * (1 + under.radius)) << lambda << " under " << force;
      EXPECT_NEAR(at.edge, under.edge, 1e-6 * under.edge) << lambda << " under " << force;
    }
  }
}

TEST(MaugisBranch_analytic, attracts_on_beyond_its_last_touch_where_that_is_no_jump) {
  // Force and approach go on where the contact has shrunk to nothing, and the surfaces part where the
  // approach has its minimum: at a disc of radius 8 lambda/(3 pi) (Maugis 1992).
  for (const double lambda : {0.1, 0.3, 0.6, 0.9}) {
    const MaugisBranch branch(lambda);
    EXPECT_LT(branch.parting(), branch.release()) << lambda;
    EXPECT_NEAR(branch.force_apart(branch.release()), branch.force(branch.release() + 1e-9), 2e-3) << lambda;
    const double disc = 8 * lambda / (3 * M_PI);
    EXPECT_NEAR(branch.force_apart(branch.parting()), -M_PI * lambda / 2 * disc * disc, 1e-6) << lambda;
  }
  for (const double lambda : {0.95, 1.5, 5.0})
    EXPECT_EQ(MaugisBranch(lambda).parting(), MaugisBranch(lambda).release()) << lambda;
}

TEST(MaugisBranch_analytic, attraction_of_a_long_range_falls_with_the_gap_as_Derjaguin_has_it) {
  // 2 pi R times the work that is left (1934): of stiff bodies, w (1 - g/h0).
  const double lambda = 0.01, range = 2 / (M_PI * lambda);
  const MaugisBranch branch(lambda);
  for (const double share : {0.1, 0.5, 0.9})
    EXPECT_NEAR(branch.force_apart(-share * range), -2 * (1 - share), 0.01) << share;
}

TEST(MaugisBranch_analytic, is_DMT_without_range) {
  const MaugisBranch branch(0), nearly(1e-10);
  for (const double approach : {0.1, 1.0, 30.0}) {
    EXPECT_DOUBLE_EQ(branch.force(approach), std::pow(approach, 1.5) - 2);
    EXPECT_NEAR(nearly.force(approach), branch.force(approach), 1e-3);
    EXPECT_NEAR(branch.approach(branch.force(approach)), approach, 1e-12 * approach);
  }
}

}  // namespace
}  // namespace asperity
