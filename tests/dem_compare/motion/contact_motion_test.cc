#include "dem_compare/motion/contact_motion.h"

#include <gtest/gtest.h>

#include <random>

#include "core/shear_moduli.h"
#include "dem_compare/laws/mindlin_deresiewicz.h"
#include "dem_compare/motion/contact_model.h"
#include "tests/support/verification.h"

namespace asperity {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
constexpr double radius = 8.5e-6, other_radius = 3e-6;

/// Random vectors of a given size and random rotations, the same in every run.
class Chance {
 public:
  Vector3d vector(double size) {
    return size * Vector3d(normal_(engine_), normal_(engine_), normal_(engine_));
  }
  Quaterniond rotation() {
    return Quaterniond(normal_(engine_), normal_(engine_), normal_(engine_), normal_(engine_)).normalized();
  }
  Placement near(const Placement& placement, double shift, double turn) {
    return {placement.position + vector(shift), rotation_by(vector(turn)) * placement.orientation};
  }

 private:
  std::mt19937 engine_{20140811};
  std::normal_distribution<double> normal_{0, 1};
};

/// An observer who has moved and turned.
struct Observer {
  Vector3d shift;
  Quaterniond turn;
  Placement sees(const Placement& body) const {
    return {turn * body.position + shift, turn * body.orientation};
  }
  PlanePlacement sees(const PlanePlacement& plane) const {
    return {sees(static_cast<const Placement&>(plane)), plane.normal};
  }
};

/// Lengths are counted in radii.
void count_difference(test::Largest& difference, const ContactMotion& rest, const ContactMotion& moving,
                      const Quaterniond& before, const Quaterniond& after) {
  difference.count((moving.normal - after * rest.normal).norm());
  difference.count((moving.approach - rest.approach) / radius);
  difference.count((moving.sliding - after * rest.sliding).norm() / radius);
  difference.count((moving.rolling - after * rest.rolling).norm());
  difference.count(moving.torsion - rest.torsion);
  const Quaterniond expected = after * rest.frame_rotation * before.conjugate();
  difference.count(std::abs(expected.dot(moving.frame_rotation)) - 1);
}

test::Verified observers(const char* contact) {
  return {"Reduced laws",
          std::string("motion of a contact under turning and drifting observers, ") + contact +
              ", lengths in radii",
          "the same motion"};
}

TEST(ContactMotion_analytic,
     any_rotation_and_shift_of_the_observer_leaves_the_motion_between_spheres_the_same) {
  Chance chance;
  test::Largest difference;
  for (int i = 0; i < 200; ++i) {
    const Placement other{chance.vector(1e-6), chance.rotation()};
    const Placement particle{
        other.position + (radius + other_radius - 1e-8) * (chance.rotation() * Vector3d::UnitX()),
        chance.rotation()};
    const Placement particle_after = chance.near(particle, 1e-7, 0.3),
                    other_after = chance.near(other, 1e-7, 0.3);
    const Observer before{chance.vector(1e-5), chance.rotation()},
        after{chance.vector(1e-5), chance.rotation()};
    for (const LeverArm lever : {LeverArm::distance_to_contact, LeverArm::particle_radius})
      for (const HistorySpin spin : {HistorySpin::mean_of_bodies, HistorySpin::other_body})
        count_difference(
            difference,
            sphere_on_sphere(particle, particle_after, radius, other, other_after, other_radius, lever, spin),
            sphere_on_sphere(before.sees(particle), after.sees(particle_after), radius, before.sees(other),
                             after.sees(other_after), other_radius, lever, spin),
            before.turn, after.turn);
  }
  EXPECT_TRUE(observers("two spheres").below(difference, 1e-13));
}

TEST(ContactMotion_analytic, any_rotation_and_shift_of_the_observer_leaves_the_motion_on_a_plane_the_same) {
  Chance chance;
  test::Largest difference;
  for (int i = 0; i < 200; ++i) {
    const PlanePlacement plane{{chance.vector(1e-6), chance.rotation()},
                               chance.rotation() * Vector3d::UnitZ()};
    const Placement sphere{plane.position + (radius - 1e-8) * (plane.orientation * plane.normal),
                           chance.rotation()};
    const Placement sphere_after = chance.near(sphere, 1e-7, 0.3);
    const PlanePlacement plane_after{chance.near(plane, 1e-7, 0.3), plane.normal};
    const Observer before{chance.vector(1e-5), chance.rotation()},
        after{chance.vector(1e-5), chance.rotation()};
    for (const HistorySpin spin : {HistorySpin::mean_of_bodies, HistorySpin::other_body})
      count_difference(
          difference,
          sphere_on_plane(sphere, sphere_after, radius, plane, plane_after, LeverArm::distance_to_contact,
                          spin),
          sphere_on_plane(before.sees(sphere), after.sees(sphere_after), radius, before.sees(plane),
                          after.sees(plane_after), LeverArm::distance_to_contact, spin),
          before.turn, after.turn);
  }
  EXPECT_TRUE(observers("sphere on plane").below(difference, 1e-13));
}

TEST(ContactMotion_analytic, a_pair_that_turns_as_one_body_moves_in_no_mode_and_carries_its_history_along) {
  Chance chance;
  const Placement other{chance.vector(1e-6), chance.rotation()};
  const Placement particle{
      other.position + (radius + other_radius - 1e-8) * (chance.rotation() * Vector3d::UnitX()),
      chance.rotation()};
  const Observer whole{chance.vector(1e-5), chance.rotation()};
  const ContactMotion motion =
      sphere_on_sphere(particle, whole.sees(particle), radius, other, whole.sees(other), other_radius,
                       LeverArm::distance_to_contact);
  EXPECT_LT(motion.sliding.norm(), 1e-13 * radius);
  EXPECT_LT(motion.rolling.norm(), 1e-13);
  EXPECT_NEAR(motion.torsion, 0, 1e-13);
  EXPECT_NEAR(std::abs(motion.frame_rotation.dot(whole.turn)), 1, 1e-13);
}

TEST(ContactMotion_analytic, small_steps_are_the_velocities_times_the_time) {
  Chance chance;
  const double time = 1e-6;
  for (int i = 0; i < 50; ++i) {
    const Placement other{chance.vector(1e-6), chance.rotation()};
    const Vector3d normal = chance.rotation() * Vector3d::UnitX();
    const double approach = 1e-8;
    const Placement particle{other.position + (radius + other_radius - approach) * normal, chance.rotation()};
    const BodyVelocity p{particle.position, chance.vector(1e-6), chance.vector(1)},
        o{other.position, chance.vector(1e-6), chance.vector(1)};
    const auto moved = [&](const Placement& body, const BodyVelocity& v) {
      return Placement{body.position + time * v.velocity,
                       rotation_by(time * v.angular_velocity) * body.orientation};
    };
    const ContactMotion step = sphere_on_sphere(particle, moved(particle, p), radius, other, moved(other, o),
                                                other_radius, LeverArm::distance_to_contact);
    const RelativeVelocity rate =
        relative_velocity(p, o, particle.position - (radius - approach / 2) * normal, normal);
    EXPECT_NEAR((step.approach - approach) / time, rate.approach, 1e-5 * 1e-6);  // of a speed of about 1 um/s
    EXPECT_LT((step.sliding / time - rate.sliding).norm(), 1e-5 * rate.sliding.norm());
    EXPECT_LT((step.rolling / time - rate.rolling).norm(), 1e-5 * rate.rolling.norm());
    EXPECT_NEAR(step.torsion / time, rate.torsion, 1e-5);
  }
}

TEST(RelativeVelocity_analytic, an_observer_who_turns_and_drifts_sees_the_same_velocities) {
  Chance chance;
  for (int i = 0; i < 100; ++i) {
    const Vector3d normal = chance.rotation() * Vector3d::UnitX();
    BodyVelocity p{chance.vector(1e-6), chance.vector(1e-6), chance.vector(1)},
        o{p.position - (radius + other_radius) * normal, chance.vector(1e-6), chance.vector(1)};
    const Vector3d contact = p.position - radius * normal;
    const RelativeVelocity rest = relative_velocity(p, o, contact, normal);
    const Quaterniond turn = chance.rotation();
    const Vector3d drift = chance.vector(1e-3), spin = chance.vector(10);
    const auto seen = [&](const BodyVelocity& body) {
      return BodyVelocity{turn * body.position, turn * (body.velocity + spin.cross(body.position) + drift),
                          turn * (body.angular_velocity + spin)};
    };
    const RelativeVelocity moving = relative_velocity(seen(p), seen(o), turn * contact, turn * normal);
    EXPECT_NEAR(moving.approach, rest.approach, 1e-15);
    EXPECT_LT((moving.sliding - turn * rest.sliding).norm(), 1e-15);
    EXPECT_LT((moving.rolling - turn * rest.rolling).norm(), 1e-13);
    EXPECT_NEAR(moving.torsion, rest.torsion, 1e-13);
  }
}

TEST(RelativeVelocity_analytic, bodies_that_close_have_a_positive_rate_of_approach) {
  const BodyVelocity particle{radius * Vector3d::UnitZ(), -1e-6 * Vector3d::UnitZ(), Vector3d::Zero()};
  EXPECT_NEAR(relative_velocity(particle, {}, Vector3d::Zero(), Vector3d::UnitZ()).approach, 1e-6, 1e-20);
}

const PlanePlacement ground;  // z = 0, normal z
Placement resting() { return {(radius - 6e-9) * Vector3d::UnitZ(), Quaterniond::Identity()}; }

TEST(ContactMotion_analytic, a_sphere_that_rolls_on_a_plane_without_slip_only_rolls) {
  const Placement before = resting();
  const double angle = 1e-3, lever = radius - 6e-9;
  const Placement after{before.position + lever * angle * Vector3d::UnitX(),
                        rotation_by(angle * Vector3d::UnitY())};
  const ContactMotion motion =
      sphere_on_plane(before, after, radius, ground, ground, LeverArm::distance_to_contact);
  EXPECT_LT(motion.sliding.norm(), 1e-15 * radius);
  EXPECT_LT((motion.rolling - angle * Vector3d::UnitY()).norm(), 1e-15);
  EXPECT_EQ(motion.torsion, 0);
}

TEST(ContactMotion_analytic, a_sphere_that_spins_on_a_plane_only_twists_and_its_history_turns_half_as_far) {
  const Placement before = resting();
  const Placement after{before.position, rotation_by(0.2 * Vector3d::UnitZ())};
  const ContactMotion motion =
      sphere_on_plane(before, after, radius, ground, ground, LeverArm::distance_to_contact);
  EXPECT_LT(motion.sliding.norm() + motion.rolling.norm() * radius, 1e-15 * radius);
  EXPECT_NEAR(motion.torsion, 0.2, 1e-14);
  EXPECT_LT((rotation_vector(motion.frame_rotation) - 0.1 * Vector3d::UnitZ()).norm(), 1e-14);
  const ContactMotion with_plane = sphere_on_plane(before, after, radius, ground, ground,
                                                   LeverArm::distance_to_contact, HistorySpin::other_body);
  EXPECT_LT(rotation_vector(with_plane.frame_rotation).norm(), 1e-14);
}

ContactModel sample_model() {
  const ElasticBody sphere{71e9, 0.17}, plane{179e9, 0.25};
  ContactModel model;
  model.normal = HertzOffset{reduced_modulus(sphere, plane), radius, 3.2e-6};
  model.sliding = MindlinDeresiewicz{reduced_shear_modulus(sphere, plane), radius, {0.23, 12e-6}};
  model.rolling =
      RollingResistance{7.9e-4,
                        571e-6,
                        LengthScale::particle_radius,
                        {RotationalStiffness::Kind::tangential_spring, reduced_shear_modulus(sphere, plane)}};
  model.torsion =
      TorsionResistance{0.0056,
                        0,
                        LengthScale::particle_radius,
                        {RotationalStiffness::Kind::tangential_spring, reduced_shear_modulus(sphere, plane)}};
  return model;
}

/// Largest difference over 200 steps, over the limit of the lateral force, between a history and what an
/// observer who turns all the time makes of it.
double largest_difference(const ContactModel& model) {
  Chance chance;
  double largest = 0;
  const Observer first{chance.vector(1e-6), chance.rotation()};
  Placement sphere = resting();
  PlanePlacement plane = ground;
  Observer observer = first;
  ContactModelState rest, moving;
  for (int i = 0; i < 200; ++i) {
    Placement sphere_after = chance.near(sphere, 0, 3e-5);
    sphere_after.position += 2e-10 * Vector3d(std::cos(0.1 * i), std::sin(0.07 * i), 0.3 * std::sin(0.2 * i));
    const Quaterniond tilt = rotation_by(1e-5 * Vector3d(std::sin(0.1 * i), 0.5, std::cos(0.2 * i)));
    const PlanePlacement plane_after{
        {plane.position + 1e-10 * Vector3d(std::sin(0.3 * i), 0, 0), tilt * plane.orientation}, plane.normal};
    const Observer observer_after{observer.shift + chance.vector(1e-6), chance.rotation()};
    const LeverArm lever = model.lever;
    rest = advance(model, rest, sphere_on_plane(sphere, sphere_after, radius, plane, plane_after, lever));
    moving = advance(model, moving,
                     sphere_on_plane(observer.sees(sphere), observer_after.sees(sphere_after), radius,
                                     observer.sees(plane), observer_after.sees(plane_after), lever));
    sphere = sphere_after;
    plane = plane_after;
    observer = observer_after;
    EXPECT_GT(rest.normal.force, 0);
    const double limit = model.sliding->limit(rest.normal.force);
    largest = std::max({largest, (moving.force - observer.turn * rest.force).norm() / limit,
                        (moving.moment - observer.turn * rest.moment).norm() / (limit * rest.lever)});
  }
  EXPECT_GT(rest.lateral.norm(), 1e-7);
  EXPECT_GT(std::abs(rest.torsion.resistance), 0);
  return largest;
}

TEST(ContactModel_analytic, forces_and_moments_of_a_history_turn_with_an_observer_who_turns_all_the_time) {
  ContactModel model = sample_model();
  EXPECT_LT(largest_difference(model), 1e-6);
  model.sliding = Mindlin{11.8e9, {0.23, 12e-6}};
  EXPECT_LT(largest_difference(model), 1e-9);
}

TEST(ContactModel_analytic, every_resistance_acts_against_its_motion) {
  const ContactModel model = sample_model();
  const auto after = [&](const Vector3d& shift, const Vector3d& turn) {
    const Placement before = resting(), now{before.position + shift, rotation_by(turn)};
    return advance(model, {}, sphere_on_plane(before, now, radius, ground, ground, model.lever));
  };
  const ContactModelState slid = after(1e-10 * Vector3d::UnitX(), Vector3d::Zero());
  EXPECT_LT(slid.force.x(), 0);
  EXPECT_GT(slid.moment.y(), 0);  // friction at the bottom turns the particle forward
  EXPECT_NEAR(slid.moment.y() / (-slid.force.x() * slid.lever), 1, 1e-12);
  const double angle = 1e-6;
  const ContactModelState rolled =
      after((radius - 6e-9) * angle * Vector3d::UnitX(), angle * Vector3d::UnitY());
  EXPECT_LT(rolled.moment.y(), 0);
  EXPECT_LT(std::abs(rolled.force.x()), 1e-12);
  EXPECT_LT(after(Vector3d::Zero(), angle * Vector3d::UnitZ()).moment.z(), 0);
}

TEST(ContactModel_analytic, viscous_forces_brake_and_obey_the_sliders_limits) {
  ContactModel model = sample_model();
  model.damping = ViscousDamping{0.5};
  const Placement here = resting();
  const ContactMotion still = sphere_on_plane(here, here, radius, ground, ground, model.lever);
  const ContactModelState rest = advance(model, {}, still);
  RelativeVelocity rate;
  rate.approach = 1e-4;
  rate.sliding = Vector3d(1e3, 0, 0);
  rate.rolling = Vector3d(0, 1e9, 0);
  rate.torsion = 1e9;
  const ContactModelState fast = advance(model, {}, still, rate, 5.7e-12);
  const double f = rest.normal.force;
  EXPECT_NEAR((fast.force.z() - f) / (0.5 * std::sqrt(5.7e-12 * rest.normal.stiffness) * 1e-4), 1, 1e-10);
  EXPECT_NEAR(fast.force.x() / (-0.23 * (f + 12e-6)), 1, 1e-12);
  EXPECT_NEAR(fast.moment.z() / (-0.0056 * rest.lever * f), 1, 1e-12);
  EXPECT_NEAR((fast.moment.y() + fast.force.x() * rest.lever) / (-7.9e-4 * rest.lever * (f + 571e-6)), 1,
              1e-10);
}

}  // namespace
}  // namespace asperity
