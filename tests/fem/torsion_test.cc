// A sphere pressed and then spun about the normal: Reissner & Sagoci (1944), Lubkin (1951), Farkas et al.
// (2003).
#include <gtest/gtest.h>

#include "core/csv.h"
#include "tests/fem/support/frictional_contact.h"
#include "tests/support/shared_files.h"
#include "tests/support/verification.h"

namespace {

using asperity::test::FrictionalContact;

double linear_between(const std::vector<double>& x, const std::vector<double>& y, double at) {
  for (std::size_t i = 1; i < x.size(); ++i)
    if ((x[i - 1] <= at) != (x[i] <= at))
      return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
  ADD_FAILURE() << "the table does not reach " << at;
  return 0;
}

TEST(Torsion_analytic, stiffness_without_slip_converges_to_16_thirds_G_a_cubed) {
  double last = 1;
  for (const double cells : {8.0, 18.0}) {
    asperity::test::FrictionalContactOptions o;
    o.cells_per_radius = cells;
    FrictionalContact contact(o);
    const double expected = 16.0 / 3 * contact.system.torsion_modulus() * std::pow(contact.contact_radius, 3);
    const double error = contact.solver.torsion_stiffness(contact.state) / expected - 1;
    const asperity::test::Verified verified{"Torsion",
                                            "stiffness without slip, a/h " +
                                                std::to_string(std::lround(cells)) +
                                                (cells < 12 ? " (2 % wanted, which finer meshes meet)" : ""),
                                            "16/3 G a^3, Reissner & Sagoci (1944)"};
    EXPECT_TRUE(verified.within(1 + error, 1, cells < 12 ? 0.03 : 0.02));  // first order in the spacing
    EXPECT_LT(std::abs(error), std::abs(last));
    last = error;
  }
}

/// Borosilicate on silicon: what both bodies turn and shift adds up, 1/G1 + 1/G2 and (2 - nu1)/G1 + (2 -
/// nu2)/G2. Pressed without friction, which would make the contact smaller (Spence).
TEST(Torsion_analytic, and_lateral_stiffness_without_slip_of_unlike_bodies_have_both_compliances) {
  asperity::test::FrictionalContactOptions o;
  o.cells_per_radius = 18, o.friction = 0;
  o.youngs[1] = 179e9, o.poisson[1] = 0.25;
  FrictionalContact contact(o);
  const double a = contact.contact_radius, g1 = 71e9 / 2 / 1.17, g2 = 179e9 / 2 / 1.25;
  const double turning = 16.0 / 3 / (1 / g1 + 1 / g2) * a * a * a, shifting = 8 / (1.83 / g1 + 1.75 / g2) * a;
  const double turned = contact.solver.torsion_stiffness(contact.state);
  const double shifted =
      1 / (1 / contact.solver.lateral_stiffness(contact.state) - contact.lateral_far_field);
  const auto verified = [](const char* what, const char* source) {
    return asperity::test::Verified{"Torsion", what, source};
  };
  EXPECT_TRUE(verified("stiffness of borosilicate on silicon, a/h 18", "16/3 a^3/(1/G1 + 1/G2)")
                  .within(turned, turning, 0.02));
  EXPECT_TRUE(verified("lateral stiffness of borosilicate on silicon, a/h 18", "8 G* a")
                  .within(shifted, shifting, 0.02));
}

TEST(Torsion_other_code, moment_follows_Lubkin_to_full_slip_and_Masing_back) {
  const auto path = asperity::test::reference_table("04_torsion_table_lubkin.csv");
  const auto table = asperity::read_csv(path);
  auto angles = table.numbers("theta*Gt*a^2/(mu*P)"), moments = table.numbers("M/(mu*P*a)");
  angles.insert(angles.begin(), 0), moments.insert(moments.begin(), 0);
  FrictionalContact contact({});
  const double a = contact.contact_radius,
               unit = contact.friction_force / (contact.system.torsion_modulus() * a * a);
  const auto go = [&](double angle) {
    const auto r = contact.spin(angle * unit);
    EXPECT_LT(std::hypot(r.lateral_force[0], r.lateral_force[1]), 1e-2 * contact.friction_force);
    return r.torsion_moment / (contact.friction_force * a);
  };
  for (const double angle : {0.02, 0.08, 0.17, 0.29, 0.64}) {
    const double moment = go(angle), expected = linear_between(angles, moments, angle);
    std::printf("angle %.3f  moment %.5f (%.5f, %+.2f %%)  newton %d cg %d\n", angle, moment, expected,
                100 * (moment / expected - 1), contact.newton, contact.linear);
    char what[64];
    std::snprintf(what, sizeof what, "moment at theta G a^2/(mu P) %.2f, a/h 12", angle);
    EXPECT_TRUE(
        (asperity::test::Verified{"Torsion", what, "Lubkin (1951), solved"}.within(moment, expected, 0.03)));
  }
  const double full = go(1.5);
  EXPECT_TRUE((asperity::test::Verified{"Torsion", "moment of full slip, a/h 12", "3 pi mu P a/16"}.within(
      full, 3 * M_PI / 16, 0.01)));
  // Back: twice the first loading.
  const double back = go(1.5 - 2 * 0.17);
  const double masing = full - 2 * linear_between(angles, moments, 0.17);
  EXPECT_TRUE(
      (asperity::test::Verified{"Torsion", "way back, a/h 12", "Masing's rule on Lubkin (1951)"}.below(
          back - masing, 0.02, "mu P a")));
}

TEST(SlideAndSpin_other_code, spin_lowers_sliding_friction_as_Farkas_found) {
  const auto path = asperity::test::reference_table("04_torsion_table_slide_spin.csv");
  const auto table = asperity::read_csv(path);
  const auto ratios = table.numbers("spin_ratio_omega*a/v"), forces = table.numbers("F/(muP)_Hertz"),
             moments = table.numbers("T/(muPa)_Hertz");
  FrictionalContact contact({});
  const double a = contact.contact_radius;
  asperity::fem::RigidMotion motion;
  for (const double ratio : {0.5, 1.0, 2.0}) {
    // Far along one direction of motion, several times the shift of full slip, the past is forgotten.
    asperity::fem::ContactResultants r;
    for (int step = 0; step < 4; ++step) {
      motion.x += 6e-9, motion.spin += ratio * 6e-9 / a;
      r = contact.step(motion);
    }
    const double force = r.lateral_force[0] / contact.friction_force,
                 moment = r.torsion_moment / (contact.friction_force * a);
    const double force_expected = linear_between(ratios, forces, ratio),
                 moment_expected = linear_between(ratios, moments, ratio);
    std::printf("spin ratio %.1f  force %.4f (%.4f)  moment %.4f (%.4f)  sticking %d\n", ratio, force,
                force_expected, moment, moment_expected, r.sticking);
    const auto verified = [&](const std::string& what) {
      return asperity::test::Verified{"Torsion", what + std::to_string(ratio).substr(0, 3) + ", a/h 12",
                                      "Farkas et al. (2003), quadrature"};
    };
    EXPECT_TRUE(verified("friction force at spin ratio ").within(force, force_expected, 0.03));
    EXPECT_TRUE(verified("friction moment at spin ratio ").within(moment, moment_expected, 0.03));
  }
}

}  // namespace
