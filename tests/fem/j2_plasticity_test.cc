// The material law at a point, driven by strain paths with known answers.
#include "fem/materials/j2_plasticity.h"

#include <gtest/gtest.h>

#include <random>

#include "core/csv.h"
#include "fem/materials/hardening/linear_and_voce.h"
#include "tests/fem/support/material_point.h"
#include "tests/support/shared_files.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity::fem;
using namespace asperity::test::material_point;
using asperity::test::Largest;
using asperity::test::Verified;

TEST(J2_analytic, below_yield_stress_is_elastic) {
  Point p(material());
  EXPECT_FALSE(p.stretch_to(0.999 * Y / (3 * p.law.shear_modulus)));
  EXPECT_NEAR(p.uniaxial_stress(), 0.999 * Y, 1e-9 * Y);
  EXPECT_EQ(p.alpha(), 0);
}

TEST(J2_analytic, perfectly_plastic_bar_stays_at_yield_stress) {
  Point p(material());
  for (int i = 1; i <= 40; ++i) p.stretch_to(i * 0.005);
  EXPECT_TRUE(
      at_a_point("perfectly plastic bar at 20 %: stress", "Y").below(p.uniaxial_stress() / Y - 1, 1e-12));
  EXPECT_NEAR(p.alpha(), 0.2 - Y / (3 * p.law.shear_modulus), 1e-12);
}

TEST(J2_analytic, perfectly_plastic_shear_stays_at_yield_over_root_three) {
  Point p(material());
  for (int i = 1; i <= 10; ++i) p.strain_to({0, 0, 0, 0, 0.02 * i, 0});
  EXPECT_TRUE(at_a_point("perfectly plastic shear: stress", "Y/3^(1/2)")
                  .below(p.stress[4][0] / Y - 1 / std::sqrt(3.0), 1e-12, "Y"));
  // Plastic shear 2 e_p / sqrt(3) is the equivalent strain.
  EXPECT_NEAR(p.alpha(), 2 / std::sqrt(3.0) * (0.2 - Y / std::sqrt(3.0) / (2 * p.law.shear_modulus)), 1e-12);
}

TEST(J2_analytic, linear_hardening_follows_sigma_equals_Y_plus_H_alpha) {
  J2Material m = material();
  constexpr double modulus = 5e9;
  m.hardening = std::make_shared<LinearAndVoce>(modulus);
  Largest stress;
  for (const double plastic : {0.001, 0.01, 0.1}) {
    Point p(m);
    const double expected = Y + modulus * plastic;
    p.stretch_to(axial_deviator(m, expected, plastic));
    stress.count((p.uniaxial_stress() - expected) / Y);
    EXPECT_NEAR(p.alpha(), plastic, 1e-12);
  }
  EXPECT_TRUE(at_a_point("linear hardening: stress at plastic strains of 0.1 to 10 %", "Y + H alpha")
                  .below(stress, 1e-12, "Y"));
}

TEST(J2_analytic, voce_hardening_saturates_exponentially) {
  J2Material m = material();
  constexpr double saturation = 2e9, rate = 25;
  m.hardening = std::make_shared<LinearAndVoce>(0, saturation, rate);
  Largest stress;
  for (const double plastic : {0.001, 0.01, 0.1, 0.5}) {
    Point p(m);
    const double expected = Y + saturation * (1 - std::exp(-rate * plastic));
    p.stretch_to(axial_deviator(m, expected, plastic));
    stress.count((p.uniaxial_stress() - expected) / Y);
    EXPECT_NEAR(p.alpha(), plastic, 1e-11);
  }
  EXPECT_TRUE(at_a_point("Voce's hardening: stress at plastic strains of 0.1 to 50 %", "Voce (1955)")
                  .below(stress, 1e-11, "Y"));
}

TEST(J2_analytic, proportional_loading_does_not_depend_on_the_number_of_steps) {
  J2Material m = material();
  m.hardening = std::make_shared<LinearAndVoce>(1e9, 1e9, 10), m.kinematic_modulus = 2e9;
  Point once(m), often(m);
  once.stretch_to(0.3);
  for (int i = 1; i <= 300; ++i) often.stretch_to(i * 0.001);
  EXPECT_NEAR(often.uniaxial_stress(), once.uniaxial_stress(), 1e-9 * Y);
  EXPECT_NEAR(often.alpha(), once.alpha(), 1e-9);
}

/// Stress at which a bar pulled to `plastic` strain yields in reverse, by bisection on the reversed strain.
double reverse_yield(const J2Material& m, double plastic) {
  Point loaded(m);
  const double top = m.flow_stress(plastic) + m.kinematic_modulus * plastic;
  loaded.stretch_to(axial_deviator(m, top, plastic));
  EXPECT_NEAR(loaded.uniaxial_stress(), top, 1e-10 * Y);
  double elastic = 0, yielding = 4 * top / (3 * m.shear_modulus);
  for (int i = 0; i < 60; ++i) {
    const double unload = 0.5 * (elastic + yielding);
    Point p = loaded;
    (p.stretch_to(axial_deviator(m, top, plastic) - unload) ? yielding : elastic) = unload;
  }
  Point p = loaded;
  p.stretch_to(axial_deviator(m, top, plastic) - elastic);
  return p.uniaxial_stress();
}

TEST(J2_analytic, kinematic_hardening_yields_in_reverse_two_Y_below_the_largest_stress) {
  J2Material m = material();
  m.kinematic_modulus = 8e9;
  Largest stress;
  for (const double plastic : {0.01, 0.1}) {
    const double top = Y + m.kinematic_modulus * plastic;
    stress.count((reverse_yield(m, plastic) - (top - 2 * Y)) / Y);
  }
  EXPECT_TRUE(
      at_a_point("kinematic hardening: stress of reverse yield", "sigma_max - 2 Y").below(stress, 1e-9, "Y"));
}

TEST(J2_analytic, isotropic_hardening_yields_in_reverse_at_minus_the_largest_stress) {
  J2Material m = material();
  constexpr double modulus = 8e9;
  m.hardening = std::make_shared<LinearAndVoce>(modulus);
  const double error = (reverse_yield(m, 0.05) + Y + modulus * 0.05) / Y;
  EXPECT_TRUE(
      at_a_point("isotropic hardening: stress of reverse yield", "-sigma_max").below(error, 1e-9, "Y"));
}

/// Softens by as much as the elastic stress falls with the strain: beyond yield no stress is on the surface.
TEST(J2_behaviour, a_return_map_without_an_answer_says_so_and_leaves_the_state) {
  J2Material m = material();
  m.hardening = std::make_shared<LinearAndVoce>(-3 * m.shear_modulus, 0.01 * Y, 10);
  Point point(m);
  EXPECT_FALSE(point.stretch_to(0.9 * Y / (3 * m.shear_modulus)));
  EXPECT_THROW(point.stretch_to(1.5 * Y / (3 * m.shear_modulus)), StepFailure);
  EXPECT_EQ(point.alpha(), 0);
  // Rounding of a trial stress far beyond yield is no failure.
  m.hardening = std::make_shared<LinearAndVoce>(0, 0.01 * Y, 10);
  Point far(m);
  EXPECT_TRUE(far.stretch_to(1e6 * Y / (3 * m.shear_modulus)));
  EXPECT_NEAR(far.uniaxial_stress() / (1.01 * Y), 1, 1e-9);
}

/// Angle between s and the strain rate after a strain at first orthogonal to s: Krieg & Krieg (1977).
double angle_after(double strain, int steps) {
  Point p(material());
  const double radius = std::sqrt(2.0 / 3.0) * Y, unit = radius / (2 * p.law.shear_modulus);
  const double s0 = 1 / std::sqrt(1.5);  // uniaxial direction of unit norm
  const Strain start{s0, -0.5 * s0, -0.5 * s0, 0, 0, 0}, rate{0, 0, 0, 1 / std::sqrt(2.0), 0, 0};
  for (int i = 0; i <= steps; ++i) {
    Strain e;
    for (int c = 0; c < 6; ++c) e[c] = unit * (start[c] + rate[c] * strain * i / steps);
    p.strain_to(e);
  }
  const Strain s = p.s();
  EXPECT_NEAR(norm(s), radius, 1e-9 * radius);
  return std::acos(contract(s, rate) / norm(s));
}

TEST(J2_analytic, radial_return_converges_to_krieg_and_krieg_on_a_turning_path) {
  Largest fine, ratio;
  for (const double strain : {0.5, 1.0, 2.0}) {
    const double exact = 2 * std::atan(std::exp(-strain));
    double before = 0;
    for (const int steps : {50, 100, 200, 400}) {
      const double error = std::abs(angle_after(strain, steps) - exact);
      if (before > 0) ratio.count(error / before);
      before = error;
    }
    fine.count(angle_after(strain, 4000) / exact - 1);
  }
  const auto verified = [](const char* what) { return at_a_point(what, "Krieg & Krieg (1977)"); };
  EXPECT_TRUE(verified("turning path to 2G e/R 0.5, 1, 2 in 4000 steps: angle of the stress")
                  .within(1 + fine, 1, 1e-3));
  EXPECT_TRUE(verified("the same: its error over that of half the steps, 50 to 400 (first order)")
                  .below(ratio, 0.52));
}

TEST(J2_analytic, energy_stored_by_hardening_is_the_integral_of_the_flow_stress_above_the_first) {
  for (const double rate : {0.0, 40.0})
    for (const double saturation : {0.0, 0.5e9}) {
      J2Material m = J2Material::elastic(71e9, 0.17);
      m.yield_stress = 1e9, m.hardening = std::make_shared<LinearAndVoce>(2e9, saturation, rate);
      for (const double alpha : {0.0, 0.01, 0.1}) {
        constexpr int n = 2000;
        double integral = 0;
        for (int i = 0; i < n; ++i)
          integral += (m.flow_stress((i + 0.5) * alpha / n) - m.yield_stress) * alpha / n;
        EXPECT_NEAR(m.isotropic_energy(alpha), integral, 1e-6 * integral + 1e-9)
            << rate << " " << saturation << " " << alpha;
      }
    }
}

TEST(J2_other_code, krieg_and_krieg_angles_agree_with_the_stored_ones) {
  const auto path = asperity::test::reference_table("08_fe_verification.csv");
  const auto table = asperity::read_csv(path);
  int found = 0;
  Largest error;
  for (const auto& row : table.rows) {
    if (row[table.column("id")].rfind("F-KK-", 0) != 0) continue;
    const double strain = std::stod(row[table.column("id")].substr(5)),
                 degrees = std::stod(row[table.column("value")]);
    error.count(angle_after(strain, 4000) * 180 / M_PI / degrees - 1);
    ++found;
  }
  EXPECT_TRUE(
      at_a_point("turning path in 4000 steps: angle of the stress", "another program's return mapping")
          .within(1 + error, 1, 1e-3));
  EXPECT_EQ(found, 3);
}

Strain random_deviator(std::mt19937& random, double size) {
  std::normal_distribution<double> normal;
  Strain e;
  for (auto& c : e) c = size * normal(random);
  const double mean = (e[0] + e[1] + e[2]) / 3;
  for (int c = 0; c < 3; ++c) e[c] -= mean;
  return e;
}

J2Material hardening_material() {
  J2Material m = material();
  m.hardening = std::make_shared<LinearAndVoce>(4e9, 1e9, 30), m.kinematic_modulus = 3e9;
  return m;
}

TEST(J2_analytic, consistent_tangent_is_the_derivative_of_the_stress) {
  std::mt19937 random(7);
  int yielding = 0;
  Largest error;
  for (int trial = 0; trial < 50; ++trial) {
    Point before(trial % 2 ? hardening_material() : material());
    before.strain_to(random_deviator(random, 0.03));
    const Strain e = random_deviator(random, 0.05), direction = random_deviator(random, 1.0);
    Point here = before;
    yielding += here.strain_to(e);
    const double h = 1e-6;
    Strain forward = e, backward = e;
    for (int c = 0; c < 6; ++c) forward[c] += h * direction[c], backward[c] -= h * direction[c];
    Point ahead = before, behind = before;
    ahead.strain_to(forward);
    behind.strain_to(backward);
    Strain normal;
    for (int c = 0; c < 6; ++c) normal[c] = here.tangent.normal[c][0];
    const double along = here.tangent.theta_bar[0] * contract(normal, direction);
    for (int c = 0; c < 6; ++c) {
      const double tangent =
          2 * here.law.shear_modulus * (here.tangent.theta[0] * direction[c] - along * normal[c]);
      const double difference = (ahead.stress[c][0] - behind.stress[c][0]) / (2 * h);
      error.count((tangent - difference) / (2 * here.law.shear_modulus));
    }
  }
  EXPECT_TRUE(at_a_point("consistent tangent, 50 random states", "central differences of the stress")
                  .below(error, 1e-5, "of 2G"));
  EXPECT_GT(yielding, 40);
}

TEST(J2_analytic, dissipation_is_yield_stress_times_plastic_strain_and_never_negative) {
  // s : de_p - beta : de_p - (sigma_y - Y) d(alpha) = Y d(alpha) for associated flow at the end of each step.
  std::mt19937 random(3);
  Point p(hardening_material());
  Strain e{};
  Largest error;
  for (int step = 0; step < 500; ++step) {
    const Strain change = random_deviator(random, 0.01);
    for (int c = 0; c < 6; ++c) e[c] += change[c];
    const auto before = p.state;
    p.strain_to(e);
    Strain flow, driving;
    for (int c = 0; c < 6; ++c) {
      flow[c] = p.state.strain[c][0] - before.strain[c][0];
      driving[c] = p.stress[c][0] - p.law.kinematic_modulus * 2 / 3 * p.state.strain[c][0];
    }
    const double increment = p.alpha() - before.alpha[0];
    const double dissipation = contract(driving, flow) - (p.law.flow_stress(p.alpha()) - Y) * increment;
    ASSERT_GE(increment, 0);
    ASSERT_GE(dissipation, 0);
    error.count((dissipation - Y * increment) / (Y * std::max(increment, 1e-6)));
  }
  EXPECT_TRUE(at_a_point("dissipation on a random path, never negative", "Y d(alpha)").below(error, 1e-9));
  EXPECT_GT(p.alpha(), 0.1);
}

TEST(J2_analytic, lanes_with_different_materials_do_not_disturb_each_other) {
  const J2Material soft = hardening_material(), hard = J2Material::elastic(179e9, 0.25);
  const J2Material* lane[lanes];
  V shear;
  SymmetricTensor<V> e{};
  for (int l = 0; l < lanes; ++l) {
    lane[l] = l % 2 ? &hard : &soft;
    shear[l] = lane[l]->shear_modulus;
    e[3][l] = 0.1 * (l + 1);
  }
  PlasticState<V> state{};
  SymmetricTensor<V> stress;
  J2Tangent<V> tangent;
  ASSERT_TRUE(return_map(lane, shear, e, state, stress, tangent));
  for (int l = 0; l < lanes; ++l) {
    if (l % 2) {
      EXPECT_EQ(stress[3][l], 2 * hard.shear_modulus * e[3][l]);
      EXPECT_EQ(state.alpha[l], 0);
    } else {
      Point alone(soft);
      alone.strain_to({0, 0, 0, e[3][l], 0, 0});
      EXPECT_EQ(stress[3][l], alone.stress[3][0]);
    }
  }
}

}  // namespace
