// The quick pace of the contact solver: as few iterations as it is there for, the answers of the cautious
// one, which takes over where it fails, and the prediction of a motion that goes on.
#include <gtest/gtest.h>

#include <cmath>

#include "fem/contact/steady_prediction.h"
#include "fem/interface/friction/running_in.h"
#include "fem/interface/friction/static_peak.h"
#include "tests/fem/support/frictional_contact.h"

namespace {

using namespace asperity;

constexpr double path_step = 12e-9;  // [m]
constexpr int path_steps = 6;

test::FrictionalContactOptions coarse(double yield_stress) {
  test::FrictionalContactOptions o;
  o.cells_per_radius = 6, o.layers = 2, o.region = 1.6, o.path_length = 4 * path_steps * path_step;
  o.yield_stress = yield_stress, o.slip_tolerance = 1e-3, o.loaded = false;
  return o;
}

/// What a contact says after its steps, and what these took.
struct Moved {
  fem::ContactResultants last;
  double friction_work = 0, plastic_work = 0;
  int linear = 0, restarts = 0;
};

/// Rolls, shifts or spins a contact of a friction law of its own at either pace.
Moved moved(char motion, double yield_stress, bool cautious,
            const std::shared_ptr<const fem::FrictionLaw>& friction = {}, double close = 1) {
  const auto options = coarse(yield_stress);
  test::FrictionalContact contact(options);
  auto solver_options = test::FrictionalContact::solver_options(options);
  solver_options.cautious = cautious;
  solver_options.penetration_tolerance *= close, solver_options.slip_tolerance *= close;
  if (friction) solver_options.friction = friction;
  fem::ContactSolver solver(contact.system, solver_options);
  auto state = solver.first_touch();
  solver.push_rigidly(state, 0.8 * contact.contact_radius * contact.contact_radius / options.radius);
  Moved result;
  for (int k = 0; k <= path_steps; ++k) {
    fem::RigidMotion to;
    const double way = k * path_step;
    if (motion == 'r') to.roll = way / options.radius;
    if (motion != 's') to.x = way;
    if (motion == 's') to.spin = way / contact.contact_radius;
    const auto before = state.displacement;
    const auto report = solver.solve(state, options.load, to);
    EXPECT_TRUE(report.converged) << motion << k;
    result.plastic_work += contact.system.bodies().accept(before, state.displacement).plastic_work;
    result.friction_work += report.friction_work;
    result.linear += report.linear, result.restarts += report.restarts;
  }
  result.last = solver.resultants(state);
  return result;
}

TEST(QuickIterationNightly_behaviour, finds_what_the_cautious_one_finds_in_all_motions_elastic_and_yielding) {
  const double yielding = 3e9;
  for (const double yield_stress : {yielding, std::numeric_limits<double>::infinity()})
    for (const char motion : {'r', 'x', 's'}) {
      const Moved quick = moved(motion, yield_stress, false, {}, 0.1),
                  cautious = moved(motion, yield_stress, true, {}, 0.1);
      const auto &a = quick.last, &b = cautious.last;
      EXPECT_NEAR(a.area, b.area, 1e-4 * b.area) << motion;
      EXPECT_NEAR(a.largest_pressure, b.largest_pressure, 2e-4 * b.largest_pressure) << motion;
      EXPECT_NEAR(a.lateral_force[0], b.lateral_force[0], 2e-4 * 0.5 * b.force) << motion;
      EXPECT_NEAR(a.rolling_moment, b.rolling_moment, 2e-4 * b.force * b.pressure_radius) << motion;
      EXPECT_NEAR(a.torsion_moment, b.torsion_moment, 2e-4 * b.force * b.pressure_radius) << motion;
      EXPECT_NEAR(quick.plastic_work, cautious.plastic_work, 1e-3 * cautious.plastic_work) << motion;
      EXPECT_NEAR(quick.friction_work, cautious.friction_work, 1e-3 * cautious.friction_work + 1e-18)
          << motion;
      EXPECT_EQ(quick.restarts, 0) << motion;
    }
}

TEST(QuickIteration_behaviour, finds_what_the_cautious_one_finds_under_friction_with_history) {
  const std::shared_ptr<const fem::FrictionLaw> laws[] = {std::make_shared<fem::StaticPeak>(0.3, 0.5, 200e-9),
                                                          std::make_shared<fem::RunningIn>(0.3, 0.5, 200e-9)};
  for (const auto& law : laws) {
    const double elastic = std::numeric_limits<double>::infinity();
    const Moved quick = moved('x', elastic, false, law, 0.1), cautious = moved('x', elastic, true, law, 0.1);
    EXPECT_NEAR(quick.last.lateral_force[0], cautious.last.lateral_force[0],
                2e-4 * cautious.last.lateral_force[0]);
    EXPECT_NEAR(quick.friction_work, cautious.friction_work, 1e-3 * cautious.friction_work);
  }
}

TEST(QuickIteration_regression, steps_of_a_motion_take_few_conjugate_gradients) {
  const double elastic = std::numeric_limits<double>::infinity();
  // Of a smooth contact, as measured when the quick pace came: 140 of 174 sliding, 105 of 117 spinning.
  constexpr std::pair<char, double> shares[] = {{'r', 0.8}, {'x', 0.83}, {'s', 0.92}};
  for (const auto& [motion, share] : shares) {
    const int quick = moved(motion, elastic, false).linear, cautious = moved(motion, elastic, true).linear;
    EXPECT_LE(quick, share * cautious) << motion << " " << quick << " " << cautious;
  }
}

TEST(QuickIteration_behaviour, a_step_that_fails_is_solved_cautiously_from_the_accepted_state) {
  auto options = coarse(std::numeric_limits<double>::infinity());
  options.loaded = true;
  test::FrictionalContact contact(options);
  auto limited = test::FrictionalContact::solver_options(options);
  limited.largest_newton = 3;  // too few for either
  fem::ContactSolver both(contact.system, limited);
  limited.cautious = true;
  fem::ContactSolver cautious(contact.system, limited);
  auto tried = contact.state, expected = contact.state;
  fem::RigidMotion far;
  far.x = 5 * path_step;
  const auto report = both.solve(tried, options.load, far);
  const auto alone = cautious.solve(expected, options.load, far);
  EXPECT_EQ(report.restarts, 1);
  EXPECT_EQ(alone.restarts, 0);
  EXPECT_FALSE(report.converged);
  EXPECT_GT(report.newton, alone.newton);
  EXPECT_EQ(tried.multiplier, expected.multiplier);
  EXPECT_EQ(tried.approach, expected.approach);
}

/// A state of two rows with a motion, a pressure and a displacement.
fem::ContactState state_at(const fem::MeshLevel& level, double x, double pressure, double displacement) {
  fem::ContactState state;
  level.initialise(state.displacement);
  for (unsigned i = 0; i < state.displacement.locally_owned_size(); ++i)
    state.displacement.local_element(i) = displacement;
  state.displacement.update_ghost_values();
  state.multiplier = {pressure, 10 - pressure};
  state.shear = {std::vector<double>{2 * pressure, 0}, std::vector<double>{0, 0}};
  state.motion.x = x;
  return state;
}

TEST(SteadyPrediction_analytic, goes_on_linearly_and_never_pulls) {
  test::FrictionalContact contact(coarse(std::numeric_limits<double>::infinity()));
  const auto& level = contact.system.level();
  fem::SteadyPrediction prediction(1.0, 0.1);
  auto start = state_at(level, 1, 1, 0.5), before = state_at(level, 1, 1, 0.5),
       after = state_at(level, 3, 6, 2);
  prediction.remember(start, before, 7);
  EXPECT_EQ(prediction.share_of_last_step(before, {5, 0, 0, 0}, 7), 0);  // a load has led there
  prediction.remember(before, after, 7);
  EXPECT_DOUBLE_EQ(prediction.share_of_last_step(after, {5, 0, 0, 0}, 7), 1);
  EXPECT_DOUBLE_EQ(prediction.share_of_last_step(after, {4, 0, 0, 0}, 7), 0.5);
  EXPECT_DOUBLE_EQ(prediction.share_of_last_step(after, {90, 0, 0, 0}, 7), 2);
  EXPECT_EQ(prediction.share_of_last_step(after, {2, 0, 0, 0}, 7), 0);  // back
  EXPECT_EQ(prediction.share_of_last_step(after, {3, 2, 0, 0}, 7), 0);  // across
  EXPECT_EQ(prediction.share_of_last_step(after, {3, 0, 0, 0}, 7), 0);  // rests
  EXPECT_EQ(prediction.share_of_last_step(after, {5, 0, 0, 0}, 8), 0);  // another load
  EXPECT_EQ(prediction.share_of_last_step(start, {5, 0, 0, 0}, 7), 0);  // from elsewhere
  prediction.move_on(after, 1);
  EXPECT_DOUBLE_EQ(after.displacement.local_element(0), 3.5);
  EXPECT_EQ(after.multiplier, (std::vector<double>{11, 0}));
  EXPECT_EQ(after.shear[0], (std::vector<double>{22, 0}));
}

TEST(SteadyPrediction_analytic, goes_on_with_a_load_that_grows_as_it_did) {
  test::FrictionalContact contact(coarse(std::numeric_limits<double>::infinity()));
  const auto& level = contact.system.level();
  fem::SteadyPrediction prediction(1.0, 0.1);
  auto start = state_at(level, 3, 0, 0), before = state_at(level, 3, 1, 1), after = state_at(level, 3, 6, 3);
  const fem::RigidMotion rests{3, 0, 0, 0}, moves{4, 0, 0, 0};
  prediction.remember(start, before, 7);
  EXPECT_EQ(prediction.share_of_last_step(before, rests, 9), 0);  // nothing says from which load
  prediction.remember(before, after, 9);
  EXPECT_DOUBLE_EQ(prediction.share_of_last_step(after, rests, 12), 1.5);
  EXPECT_DOUBLE_EQ(prediction.share_of_last_step(after, rests, 90), 2);
  EXPECT_EQ(prediction.share_of_last_step(after, rests, 8), 0);   // back
  EXPECT_EQ(prediction.share_of_last_step(after, rests, 9), 0);   // nothing changes
  EXPECT_EQ(prediction.share_of_last_step(after, moves, 9), 0);   // the last step did not move
  EXPECT_EQ(prediction.share_of_last_step(after, moves, 12), 0);  // nor do both go on together
  EXPECT_EQ(prediction.share_of_last_step(start, rests, 12), 0);  // from elsewhere
  fem::SteadyPrediction resumed(1.0, 0.1);
  resumed.restore(prediction.memory(after), after);
  EXPECT_DOUBLE_EQ(resumed.share_of_last_step(after, rests, 12), 1.5);
  auto apart = after;
  apart.multiplier = {0, 0};
  resumed.remember(after, apart, 11);
  EXPECT_EQ(resumed.share_of_last_step(apart, rests, 13), 0);  // bodies apart move as they are
}

}  // namespace
