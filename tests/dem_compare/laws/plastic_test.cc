// Elasto-plastic normal laws against what their authors give in closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.h"
#include "dem_compare/laws/hertz_offset.h"
#include "dem_compare/laws/jkr.h"
#include "dem_compare/laws/law_registry.h"
#include "dem_compare/laws/luding.h"
#include "dem_compare/laws/thornton_ning.h"

namespace asperity {
namespace {

constexpr double modulus = 52.8684e9, radius = 8.5e-6, pressure = 9e9;
const ThorntonNing plastic{modulus, radius, pressure, 0};

/// Work from an impact: of loading and of unloading [J], by Simpson's rule on fine steps.
struct Work {
  double in = 0, out = 0, least_force = 0;
  NormalState last;
};
template <class Law>
Work cycle(const Law& law, double largest, int steps = 20000) {
  Work work;
  NormalState state;
  double force = 0;
  for (int i = 1; i <= steps; ++i) {
    state = law.advance(state, largest * i / steps);
    work.in += 0.5 * (force + state.force) * largest / steps;
    force = state.force;
  }
  for (int i = steps - 1; i >= -steps / 2; --i) {
    state = law.advance(state, largest * i / steps);
    work.out += 0.5 * (force + state.force) * largest / steps;
    work.least_force = std::min(work.least_force, state.force);
    force = state.force;
  }
  work.last = state;
  return work;
}

TEST(ThorntonNing_analytic, yields_where_the_pressure_in_the_middle_is_p_y) {
  const double a_y = M_PI * pressure * radius / (2 * modulus);
  EXPECT_NEAR(plastic.yield_radius(), a_y, 1e-12 * a_y);
  EXPECT_NEAR(plastic.yield_force(), 2.0 / 3 * M_PI * a_y * a_y * pressure, 1e-10 * plastic.yield_force());
  const HertzOffset hertz{modulus, radius, 0};
  const double below = 0.9 * plastic.yield_approach();
  EXPECT_NEAR(plastic.advance({}, below).force, hertz.advance({}, below).force, 1e-9 * plastic.yield_force());
  // The same pressure with adhesion, by its own formula.
  const ThorntonNing adhesive{modulus, radius, pressure, 1.0};
  const double a = adhesive.yield_radius();
  EXPECT_NEAR(2 * modulus * a / (M_PI * radius) - std::sqrt(2 * 1.0 * modulus / (M_PI * a)), pressure,
              1e-9 * pressure);
}

// Thornton 1997: e^2 = (6 sqrt(3)/5) [1 - (V_y/V)^2/6] [ (V_y/V)/((V_y/V) + 2 sqrt(6/5 -
// (V_y/V)^2/5)) ]^(1/2).
TEST(ThorntonNing_analytic, restitution_is_that_of_thorntons_closed_form) {
  const double delta_y = plastic.yield_approach(), of_yield = 0.4 * plastic.yield_force() * delta_y;
  for (const double over : {1.2, 2.0, 5.0, 15.0}) {
    const Work work = cycle(plastic, over * delta_y);
    const double ratio = std::sqrt(of_yield / work.in);  // V_y/V
    const double wanted = std::sqrt(6 * std::sqrt(3.0) / 5 * (1 - ratio * ratio / 6) *
                                    std::sqrt(ratio / (ratio + 2 * std::sqrt(1.2 - 0.2 * ratio * ratio))));
    EXPECT_NEAR(std::sqrt(work.out / work.in), wanted, 1e-4) << over;
  }
}

TEST(ThorntonNing_analytic, reloading_goes_back_along_the_unloading_line_to_where_it_yielded) {
  const double largest = 6 * plastic.yield_approach();
  NormalState state = plastic.advance({}, largest);
  const NormalState loaded = state;
  const double imprint = plastic.flattened(largest).imprint;
  EXPECT_GT(imprint, 0);
  state = plastic.advance(state, imprint * 0.99);
  EXPECT_EQ(state.force, 0);
  state = plastic.advance(state, largest);
  EXPECT_NEAR(state.force, loaded.force, 1e-9 * loaded.force);
  EXPECT_NEAR(state.contact_radius, loaded.contact_radius, 1e-9 * loaded.contact_radius);
  // Continuous where unloading begins.
  const NormalState just = plastic.advance(loaded, largest * (1 - 1e-9));
  EXPECT_NEAR(just.force, loaded.force, 1e-7 * loaded.force);
  EXPECT_NEAR(just.contact_radius, loaded.contact_radius, 1e-7 * loaded.contact_radius);
}

TEST(ThorntonNing_analytic, pull_off_grows_with_the_flattened_radius) {
  const ThorntonNing adhesive{modulus, radius, pressure, 0.5};
  const double largest = 6 * adhesive.yield_approach();
  const ThorntonNing::Flattened flat = adhesive.flattened(largest);
  EXPECT_GT(flat.law.radius, radius);
  const Work work = cycle(adhesive, largest);
  EXPECT_NEAR(-work.least_force / (1.5 * M_PI * 0.5 * flat.law.radius), 1, 2e-3);
  EXPECT_FALSE(work.last.touching);
  // Before yielding it is JKR.
  const Jkr jkr{modulus, radius, 0.5};
  const double small = 0.3 * adhesive.yield_approach();
  EXPECT_NEAR(adhesive.advance({}, small).force, jkr.advance({}, small).force, 1e-9 * plastic.yield_force());
}

constexpr double k1 = 1e4, kp = 4e4, kc = 2e4;

TEST(Luding_analytic, restitution_is_the_root_of_both_stiffnesses) {
  const Luding law{k1, kp, 0, 0, radius};
  const Work work = cycle(law, 5e-9);
  EXPECT_NEAR(work.out / work.in, k1 / kp, 1e-6);
  const double full = 10e-9;  // half way to the full approach: k2 lies half way
  const Work partly = cycle(Luding{k1, kp, 0, full, radius}, full / 2);
  EXPECT_NEAR(partly.out / partly.in, k1 / (0.5 * (k1 + kp)), 1e-6);
}

// Luding 2008: f_min = -k_c delta_min, delta_min = (k2 - k1)/(k2 + k_c) delta_max.
TEST(Luding_analytic, strongest_pull_is_that_of_the_largest_approach) {
  const double largest = 5e-9;
  const Work work = cycle(Luding{k1, kp, kc, 0, radius}, largest);
  EXPECT_NEAR(work.least_force, -kc * (kp - k1) / (kp + kc) * largest, 1e-3 * kc * largest);
  EXPECT_FALSE(work.last.touching);
}

TEST(Luding_analytic, reloading_from_the_adhesive_branch_comes_back_to_it) {
  for (const double full : {0.0, 20e-9}) {
    const Luding law{k1, kp, kc, full, radius};
    NormalState state = law.advance({}, 5e-9);
    const double k2 = law.unloading_stiffness_at(5e-9), deep = 0.5 * (k2 - k1) / (k2 + kc) * 5e-9;
    state = law.advance(state, deep);
    EXPECT_NEAR(state.force, -kc * deep, 1e-12);
    const double slope = law.unloading_stiffness_at(state.largest_approach);
    const NormalState up = law.advance(state, deep * 1.01);
    EXPECT_NEAR(up.force, state.force + slope * 0.01 * deep, 1e-9 * kc * deep) << full;
    EXPECT_NEAR(law.advance(up, deep).force, state.force, 1e-9 * kc * deep);
  }
}

TEST(PlasticLaws_regression, are_made_by_name_and_refuse_what_they_cannot_be) {
  const ReducedLaw law = make_reduced_law(
      "thornton_ning", {{"reduced_modulus", modulus}, {"radius", radius}, {"yield_pressure", pressure}});
  EXPECT_TRUE(std::holds_alternative<NormalLaw>(law));
  EXPECT_THROW(make_reduced_law("thornton_ning", {{"reduced_modulus", modulus}, {"radius", radius}}),
               InputError);
  EXPECT_THROW(make_reduced_law(
                   "luding", {{"loading_stiffness", 0.0}, {"unloading_stiffness", kp}, {"radius", radius}}),
               InputError);
}

}  // namespace
}  // namespace asperity
