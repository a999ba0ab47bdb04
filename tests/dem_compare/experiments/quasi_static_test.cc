#include "dem_compare/experiments/quasi_static.h"
#include "core/shear_moduli.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/csv.h"
#include "core/error.h"
#include "dem_compare/experiments/particle_experiment.h"
#include "dem_compare/laws/jkr.h"
#include "tests/dem_compare/experiments/standard_contact.h"
#include "tests/support/verification.h"

namespace asperity {
namespace {

constexpr double pi = M_PI;
constexpr double radius = 8.5e-6;
const ElasticBody borosilicate{71e9, 0.17}, silicon{179e9, 0.25}, diamond{1140e9, 0.07};

StandardContact on_silicon() {
  StandardContact contact;
  contact.particle = borosilicate;
  contact.plane = silicon;
  contact.radius = radius;
  contact.sliding = {0.23, 0};
  return contact;
}
StandardContact on_diamond() {
  StandardContact contact = on_silicon();
  contact.plane = diamond;
  return contact;
}

FrictionLoop simulate_glued_sphere(const ContactModel& substrate, const LoopProgram& program) {
  return simulate_quasi_static(make_particle("glued", {substrate, substrate}), program);
}
FrictionLoop simulate_rolling_sphere(const ContactModel& substrate, const ContactModel& indenter,
                                     const LoopProgram& program) {
  return simulate_quasi_static(make_particle("rolling", {substrate, indenter}), program);
}
FrictionLoop simulate_rail(const ContactModel& flank, const ContactModel& indenter, double inclination,
                           const LoopProgram& program) {
  return simulate_quasi_static(make_particle("rail", {flank, indenter, inclination}), program);
}

TEST(GluedSphere_analytic, slope_plateau_and_reversal_travel_are_those_of_Mindlin_and_Coulomb) {
  LoopProgram program;
  const FrictionLoop loop = simulate_glued_sphere(model_of(on_silicon()), program);
  const LoopNumbers numbers = measure(loop);
  const double k = 8 * reduced_shear_modulus(borosilicate, silicon) *
                   Hertz{reduced_modulus(borosilicate, silicon), radius}.contact_radius(program.normal_load);
  test::Largest error;
  for (const double e :
       {numbers.initial_slope / k - 1, numbers.reversal_slope / k - 1, numbers.plateau / 23e-6 - 1,
        numbers.offset / 23e-6, numbers.reversal_travel / (2 * 23e-6 / k) - 1})
    error.count(e);
  EXPECT_TRUE(
      (test::Verified{"Reduced laws", "glued sphere: slopes, plateau, travel of reversal", "8 G* a, mu P"}
           .below(error, 1e-9)));
  for (const LoopRow& row : loop.rows) {
    EXPECT_NEAR(row.normal_force / 1e-4, 1, 1e-9);
    EXPECT_EQ(row.rotation.norm(), 0);
  }
}

TEST(GluedSphere_analytic, partial_slip_keeps_the_plateau_and_the_slope_and_yields_later) {
  StandardContact contact = on_silicon();
  contact.partial_slip = true;
  contact.sliding.adhesion_force = 12e-6;
  LoopProgram program;
  program.first_increment = 1e-14;
  program.growth = 1.02;
  const LoopNumbers numbers = measure(simulate_glued_sphere(model_of(contact), program));
  const double k = 8 * reduced_shear_modulus(borosilicate, silicon) *
                   Hertz{reduced_modulus(borosilicate, silicon), radius}.contact_radius(program.normal_load);
  EXPECT_NEAR(numbers.initial_slope / k, 1, 1e-5);
  EXPECT_NEAR(numbers.reversal_slope / k, 1, 1e-5);
  const double force = 0.23 * 112e-6;
  EXPECT_NEAR(numbers.plateau / force, 1, 1e-9);
  // The branch after a reversal ends at 3 mu f/(8 G* a) = 3 mu f/k; 99.9 % of it at 1 - 0.001^(2/3) of that.
  EXPECT_NEAR(numbers.plateau_travel / (3 * force / k * 0.99), 1, 1e-2);
  // A cycle +-A of gross sliding: 4 mu f A less two corners, each int_0^1 (1-t)^(3/2) dt = 2/5 of 2 mu f
  // times 2 delta_gs.
  const double gross = 1.5 * force / k;
  EXPECT_NEAR(numbers.dissipation / (4 * force * program.amplitude - 2 * 0.4 * 2 * force * 2 * gross), 1,
              1e-4);
}

TEST(GluedSphere_analytic, adhesive_contacts_carry_the_load_on_their_larger_area) {
  const double w = 0.08;
  ContactModel model = model_of(on_silicon());
  const Jkr jkr{reduced_modulus(borosilicate, silicon), radius, w};
  model.normal = jkr;
  LoopProgram program;
  program.normal_load = 0;
  model.sliding = Mindlin{reduced_shear_modulus(borosilicate, silicon), {0.23, 5e-6}};
  const LoopNumbers numbers = measure(simulate_glued_sphere(model, program));
  EXPECT_NEAR(
      numbers.initial_slope / (8 * reduced_shear_modulus(borosilicate, silicon) * jkr.radius_at_force(0)), 1,
      1e-8);
  EXPECT_NEAR(numbers.plateau / (0.23 * 5e-6), 1, 1e-8);
}

/// Two rows of the steady part of the last leg.
std::pair<const LoopRow&, const LoopRow&> steady_rows(const FrictionLoop& loop) {
  return {loop.rows[loop.rows.size() - 11], loop.rows.back()};
}

TEST(RollingSphere_analytic,
     lateral_force_is_the_mean_rolling_coefficient_times_the_load_and_the_sphere_goes_half_the_way) {
  StandardContact below = on_silicon(), above = on_diamond();
  below.lever = above.lever = LeverArm::particle_radius;
  below.rolling = {5.304e-3, 0};
  above.rolling = {2.5e-3, 0};
  LoopProgram program;
  const FrictionLoop loop = simulate_rolling_sphere(model_of(below), model_of(above), program);
  const LoopNumbers numbers = measure(loop);
  const test::Verified verified{"Reduced laws", "rolling sphere: lateral force",
                                "mean of both coefficients times the load"};
  EXPECT_TRUE(verified.below(numbers.plateau / ((5.304e-3 + 2.5e-3) / 2 * 1e-4) - 1, 1e-7));
  const auto [left, right] = steady_rows(loop);
  const double way = right.indenter_displacement - left.indenter_displacement;
  EXPECT_NEAR((right.displacement.x() - left.displacement.x()) / way, 0.5, 1e-6);
  EXPECT_NEAR((right.rotation.y() - left.rotation.y()) * 2 * radius / way, 1, 1e-6);
  for (const LoopRow& row : loop.rows)
    for (const ContactRecord& contact : row.contacts) EXPECT_FALSE(contact.slides);
}

TEST(RollingSphere_analytic, with_the_true_lever_arms_the_balance_of_moments_gives_the_force) {
  StandardContact below = on_silicon(), above = on_diamond();
  below.rolling = {7.9e-4, 571.4e-6, LengthScale::contact_radius};
  above.rolling = {4.6e-4, 1398e-6, LengthScale::particle_radius};
  LoopProgram program;
  program.normal_load = 1e-3;
  const FrictionLoop loop = simulate_rolling_sphere(model_of(below), model_of(above), program);
  const double delta_s = Hertz{reduced_modulus(borosilicate, silicon), radius}.approach(1e-3),
               delta_i = Hertz{reduced_modulus(borosilicate, diamond), radius}.approach(1e-3);
  const double moment = 7.9e-4 * std::sqrt(radius * delta_s) * (1e-3 + 571.4e-6) +
                        4.6e-4 * (radius - delta_i) * (1e-3 + 1398e-6);
  EXPECT_NEAR(measure(loop).plateau / (moment / (2 * radius - delta_s - delta_i)), 1, 1e-7);
}

TEST(RollingSphere_analytic, a_slippery_indenter_slides_over_a_sphere_that_stays) {
  StandardContact below = on_silicon(), above = on_diamond();
  below.rolling = above.rolling = {5e-3, 0};
  above.sliding = {2e-3, 0};
  LoopProgram program;
  const FrictionLoop loop = simulate_rolling_sphere(model_of(below), model_of(above), program);
  EXPECT_NEAR(measure(loop).plateau / (2e-3 * 1e-4), 1, 1e-9);
  EXPECT_LT(std::abs(loop.rows.back().displacement.x()), 1e-9);
  EXPECT_TRUE(loop.rows.back().contacts[1].slides);
}

TEST(RollingSphere_analytic, without_rolling_resistance_rolling_takes_no_force) {
  const LoopNumbers numbers =
      measure(simulate_rolling_sphere(model_of(on_silicon()), model_of(on_diamond()), LoopProgram{}));
  EXPECT_LT(numbers.plateau, 1e-12 * 1e-4 + 1e-15);
}

struct RailCase {
  double degrees, rolling, resistance;  // resistance: f_l/f_n of a flank, from the paper's eq. murail
};

class Rail_analytic : public testing::TestWithParam<RailCase> {};

TEST_P(Rail_analytic, resistance_of_a_flank_is_that_of_the_papers_formula) {
  const RailCase rail = GetParam();
  const double theta = rail.degrees * pi / 180, flank_load = 5e-4;
  StandardContact flank = on_silicon(), top = on_diamond();
  flank.lever = top.lever = LeverArm::particle_radius;
  flank.sliding = top.sliding = {0.65, 0};
  flank.rolling = top.rolling = {rail.rolling, 0};
  flank.torsion = {0.0056, 0};
  LoopProgram program;
  program.normal_load = 2 * std::cos(theta) * flank_load;
  const FrictionLoop loop = simulate_rail(model_of(flank), model_of(top), theta, program);
  const LoopNumbers numbers = measure(loop);
  const double mu = (2 * std::cos(theta) * rail.rolling + std::sin(theta) * 0.0056) / (1 + std::cos(theta));
  const auto verified = [&](const std::string& what, const char* source) {
    return test::Verified{
        "Reduced laws", "rail at " + std::to_string(std::lround(rail.degrees)) + " degrees: " + what, source};
  };
  EXPECT_TRUE(
      verified("resistance", "balance of moments").below(numbers.plateau / 2 / flank_load / mu - 1, 1e-6));
  EXPECT_TRUE(verified("the formula", "figure of six digits").below(mu / rail.resistance - 1, 5e-6));
  for (const LoopRow& row : loop.rows) {
    EXPECT_NEAR(row.contacts[0].normal_force / flank_load, 1, 1e-4);
    EXPECT_NEAR(row.contacts[0].normal_force, row.contacts[1].normal_force, 1e-9 * flank_load);
    EXPECT_LT(std::abs(row.displacement.y()), 1e-15);
  }
  // Rolling without slip on flanks and indenter: v/v_i = cos/(1 + cos).
  const auto [left, right] = steady_rows(loop);
  EXPECT_NEAR((right.displacement.x() - left.displacement.x()) /
                  (right.indenter_displacement - left.indenter_displacement),
              std::cos(theta) / (1 + std::cos(theta)), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Angles, Rail_analytic,
                         testing::Values(RailCase{25, 3.602e-4, 1.58399e-3},
                                         RailCase{45, 3.146e-4, 2.58022e-3},
                                         RailCase{60, 2.960e-4, 3.43049e-3}));

TEST(Rail_analytic, histories_that_follow_half_the_torsion_unload_the_flanks_a_little) {
  // The lateral force of a flank turns up or down the slope with them, by half the twist of up to 0.1 rad,
  // and carries load.
  const auto flank_load = [](HistorySpin spin) {
    StandardContact flank = on_silicon(), top = on_diamond();
    flank.sliding = top.sliding = {0.65, 0};
    flank.rolling = top.rolling = {3e-4, 0};
    flank.torsion = {0.0056, 0};
    flank.history_spin = spin;
    const FrictionLoop loop = simulate_rail(model_of(flank), model_of(top), pi / 4, LoopProgram{});
    double least = 1;
    for (const LoopRow& row : loop.rows)
      least = std::min(least, row.contacts[0].normal_force / (1e-4 / std::sqrt(2.0)));
    return least;
  };
  EXPECT_NEAR(flank_load(HistorySpin::other_body), 1, 1e-6);
  EXPECT_LT(flank_load(HistorySpin::mean_of_bodies), 1 - 5e-5);
  EXPECT_GT(flank_load(HistorySpin::mean_of_bodies), 1 - 5e-4);
}

TEST(LoopProgram_behaviour, stations_end_at_each_reversal_and_are_dense_after_it) {
  LoopProgram program;
  program.cycles = 2;
  const auto stations = loop_stations(program, 1e-11);
  double last = 0;
  int leg = 0, reversals = 0;
  for (const LoopStation& station : stations) {
    if (station.leg != leg) {
      EXPECT_EQ(std::abs(last), program.amplitude);
      EXPECT_NEAR(std::abs(station.position - last), 1e-11, 1e-20);
      leg = station.leg;
      ++reversals;
    }
    EXPECT_LE(std::abs(station.position - last), program.amplitude / 50 * (1 + 1e-12));
    last = station.position;
  }
  EXPECT_EQ(reversals, 4);
  EXPECT_EQ(last, program.amplitude);
  program.amplitude = 0;
  EXPECT_THROW(loop_stations(program, 1e-11), InputError);
}

TEST(FrictionLoop_behaviour, table_has_a_row_per_step_and_a_column_per_quantity_of_each_contact) {
  StandardContact below = on_silicon(), above = on_diamond();
  below.rolling = above.rolling = {5e-3, 0};
  const FrictionLoop loop = simulate_rolling_sphere(model_of(below), model_of(above), LoopProgram{});
  const std::string text = to_csv(loop);
  EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')), loop.rows.size() + 1);
  for (const char* name : {"indenter_displacement [m]", "lateral_force [N]", "particle_rotation_y [rad]",
                           "substrate_normal_force [N]", "indenter_torsion_moment [N m]"})
    EXPECT_NE(text.find(name), std::string::npos) << name;
}

TEST(FrictionLoop_behaviour, a_path_without_reversal_has_no_loop_numbers) {
  LoopProgram program;
  program.cycles = 0;
  EXPECT_THROW(measure(simulate_glued_sphere(model_of(on_silicon()), program)), InputError);
}

TEST(SingleParticle_behaviour, experiments_without_any_resistance_and_rails_without_flanks_are_refused) {
  StandardContact bare = on_silicon();
  bare.sliding = {0, 0};
  EXPECT_THROW(simulate_glued_sphere(model_of(bare), LoopProgram{}), InputError);
  EXPECT_THROW(make_particle("rail", {model_of(bare), model_of(bare), pi / 2}), InputError);
}

}  // namespace
}  // namespace asperity
