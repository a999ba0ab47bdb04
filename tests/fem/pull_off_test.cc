// A smooth elastic sphere that attracts a block: the contact jumps in on approach and is pulled off, between
// DMT's and JKR's limits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/printed.h"
#include "dem_compare/laws/maugis_dugdale.h"
#include "fem/contact/contact_solver.h"
#include "fem/interface/adhesion/dugdale.h"
#include "tests/support/verification.h"

namespace {

using namespace asperity;

/// Attraction that may be left out, so that a contact can be made by pressing: a jump into contact takes a
/// fine mesh many iterations, for the contact then grows by a ring of cells in each.
class SwitchedAttraction : public fem::AdhesionLaw {
 public:
  explicit SwitchedAttraction(const fem::Dugdale& law) : law_(law) {}
  Attraction at(double gap) const override { return is_on ? law_.at(gap) : Attraction{0, 0, 0}; }
  double range() const override { return law_.range(); }
  bool is_on = true;

 private:
  fem::Dugdale law_;
};

/// Sphere and block of equal elastic constants under displacement control; `cells`: spacings in Maugis' unit
/// of contact radius.
struct AdhesiveSphere {
  static constexpr double youngs = 71e9, poisson = 0.17, radius = 8.5e-6, work = 0.1;
  static constexpr double K = 4.0 / 3 * youngs / (2 * (1 - poisson * poisson));  ///< Maugis' modulus
  MaugisDugdale law;
  double unit_radius, unit_approach, range;
  std::shared_ptr<SwitchedAttraction> attraction;
  fem::ContactSystem system;
  fem::ContactSolver solver;
  fem::ContactState state;
  double far_field;

  AdhesiveSphere(double lambda, double cells, double half_ramp)
      : law(maugis(lambda)),
        unit_radius(std::cbrt(M_PI * work * radius * radius / K)),
        unit_approach(unit_radius * unit_radius / radius),
        range(work / law.cohesive_stress),
        attraction(std::make_shared<SwitchedAttraction>(fem::Dugdale(work, range, half_ramp))),
        system(MPI_COMM_WORLD, system_options(cells)),
        solver(system, solver_options()),
        state(solver.first_touch()),
        far_field(solver.far_field_compliance(unit_radius)) {}

  static MaugisDugdale maugis(double lambda) {
    return {0.75 * K, radius, work, 0.5 * lambda * std::cbrt(M_PI * work * K * K / radius)};
  }

  fem::ContactSystemOptions system_options(double cells) const {
    fem::ContactSystemOptions o;
    o.control = fem::Control::displacement;
    for (auto& m : o.materials) m = fem::J2Material::elastic(youngs, poisson);
    auto& s = o.mesh.sizes;
    s.radius = radius, s.block_half_width = 0.7 * radius;
    s.spacing_particle = unit_radius / cells;
    s.spacing_substrate = 1.1 * s.spacing_particle;
    s.offset_substrate_x = 0.37 * s.spacing_particle, s.offset_substrate_y = 0.21 * s.spacing_particle;
    s.region_particle = std::max(
        2 * unit_radius, 1.2 * std::sqrt(2 * radius * range));  // to where a rigid sphere's gap is the range
    s.region_substrate = s.region_particle + 3 * s.spacing_particle;
    return o;
  }
  fem::ContactSolverOptions solver_options() const {
    fem::ContactSolverOptions o;
    o.adhesion.closing = o.adhesion.opening = attraction;
    return o;
  }

  fem::ContactResultants go_to(double approach_in_units) {
    const auto report = solver.solve(state, approach_in_units * unit_approach);
    EXPECT_TRUE(report.converged) << approach_in_units;
    const auto r = solver.resultants(state);
    const double size = attraction->is_on ? r.attraction : r.force;
    EXPECT_NEAR(r.reaction_driven, r.force, 1e-5 * std::max(size, 1e-3 * law.pull_off_force()));
    return r;
  }
  bool touches() const {
    for (const double pressure : state.multiplier)
      if (pressure > 0) return true;
    return false;
  }
  /// Approach of half-spaces, without the finite bodies' own compliance, in Maugis' unit.
  double approach(const fem::ContactResultants& r) const {
    return (state.approach - far_field * r.force) / unit_approach;
  }
};

/// Approach at which the contact forms [Maugis' unit], from Dugdale's stress over a circle of radius c
/// without contact, whose gap at its border is the range (Maugis 1992 at a = 0; Johnson & Greenwood 1997, J.
/// Colloid Interface Sci. 192, 326). Attraction sets in where the gap is the range, and pulls at once to a
/// finite c. That closes the gap in the middle if lambda > (9/32)^(1/3); if not, the middle touches when the
/// approach is the bulge 4/3 lambda c.
double jump_in(double lambda) {
  const double square = M_PI / 4 * lambda, linear = 4.0 / 3 * lambda * lambda * (M_PI / 2 - 1);
  const double c = (-linear + std::sqrt(linear * linear + 4 * square)) / (2 * square);
  const double touch = -4.0 / 3 * lambda * c, onset = -2 / (M_PI * lambda);
  return std::max(touch, onset);
}

void expect_pull_off(double lambda, double cells, double step) {
  AdhesiveSphere s(lambda, cells, fem::Dugdale::usual_half_ramp);
  const double unit = M_PI * s.work * s.radius, expected = s.law.pull_off_force();
  double largest = 0;
  s.go_to(0.98 * jump_in(lambda));  // a jump from far to a pressed contact is a long one
  s.go_to(0.2);
  double tension = 0;
  for (double approach = 0.2 - step;
       s.touches() && (largest == 0 || tension > 0.9 * largest) && approach > -3; approach -= step) {
    tension = -s.go_to(approach).force;
    largest = std::max(largest, tension);
  }
  std::printf("lambda %g: pull-off %.4f (%.4f) pi w R\n", lambda, largest / unit, expected / unit);
  const std::string what = printed("pull-off, lambda %g, %g cells in Maugis' unit", lambda, cells);
  EXPECT_TRUE((test::Verified{"Adhesion", what, "Maugis (1992)"}.within(largest, expected, 0.03)));
}

TEST(PullOff_analytic, follows_Maugis_from_DMT_to_JKR) {
  for (const double lambda : {0.3, 1.0}) expect_pull_off(lambda, 8, 0.1);
}

TEST(PullOffNightly_analytic, follows_Maugis_from_DMT_on_a_finer_mesh) {
  for (const double lambda : {0.1, 0.3, 0.7, 1.0}) expect_pull_off(lambda, 16, 0.05);
}

/// Towards JKR the ring of attraction is narrow and asks for fine cells. A contact made by pressing is led
/// past JKR's approach at pull-off, a^2 - (8a/3)^(1/2) at a^3 = 3/2 in Maugis' units; the tension is flat
/// there. Returns it in units of pi w R.
double expect_pull_off_towards_jkr(double lambda, double cells) {
  constexpr double approach_of_jkr = -0.437;
  AdhesiveSphere s(lambda, cells, fem::Dugdale::usual_half_ramp);
  s.attraction->is_on = false;
  s.go_to(1.6);  // as wide by Hertz as JKR's contact where the way begins
  s.attraction->is_on = true;
  double largest = 0;
  for (const double beyond : {0.09, 0.04, -0.01, -0.06, -0.11}) {
    const double tension = -s.go_to(approach_of_jkr + beyond).force;
    std::printf("  approach %.3f: %.4f\n", approach_of_jkr + beyond, tension / (M_PI * s.work * s.radius)),
        std::fflush(stdout);
    largest = std::max(largest, tension);
  }
  const double expected = s.law.pull_off_force(), unit = M_PI * s.work * s.radius;
  std::printf("lambda %g: pull-off %.4f (%.4f) pi w R\n", lambda, largest / unit, expected / unit);
  const std::string what = printed("pull-off, lambda %g, %g cells in Maugis' unit", lambda, cells);
  EXPECT_TRUE((test::Verified{"Adhesion", what, "Maugis (1992)"}.within(largest, expected, 0.03)));
  return largest / unit;
}

/// Maugis' pull-off at lambda 2, 1.535 pi w R, is JKR's 3/2 but for 2.3 %: the transition is over.
TEST(PullOffNightly_analytic, follows_Maugis_to_within_three_percent_of_JKR_on_a_finer_mesh) {
  const double in_units = expect_pull_off_towards_jkr(2, 20);
  EXPECT_TRUE((test::Verified{"Adhesion", "pull-off against its limit, lambda 2, 20 cells in Maugis' unit",
                              "JKR: 3/2 pi w R"}
                   .within(in_units, 1.5, 0.03)));
}

/// In JKR's limit but for 1.2 %; 12 min on one core.
TEST(PullOffNightly_analytic, is_that_of_JKR_where_attraction_hardly_reaches) {
  const double in_units = expect_pull_off_towards_jkr(3, 40);
  EXPECT_TRUE((test::Verified{"Adhesion", "pull-off against its limit, lambda 3, 40 cells in Maugis' unit",
                              "JKR: 3/2 pi w R"}
                   .within(in_units, 1.5, 0.02)));
}

/// Maugis' contact under a force, in his units: radius a, and radius m a out to which the surfaces attract.
struct MaugisContact {
  double a, m;

  MaugisContact(double lambda, double force) {
    double low = 0.1, high = 10;
    for (int k = 0; k < 60; ++k) {
      a = 0.5 * (low + high), m = reach(lambda, a);
      const double u = std::sqrt(m * m - 1);
      (a * a * a - lambda * a * a * (u + m * m * std::atan(u)) < force ? low : high) = a;
    }
  }
  /// m where the gap at m a is the attraction's range: what is on the right of the law's first equation grows
  /// with it.
  static double reach(double lambda, double a) {
    double low = 1, high = 100;
    for (int k = 0; k < 60; ++k) {
      const double m = 0.5 * (low + high), u = std::sqrt(m * m - 1), t = std::atan(u);
      (0.5 * lambda * a * a * (u + (m * m - 2) * t) + 4.0 / 3 * lambda * lambda * a * (u * t - m + 1) < 1
           ? low
           : high) = m;
    }
    return 0.5 * (low + high);
  }
};

/// The pressure that a sensor between the surfaces would read: contact less attraction. Largest in the
/// middle, by Maugis (1992) 3 a K/(2 pi R) - (2 s0/pi) arctan((m^2 - 1)^(1/2)).
TEST(AdhesivePressure_analytic, the_largest_is_that_of_contact_less_attraction) {
  AdhesiveSphere s(1.0, 8, fem::Dugdale::usual_half_ramp);
  s.go_to(0.98 * jump_in(1.0));
  s.go_to(0.2);
  const auto r = s.go_to(1.0);
  const MaugisContact contact(1.0, r.force / (M_PI * s.work * s.radius));
  const double s0 = s.law.cohesive_stress,
               hertzian = 1.5 * contact.a * s.unit_radius * s.K / (M_PI * s.radius);
  const double expected = hertzian - 2 * s0 / M_PI * std::atan(std::sqrt(contact.m * contact.m - 1));
  std::printf("largest pressure %.4g, Maugis %.4g, attraction %.4g Pa\n", r.largest_pressure, expected, s0);
  EXPECT_TRUE(
      (test::Verified{"Adhesion", "largest pressure, lambda 1, 8 cells in Maugis' unit", "Maugis (1992)"}
           .within(r.largest_pressure, expected, 0.03)));
  EXPECT_GT(s0, 0.2 * expected) << "attraction left out would be seen";
}

/// In steps from `first` on; both of the approach to be found.
void expect_jump_in(double lambda, double cells, double first, double step) {
  AdhesiveSphere s(lambda, cells,
                   0.02);  // an end of the attraction as sharp as Dugdale's: where it begins is the answer
  const double expected = jump_in(lambda);
  double before = 0;
  fem::ContactResultants r;
  for (double share = first; share > 0.88 && !s.touches(); share -= step) {
    before = s.approach(r);
    r = s.go_to(share * expected);
  }
  ASSERT_TRUE(s.touches());
  // Where it jumped the finite bodies had no force on them yet, or the force before the step.
  const double found = 0.5 * (before + s.state.approach / s.unit_approach);
  std::printf("lambda %g: contact forms at %.4f to %.4f (%.4f)\n", lambda, before,
              s.state.approach / s.unit_approach, expected);
  const std::string what = printed("approach at which the contact forms, lambda %g, %g cells", lambda, cells);
  EXPECT_TRUE((test::Verified{"Adhesion", what, "Maugis (1992), Johnson & Greenwood (1997)"}.within(
      found, expected, 0.03)));
}

TEST(JumpIn_analytic, contact_forms_where_Maugis_has_it) {
  for (const double lambda : {0.3, 1.0}) expect_jump_in(lambda, 8, 1.06, 0.01);
}

/// A step that jumps from far to a pressed contact meets indefinite matrices on its way. Directions without
/// the softening of attraction took 74 Newton steps and 1165 of conjugate gradients, those that end where the
/// matrix shows itself indefinite 35 and 106.
TEST(JumpIn_regression, a_jump_from_far_to_a_pressed_contact_takes_few_iterations) {
  for (const double approach : {0.34, 0.37, 0.40, 0.43}) {
    AdhesiveSphere s(2, 12, fem::Dugdale::usual_half_ramp);
    const auto report = s.solver.solve(s.state, approach * s.unit_approach);
    std::printf("jump to %.2f: %d Newton steps, %d of conjugate gradients\n", approach, report.newton,
                report.linear);
    EXPECT_TRUE(report.converged) << approach;
    EXPECT_TRUE(s.touches()) << approach;
    EXPECT_LE(report.newton, 55) << approach;
    EXPECT_LE(report.linear, 300) << approach;
  }
}

TEST(JumpInNightly_analytic, contact_forms_where_Maugis_has_it_from_DMT_to_JKR) {
  for (const double lambda : {0.1, 0.3, 0.5, 0.8, 1.0, 2.0, 3.0}) expect_jump_in(lambda, 12, 1.12, 0.01);
}

}  // namespace
