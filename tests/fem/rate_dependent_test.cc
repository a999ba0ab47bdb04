// Yield stresses that grow with the strain rate, at a material point.
#include "fem/materials/hardening/rate_dependent.h"

#include <gtest/gtest.h>

#include <functional>

#include "tests/fem/support/material_point.h"

namespace {

using namespace asperity::fem;
using namespace asperity::test::material_point;
using asperity::test::Largest;

/// Yields at a stress that grows with the rate (Bingham 1922).
struct ViscousYield : Hardening {
  static constexpr double viscosity = 5e9;
  FlowStress flow(const YieldingPoint& point) const override {
    return {point.initial + viscosity * point.increment / point.time.step, viscosity / point.time.step};
  }
  double stored_energy(double) const override { return 0; }
  bool is_linear() const override { return true; }
};

TEST(J2_analytic, a_viscous_yield_stress_follows_the_rate_of_each_step) {
  J2Material m = material();
  m.hardening = std::make_shared<ViscousYield>();
  Largest stress;
  double strain = 0, plastic = 0;
  Point p(m);
  for (const double step : {0.1, 1.0, 10.0}) {
    p.time = {0, step};
    strain += 0.1;
    p.stretch_to(strain);
    // 3 G (e - plastic) = Y + viscosity (plastic - before) / step.
    const double stiff = 3 * m.shear_modulus, viscous = ViscousYield::viscosity / step;
    plastic = (stiff * strain - Y + viscous * plastic) / (stiff + viscous);
    stress.count((p.uniaxial_stress() - stiff * (strain - plastic)) / Y);
  }
  EXPECT_TRUE(at_a_point("viscous yield stress: stress after steps of 0.1 to 10", "Bingham (1922)")
                  .below(stress, 1e-12, "Y"));
}

constexpr double strain_that_is_held = 1.3;  ///< over that of first yield

/// Overstress sigma/Y - 1 under a strain that yields at once and is held.
struct HeldStrain {
  double first = 0;  ///< right after loading [-]
  Largest error;     ///< beside what is expected of the first and of the time, up to an end [-]
};
HeldStrain relaxed(const RateDependent& law, double end,
                   const std::function<double(double first, double time)>& expected) {
  J2Material m = material();
  m.hardening = std::make_shared<RateDependent>(law);
  Point p(m);
  const double strain = strain_that_is_held * Y / (3 * m.shear_modulus);
  p.time = {0, 1e-9};  // at once, nearly
  p.stretch_to(strain);
  HeldStrain held;
  held.first = p.uniaxial_stress() / Y - 1;
  double now = 0;
  for (double step = 1e-6; now < end; step *= 1.02) {
    p.time = {0, step};
    p.stretch_to(strain);
    now += step;
    held.error.count(p.uniaxial_stress() / Y - 1 - expected(held.first, now));
  }
  return held;
}

/// Under a held strain d sigma/dt = -3 G d alpha/dt: with s = (sigma/Y - 1)/C, 1 - exp(-s) falls as exp(-k
/// t), k = 3 G/(Y C t0), and before that with the logarithm of time.
TEST(J2_analytic, a_yield_stress_that_follows_the_rate_relaxes_with_the_logarithm_of_time) {
  constexpr double sensitivity = 0.05, time = 100;
  const double k = 3 * material().shear_modulus / (Y * sensitivity * time);
  const HeldStrain held = relaxed({0, sensitivity, time}, 30 / k, [&](double first, double now) {
    return -sensitivity * std::log1p(std::expm1(-first / sensitivity) * std::exp(-k * now));
  });
  EXPECT_GT(held.first / sensitivity, 3);  // of the logarithm's range
  EXPECT_TRUE(at_a_point("yield stress that follows the rate: relaxation of a held strain",
                         "closed form, Johnson & Cook (1983), Camacho & Ortiz (1997)")
                  .below(held.error, 1e-3, "Y"));
}

/// With m = 1/2 and y = m (sigma/Y - 1)/C the rate is ((1 + y)^2 - 1)/t0, so that y' = -k (2 y + y^2).
TEST(J2_analytic, a_power_of_the_rate_relaxes_a_held_strain_as_its_closed_form) {
  constexpr double sensitivity = 0.02, time = 5, exponent = 0.5;
  const double k = exponent * 3 * material().shear_modulus / (sensitivity * Y * time);
  const HeldStrain held = relaxed({0, sensitivity, time, exponent}, 3 / k, [&](double first, double now) {
    const double y = exponent * first / sensitivity, left = y / (y + 2) * std::exp(-2 * k * now);
    return 2 * left / (1 - left) * sensitivity / exponent;
  });
  EXPECT_GT(exponent * held.first / sensitivity, 3);  // where the power rules
  EXPECT_TRUE(
      at_a_point("yield stress that follows a power of the rate: relaxation of a held strain", "closed form")
          .below(held.error / held.first, 1e-2, "of the overstress"));
}

TEST(J2_analytic, a_small_power_of_the_rate_is_the_logarithm) {
  for (const double alpha : {1e-4, 0.1}) {
    const YieldingPoint point{Y, alpha, alpha / 2, {0, 0.3}};
    const FlowStress power = RateDependent(1e9, 0.03, 1e4, 1e-7).flow(point),
                     logarithm = RateDependent(1e9, 0.03, 1e4).flow(point);
    EXPECT_NEAR(power.stress / logarithm.stress, 1, 1e-6);
    EXPECT_NEAR(power.slope / logarithm.slope, 1, 1e-5);
  }
}

TEST(J2_analytic, under_a_steady_rate_the_yield_stress_is_that_of_the_rate) {
  J2Material m = material();
  m.hardening = std::make_shared<RateDependent>(2e9, 0.03, 10);
  Point p(m);
  double strain = 0, before = 0;
  for (int i = 0; i < 60; ++i) {
    p.time = {0, 0.5};
    before = p.alpha();
    strain += 0.01;
    p.stretch_to(strain);
  }
  const double rate = (p.alpha() - before) / 0.5;
  EXPECT_NEAR(p.uniaxial_stress() / ((Y + 2e9 * p.alpha()) * (1 + 0.03 * std::log(1 + 10 * rate))), 1, 1e-10);
}

}  // namespace
