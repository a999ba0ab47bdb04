#include "dem_compare/experiments/dynamic.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "dem_compare/experiments/particle_experiment.h"
#include "dem_compare/experiments/quasi_static.h"
#include "tests/dem_compare/experiments/standard_contact.h"
#include "tests/support/verification.h"

namespace asperity {
namespace {

constexpr double pi = M_PI;
constexpr double radius = 8.5e-6;
const ElasticBody borosilicate{71e9, 0.17}, silicon{179e9, 0.25}, diamond{1140e9, 0.07};
constexpr double agreement = 0.01;  // dynamic against quasi-static

StandardContact contact_on(const ElasticBody& plane) {
  StandardContact contact;
  contact.particle = borosilicate;
  contact.plane = plane;
  contact.radius = radius;
  contact.sliding = {0.23, 0};
  contact.rolling = {5.304e-3, 0};
  contact.torsion = {0.0056, 0};
  return contact;
}
ContactModel damped(const StandardContact& contact) {
  ContactModel model = model_of(contact);
  model.damping = ViscousDamping{1};
  return model;
}

void expect_agreement(const std::string& what, const FrictionLoop& dynamic,
                      const FrictionLoop& quasi_static) {
  const LoopNumbers d = measure(dynamic), q = measure(quasi_static);
  const auto verified = [&](const char* quantity) {
    return test::Verified{"Reduced laws", what + " with inertia: " + quantity, "without inertia"};
  };
  EXPECT_TRUE(verified("slope at the start").within(d.initial_slope, q.initial_slope, agreement));
  EXPECT_TRUE(verified("slope after reversal").within(d.reversal_slope, q.reversal_slope, agreement));
  EXPECT_TRUE(verified("plateau").within(d.plateau, q.plateau, agreement));
  EXPECT_TRUE(verified("energy of the loop").within(d.dissipation, q.dissipation, agreement));
  const LoopRow &one = dynamic.rows.back(), &other = quasi_static.rows.back();
  EXPECT_NEAR(one.normal_force / other.normal_force, 1, agreement);
  EXPECT_NEAR(one.displacement.x() / other.displacement.x(), 1, agreement);
  EXPECT_NEAR(one.rotation.y(), other.rotation.y(), agreement * std::abs(other.rotation.y()));
}

TEST(DynamicGluedSphere_analytic,
     loop_agrees_with_the_quasi_static_one_within_one_percent_in_slope_and_plateau) {
  for (const bool partial_slip : {false, true}) {
    StandardContact contact = contact_on(silicon);
    contact.partial_slip = partial_slip;
    const SingleParticle particle = make_particle("glued", {damped(contact), damped(contact)});
    LoopProgram program;
    program.amplitude = 100e-9;
    DynamicOptions options;
    options.speed = 1e-3;
    const FrictionLoop dynamic = simulate_dynamic(particle, program, options),
                       still = simulate_quasi_static(particle, program);
    expect_agreement(partial_slip ? "glued sphere with partial slip" : "glued sphere", dynamic, still);
    EXPECT_NEAR(dynamic.speed / laboratory_speed, 1e3, 1e-9);
  }
}

TEST(DynamicRollingSphere_analytic,
     resistance_and_motion_agree_with_the_quasi_static_ones_within_one_percent) {
  const SingleParticle particle =
      make_particle("rolling", {damped(contact_on(silicon)), damped(contact_on(diamond))});
  LoopProgram program;
  program.amplitude = 40e-9;
  DynamicOptions options;
  options.speed = 1e-3;
  expect_agreement("rolling sphere", simulate_dynamic(particle, program, options),
                   simulate_quasi_static(particle, program));
}

TEST(DynamicRail_analytic, resistance_and_motion_agree_with_the_quasi_static_ones_within_one_percent) {
  const SingleParticle particle =
      make_particle("rail", {damped(contact_on(silicon)), damped(contact_on(diamond)), 45 * pi / 180});
  LoopProgram program;
  program.amplitude = 40e-9;
  DynamicOptions options;
  options.speed = 1e-3;
  expect_agreement("rail at 45 degrees", simulate_dynamic(particle, program, options),
                   simulate_quasi_static(particle, program));
}

TEST(DynamicGluedSphere_behaviour, halving_the_time_step_changes_nothing_that_matters) {
  const SingleParticle particle =
      make_particle("glued", {damped(contact_on(silicon)), damped(contact_on(silicon))});
  LoopProgram program;
  program.amplitude = 20e-9;
  DynamicOptions coarse;
  coarse.speed = 10e-3;
  DynamicOptions fine = coarse;
  fine.time_step_ratio /= 2;
  const LoopNumbers one = measure(simulate_dynamic(particle, program, coarse)),
                    other = measure(simulate_dynamic(particle, program, fine));
  EXPECT_NEAR(one.plateau / other.plateau, 1, 1e-3);
  EXPECT_NEAR(one.dissipation / other.dissipation, 1, 5e-3);
}

/// Speed after over speed before a sphere hits a plane, by velocity-Verlet.
double restitution(double damping, double speed) {
  ContactModel model = model_of(contact_on(silicon));
  model.damping = ViscousDamping{damping};
  const double mass = 4.0 / 3 * pi * std::pow(radius, 3) * 2230, dt = 1e-10;
  double approach = 0, rate = speed, acceleration = 0;
  ContactModelState state;
  for (;;) {
    rate += dt / 2 * acceleration;
    approach += dt * rate;
    if (approach <= 0) return -rate / speed;
    ContactMotion motion;
    motion.approach = approach;
    motion.lever = radius;
    RelativeVelocity velocity;
    velocity.approach = rate;
    state = advance(model, state, motion, velocity, mass);
    acceleration = -state.force.z() / mass;
    rate += dt / 2 * acceleration;
  }
}

TEST(Viscous_analytic, restitution_follows_from_the_coefficient_at_every_speed) {
  // c = 2 (5/6)^(1/2) beta with k = 2 E* a (Tsuji, Tanaka & Ishida 1992).
  for (const double e : {0.97, 0.8}) {
    const double beta = -std::log(e) / std::hypot(std::log(e), pi);
    for (const double speed : {0.01, 1.0})
      EXPECT_NEAR(restitution(2 * std::sqrt(5.0 / 6) * beta, speed), e, 2e-3);
  }
}

TEST(Viscous_other_code, the_papers_coefficient_gives_0989_and_not_097) {
  EXPECT_NEAR(restitution(0.0062, 0.1), 0.989, 5e-4);
}

TEST(Dynamic_behaviour, a_speed_of_zero_is_refused) {
  DynamicOptions options;
  options.speed = 0;
  const ContactModel still = model_of(contact_on(silicon));
  EXPECT_THROW(simulate_dynamic(make_particle("glued", {still, still}), LoopProgram{}, options), InputError);
}

}  // namespace
}  // namespace asperity
