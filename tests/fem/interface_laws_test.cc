// The laws at a point of the interface, each on its own.
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "fem/interface/adhesion_law.h"
#include "fem/interface/friction/capped_coulomb.h"
#include "fem/interface/friction/coulomb.h"
#include "fem/interface/friction/shear_strength.h"
#include "fem/interface/slip.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;
using namespace asperity::fem;

TEST(FrictionLaws_analytic, limit_the_shear_as_their_equations_say) {
  const auto limit = [](const FrictionLaw& law, double pressure) {
    return law.initial_limit(pressure).stress;
  };
  EXPECT_DOUBLE_EQ(limit(Coulomb(0.3), 2e9), 0.6e9);
  EXPECT_DOUBLE_EQ(limit(Coulomb(0.3), 0), 0);
  EXPECT_DOUBLE_EQ(limit(ShearStrength(0.5e9), 0.25e9), 0.5e9);
  EXPECT_DOUBLE_EQ(limit(ShearStrength(0.5e9), 0.1e9), 0.2e9);  // at the edge
  EXPECT_DOUBLE_EQ(limit(ShearStrength(0.5e9), 0), 0);
  EXPECT_DOUBLE_EQ(limit(CappedCoulomb(0.3, 0.5e9), 1e9), 0.3e9);
  EXPECT_DOUBLE_EQ(limit(CappedCoulomb(0.3, 0.5e9), 2e9), 0.5e9);
}

/// Under Hertz' pressure p0 (1 - r^2/a^2)^(1/2) the edge takes (tau/p0)^2/12 of tau pi a^2, integrated by
/// hand.
TEST(FrictionLaws_analytic, the_edge_of_a_Hertzian_contact_takes_little_of_its_shear_strength) {
  constexpr double peak = 1e9;
  constexpr int rings = 20000;  // of equal area
  for (const double strength : {0.1e9, 0.3e9, 1e9}) {
    double sum = 0;
    for (int i = 0; i < rings; ++i)
      sum += ShearStrength(strength).initial_limit(peak * std::sqrt(1 - (i + 0.5) / rings)).stress / rings;
    EXPECT_NEAR(1 - sum / strength, std::pow(strength / peak, 2) / 12, 1e-5) << strength;
  }
}

TEST(FrictionLaws_behaviour, are_chosen_by_the_entries_of_a_case) {
  EXPECT_EQ(make_friction_law({}), nullptr);
  const auto limit = [](double coefficient, double strength) {
    InterfaceInput input;
    input.parameters = {{"Friction coefficient", coefficient}, {"Shear strength", strength}};
    return make_friction_law(input)->initial_limit(10).stress;
  };
  EXPECT_EQ(limit(0.5, 0), 5);
  EXPECT_EQ(limit(0, 3), 3);
  EXPECT_EQ(limit(0.5, 3), 3);
  EXPECT_EQ(limit(0.5, 30), 5);
  for (const auto& law : friction_laws())
    EXPECT_FALSE(law.equation.empty() || law.source.empty() || law.parameters.empty() ||
                 law.validity.empty());
}

/// Of all that a law takes; a cap of Coulomb's limit lies at a pressure of 1 GPa.
LawValues some_values(const LawDeclaration& law) {
  LawValues values;
  for (const auto& parameter : law.parameters) {
    const double unit = parameter.dimension == Dimension::pressure ? 1e9
                        : parameter.dimension == Dimension::length ? 1e-9
                        : parameter.dimension == Dimension::speed  ? 1e-6
                                                                   : 1;
    values[parameter.entry] = 0.3 * unit;
  }
  return values;
}

TEST(FrictionLaws_behaviour, each_is_made_from_the_entries_that_it_declares) {
  for (const auto& law : friction_laws()) {
    InterfaceInput input;
    input.parameters = some_values(law);
    ASSERT_NE(make_friction_law(input), nullptr) << law.name;
    EXPECT_EQ(make_friction_law(input)->initial_limit(2e9).stress,
              law.make(input.parameters)->initial_limit(2e9).stress)
        << law.name;
  }
}

TEST(FrictionLaws_analytic, slope_of_each_is_the_derivative_of_its_limit_by_the_pressure) {
  test::Largest error;
  for (const auto& entry : friction_laws()) {
    const auto law = entry.make(some_values(entry));
    for (const double pressure : {0.4e9, 0.9e9, 1.1e9, 3e9}) {
      const double step = 1e-5 * pressure;
      const double above = law->initial_limit(pressure + step).stress,
                   below = law->initial_limit(pressure - step).stress;
      error.count(law->initial_limit(pressure).slope - (above - below) / (2 * step));
    }
  }
  EXPECT_TRUE(
      (test::Verified{"Sliding", "slope of each friction law's limit by the pressure", "finite differences"}
           .below(error, 1e-9)));
}

TEST(Slip_analytic, sticks_below_the_limit_and_slips_along_the_trial_beyond_it) {
  const Shear stuck = return_to_limit({3, 4}, 6);
  EXPECT_FALSE(stuck.slips);
  EXPECT_EQ(stuck.traction[0], 3);
  const Shear slipping = return_to_limit({3, 4}, 2);
  EXPECT_TRUE(slipping.slips);
  EXPECT_NEAR(slipping.traction[0], 1.2, 1e-15);
  EXPECT_NEAR(slipping.traction[1], 1.6, 1e-15);
  const Shear open = return_to_limit({0, 0}, 0);
  EXPECT_EQ(open.xx + open.yy, 0);
}

TEST(Slip_analytic, tangent_is_the_derivative_of_the_traction_and_never_negative) {
  const double step = 1e-6;
  test::Largest error;
  for (const PlaneVector trial : {PlaneVector{3, 4}, PlaneVector{-1, 0.2}, PlaneVector{0.1, -7}})
    for (const double limit : {0.5, 2.0, 100.0}) {
      const Shear here = return_to_limit(trial, limit);
      const auto derivative = [&](int i, int j) {
        PlaneVector up = trial, down = trial;
        up[j] += step, down[j] -= step;
        return (return_to_limit(up, limit).traction[i] - return_to_limit(down, limit).traction[i]) /
               (2 * step);
      };
      error.count(here.xx - derivative(0, 0));
      error.count(here.xy - derivative(0, 1));
      error.count(here.xy - derivative(1, 0));
      error.count(here.yy - derivative(1, 1));
      EXPECT_GE(here.xx * here.yy - here.xy * here.xy, -1e-12);
      EXPECT_GE(here.xx, 0);
    }
  const test::Verified verified{"Sliding", "tangent of the traction that slips, never negative",
                                "finite differences"};
  EXPECT_TRUE(verified.below(error, 1e-8, "of the penalty"));
}

/// Shear of a law under its pressure: of each there is, below, at and beyond its limit.
TEST(FrictionLaws_analytic, tangent_of_each_is_the_derivative_of_its_shear) {
  constexpr double pressure = 2e9, step = 1e3;
  test::Largest size, tangent;
  for (const auto& entry : friction_laws()) {
    const double limit = entry.make(some_values(entry))->initial_limit(pressure).stress;
    for (const double share : {0.5, 1.5, 4.0}) {
      const PlaneVector trial{0.8 * share * limit, -0.6 * share * limit};
      const Shear here = return_to_limit(trial, limit);
      EXPECT_EQ(here.slips, share > 1) << entry.name;
      size.count(std::hypot(here.traction[0], here.traction[1]) / limit - std::min(1.0, share));
      for (int j = 0; j < 2; ++j) {
        PlaneVector up = trial, down = trial;
        up[j] += step, down[j] -= step;
        const auto one = return_to_limit(up, limit), other = return_to_limit(down, limit);
        tangent.count((j == 0 ? here.xx : here.xy) - (one.traction[0] - other.traction[0]) / (2 * step));
        tangent.count((j == 0 ? here.xy : here.yy) - (one.traction[1] - other.traction[1]) / (2 * step));
      }
    }
  }
  const auto verified = [](const char* what, const char* source) {
    return test::Verified{"Sliding", what, source};
  };
  EXPECT_TRUE(verified("shear of each friction law below, at and beyond its limit", "its equation")
                  .below(size, 1e-12, "of the limit"));
  EXPECT_TRUE(verified("tangent of each friction law's shear", "finite differences")
                  .below(tangent, 1e-6, "of the penalty"));
}

TEST(Slip_analytic, secant_takes_the_trial_traction_to_the_traction_and_bounds_the_tangent) {
  for (const PlaneVector trial : {PlaneVector{3, 4}, PlaneVector{-1, 0.2}, PlaneVector{0.1, -7}})
    for (const double limit : {0.5, 2.0, 100.0}) {
      const Shear shear = return_to_limit(trial, limit);
      for (int c = 0; c < 2; ++c) EXPECT_NEAR(shear.secant() * trial[c], shear.traction[c], 1e-14);
      // secant I - tangent has no negative direction.
      EXPECT_GE(shear.secant() - shear.xx, -1e-15);
      EXPECT_GE((shear.secant() - shear.xx) * (shear.secant() - shear.yy) - shear.xy * shear.xy, -1e-15);
    }
}

TEST(Slip_analytic, of_a_converged_step_is_against_its_traction) {
  // Multipliers at their fixed point, t = lambda: what slips moves against t, what sticks does not move.
  for (double angle = 0; angle < 6.3; angle += 0.1) {
    const PlaneVector t{0.8 * std::cos(angle), 0.8 * std::sin(angle)}, slip{-3 * t[0], -3 * t[1]};
    const Shear shear = return_to_limit({t[0] - slip[0], t[1] - slip[1]}, 0.8);
    EXPECT_NEAR(shear.traction[0], t[0], 1e-15);
    EXPECT_NEAR(shear.traction[1], t[1], 1e-15);
    EXPECT_GT(-(shear.traction[0] * slip[0] + shear.traction[1] * slip[1]), 0);
  }
}

/// Of all that some law of attraction takes: a range of 0.6 nm, humid air, patches with films.
LawValues attracting_values(const LawDeclaration& law) {
  return with_defaults(law.parameters, {{"Adhesion range", 0.6e-9},
                                        {"Relative humidity", 0.3},
                                        {"Patch potential", 0.5},
                                        {"Patch size", 50e-9},
                                        {"Insulating film", 0.6e-9}});
}

TEST(AdhesionLaws_analytic, the_integral_of_attraction_is_the_work_of_adhesion) {
  constexpr double work = 0.08;
  test::Largest error;
  for (const auto& entry : fem::adhesion_laws()) {
    const auto law = entry.make(work, attracting_values(entry));
    const int n = 200000;
    const double step = law->range() / n;
    double integral = 0;
    for (int k = 0; k < n; ++k) integral += law->at((k + 0.5) * step).stress * step;
    error.count((integral + law->at(law->range()).work) / work - 1);
    EXPECT_NEAR(law->at(0).work, work, 1e-12 * work) << entry.name;
    EXPECT_LT(law->at(law->range()).work, 2e-4 * work) << entry.name;
  }
  EXPECT_TRUE((test::Verified{"Adhesion", "integral of each law's attraction", "work of adhesion"}.below(
      error, 1e-4)));
}

TEST(AdhesionLaws_analytic, slope_and_work_are_the_derivative_and_the_integral_of_stress) {
  test::Largest slope, stress;
  for (const auto& entry : fem::adhesion_laws()) {
    const auto law = entry.make(0.08, attracting_values(entry));
    for (const double gap : {0.1e-9, 0.5e-9, 0.59e-9, 0.7e-9, 2e-9}) {
      const double d = 1e-15;
      const auto here = law->at(gap), above = law->at(gap + d), below = law->at(gap - d);
      // Of what is nearly none, a pascal (per metre) is asked.
      slope.count(((above.stress - below.stress) / (2 * d) - here.slope) / (std::abs(here.slope) + 1e5));
      stress.count(((below.work - above.work) / (2 * d) - here.stress) / (here.stress + 1e5));
    }
  }
  const auto verified = [](const char* what) {
    return test::Verified{"Adhesion", what, "finite differences"};
  };
  EXPECT_TRUE(verified("slope of each law's attraction").below(slope, 1e-5));
  EXPECT_TRUE(verified("attraction of each law as slope of its work").below(stress, 1e-5));
}

TEST(AdhesionLaws_behaviour, an_unknown_name_is_refused_with_those_there_are) {
  try {
    fem::make_adhesion_law("glue", 0.1, {{"Adhesion range", 1e-9}});
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("dugdale"), std::string::npos);
  }
}

}  // namespace
