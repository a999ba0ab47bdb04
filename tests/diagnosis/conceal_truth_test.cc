// The laws that make concealed data, against closed forms: data whose truth is wrong would prove nothing.
#include <gtest/gtest.h>

#include <cmath>

#include "core/hertz.h"
#include "dem_compare/laws/mindlin_deresiewicz.h"
#include "diagnosis/conceal/bridged_sphere.h"
#include "diagnosis/conceal/instrument_noise.h"
#include "diagnosis/conceal/masing_contact.h"
#include "diagnosis/conceal/normal_truth.h"
#include "diagnosis/conceal/relaxing_sphere.h"
#include "diagnosis/conceal/rough_layer.h"
#include "diagnosis/mechanics/relaxing_contact.h"

namespace asperity::hidden {
namespace {

constexpr double pi = M_PI, E = 52.8684e9, R = 8.5e-6;
const Sphere sphere{E, R};

TEST(ConcealedTruth_analytic, a_small_contact_of_a_true_sphere_is_hertz) {
  const Hertz hertz{E, R};
  for (const double d : {1e-9, 6.1864e-9, 60e-9}) {
    const double a = sphere.contact_radius(d);
    EXPECT_NEAR(sphere.approach_of(a) / d, 1, 1e-12);
    EXPECT_NEAR(sphere.force(d) / hertz.force(d), 1, 0.5 * d / R);
    EXPECT_NEAR(sphere.contact_radius_at_force(sphere.force(d)) / a, 1, 1e-8);
  }
  EXPECT_EQ(sphere.force(-1e-9), 0);
}

TEST(ConcealedTruth_analytic,
     even_pressure_on_a_disc_dents_its_middle_by_2_p_a_over_E_and_its_edge_by_2_over_pi_of_that) {
  const RoughLayer layer(sphere, 1e-9, 1e9, 1e-6, 60);
  const Eigen::VectorXd dent = layer.influence() * Eigen::VectorXd::Ones(60);
  const double middle = 2 * 1e-6 / E;
  EXPECT_NEAR(dent(0) / middle, 1, 2e-3);
  EXPECT_NEAR(dent(59) / (middle * 2 / pi), 1, 0.03);  // the outermost ring's middle lies inside of the edge
}

TEST(ConcealedTruth_analytic, a_thin_layer_of_asperities_leaves_hertz) {
  // First touch lies some decay lengths before the mean planes meet; stiffness at the same force is that of
  // Hertz.
  const double d = 40e-9;
  RoughLayer layer(sphere, 0.02e-9, 0.02 * E, 1.6 * sphere.contact_radius(d), 120);
  const double f = layer.force(d), step = 0.5e-9, stiffness = (layer.force(d + step) - f) / step;
  EXPECT_NEAR(stiffness / (2 * E * sphere.contact_radius_at_force(f)), 1, 0.02);
}

TEST(ConcealedTruth_analytic, under_little_load_the_force_of_the_layer_grows_e_fold_over_its_length) {
  const double length = 0.5e-9;
  RoughLayer layer(sphere, length, 0.02 * E, 0.4e-6, 60);
  const double low = layer.force(-14 * length), high = layer.force(-13 * length);
  EXPECT_NEAR(std::log(high / low), 1, 0.01);
}

TEST(ConcealedTruth_other_code, yielding_follows_kogut_and_etsion) {
  PlasticTruth plastic(E, R, 0.3, 1e6);
  const double d = plastic.critical_approach(), f = plastic.critical_force();
  EXPECT_NEAR(plastic.loading_force(2 * d) / f, 2.7657, 1e-3);
  EXPECT_NEAR(plastic.loading_force(1.9 * d) / f, std::min(2.5708, std::pow(1.9, 1.5)), 1e-3);
  EXPECT_NEAR(plastic.loading_force(0.5 * d) / f, std::pow(0.5, 1.5), 1e-12);
  EXPECT_NEAR(plastic.loading_force(50 * d) / f, 1.40 * std::pow(50, 1.263), 1e-6);
  plastic.take(10 * d, 0);
  const double residual = 10 * d * (1 - std::pow(10, -0.28)) * (1 - std::pow(10, -0.69));
  EXPECT_EQ(plastic.force(0.999 * residual, 0), 0);
  EXPECT_GT(plastic.force(1.01 * residual, 0), 0);
  EXPECT_LT(plastic.force(9 * d, 0), plastic.loading_force(9 * d));
}

TEST(ConcealedTruth_analytic, a_held_load_creeps_by_its_share_with_its_time_constant) {
  const double share = 0.2, tau = 3, load = sphere.force(10e-9);
  CreepingTruth creeping(sphere, share, tau);
  const auto approach_at = [&](double time) {  // under the load, by bisection
    double low = 5e-9, high = 20e-9;
    for (int i = 0; i < 60; ++i)
      (creeping.force((low + high) / 2, time) < load ? low : high) = (low + high) / 2;
    return (low + high) / 2;
  };
  constexpr double step = 0.05;
  for (double t = step; t <= 12; t += step) {
    const double d = approach_at(step);
    creeping.take(d, step);
    EXPECT_NEAR(d / 10e-9, 1 + share * (1 - std::exp(-t / tau)), 1e-6);
  }
}

TEST(ConcealedTruth_analytic, a_body_that_relaxes_goes_from_hertz_to_what_is_left_of_it) {
  constexpr double share = 0.4, tau = 5, d = 10e-9;
  const double hertz = Hertz{E, R}.force(d);
  RelaxingSphere relaxing(sphere, share, tau, 20e-9);
  EXPECT_NEAR(relaxing.force(d, 0) / hertz, 1, 2e-3);
  relaxing.take(d, 0);
  for (const double time : {0.5, 3.0, 20.0})
    EXPECT_NEAR(relaxing.force(d, time) / hertz, 1 - share + share * std::exp(-time / tau), 2e-3) << time;
  relaxing.take(d, 3);
  EXPECT_EQ(relaxing.force(0, 1e-6), 0);  // its surface has not come back
}

/// The hereditary integral (Lee & Radok 1960; Ting 1966), which the row of springs never takes.
TEST(ConcealedTruth_other_code, a_body_that_relaxes_is_that_of_ting_there_and_back) {
  constexpr double share = 0.5, tau = 4, deepest = 10e-9;
  RelaxingSphere row(sphere, share, tau, 1.5 * deepest);
  RelaxingContact ting({E, R}, RelaxingModulus{RelaxingPart{share, tau}});
  constexpr int steps = 400;
  constexpr double step = 10.0 / steps;
  const double largest = Hertz{E, R}.force(deepest);
  ting.begin_step(0), ting.accept(0), row.take(0, 0);
  for (int i = 1; i <= 2 * steps; ++i) {
    const double d = deepest * (i <= steps ? i : 2 * steps - i) / steps;
    ting.begin_step(step);
    EXPECT_NEAR(row.force(d, step), ting.force(d), 5e-3 * largest) << i;
    ting.accept(d), row.take(d, step);
  }
}

TEST(ConcealedTruth_analytic, a_bridge_forms_at_touch_and_pulls_to_where_it_ruptures) {
  constexpr double pull = 4e-6, rupture = 4e-9;
  const MaugisDugdale maugis{E, R, pull / (2 * pi * R), pull / (2 * pi * R * rupture)};
  BridgedSphere bridge(sphere, pull, rupture);
  EXPECT_EQ(bridge.force(-1e-9, 0), 0);  // there is none before they touch
  bridge.take(-1e-9, 0);
  bridge.take(2e-9, 0);
  for (const double d : {0.5e-9, 2e-9, 5e-9})
    EXPECT_DOUBLE_EQ(bridge.force(d, 0), maugis.advance({}, d).force) << d;
  // Derjaguin's, and what the bodies are drawn out by 0.4 nm over the ring.
  for (const double gap : {0.5e-9, 2e-9, 3.9e-9})
    EXPECT_NEAR(bridge.force(-gap, 0), -pull * (1 - gap / rupture), 0.03 * pull) << gap;
  bridge.take(-4.1e-9, 0);
  EXPECT_EQ(bridge.force(-2e-9, 0), 0);
}

TEST(ConcealedTruth_other_code, masings_loop_is_that_of_mindlin_and_deresiewicz) {
  const Hertz hertz{E, R};
  const double load = 1e-3, mu = 0.4, G = 11.7989e9, a = hertz.contact_radius(load);
  MindlinDeresiewicz law;
  law.sliding_modulus = G;
  law.radius = R;
  law.friction.coefficient = mu;
  MasingContact masing(8 * G * a, mu * load);
  const NormalState normal{hertz.approach(load), load, a, hertz.normal_stiffness(load), true};
  SlidingHistory history = law.advance({}, normal, Eigen::Vector3d::Zero());  // the load comes first
  double x = 0;
  // Small loops, a larger one, gross sliding and back, inner loops: memory and forgetting.
  for (const double turn : {5e-9, 1e-9, 4e-9, -9e-9, 9e-9, 0., 30e-9, 20e-9, 25e-9, -30e-9, 3e-9, -8e-9}) {
    for (int i = 1; i <= 40; ++i) {
      const double next = x + (turn - x) / (41 - i), shift = next - x;
      x = next;
      history = law.advance(history, normal, Eigen::Vector3d(shift, 0, 0));
      EXPECT_NEAR(masing.force(x) / (mu * load), history.spring.resistance.x() / (mu * load), 2e-3) << x;
    }
  }
}

TEST(ConcealedTruth_analytic, noise_has_its_standard_deviation_and_correlation) {
  Random random(5);
  std::vector<double> signal(40000, 0.0);
  InstrumentNoise noise;
  noise.sd = 2;
  noise.correlated_share = 0.5;
  noise.add_to(signal, random);
  double square = 0, next = 0;
  for (std::size_t i = 1; i < signal.size(); ++i)
    square += signal[i] * signal[i], next += signal[i] * signal[i - 1];
  EXPECT_NEAR(std::sqrt(square / signal.size()), 2, 0.03);
  EXPECT_NEAR(next / square, 0.5 * std::exp(-1.0 / 3), 0.03);
}

}  // namespace
}  // namespace asperity::hidden
